// What a step costs, as `brouwer run` makes it: through the catalogue's makers, in work units of 64 members.
#include <benchmark/benchmark.h>

#include <mutex>

#include "tests/benchmarks/registered.hpp"

namespace brouwer::benchmarks {
namespace {

using Counter = benchmark::Counter;

/// Counted when first asked for.
class CostOfKernel {
 public:
  CostOfKernel(std::shared_ptr<Catalogue const> catalogue, Kernel kernel)
      : catalogue_(std::move(catalogue)), kernel_(std::move(kernel)) {}

  std::optional<StepCost> const& operator()() {
    std::call_once(counted_, [this] { cost_ = count_step(*catalogue_, kernel_); });
    return cost_;
  }

 private:
  std::shared_ptr<Catalogue const> catalogue_;
  Kernel kernel_;
  std::once_flag counted_;
  std::optional<StepCost> cost_;
};

/// The peak is measured right after the steps, because the clock drifts.
void report_share_of_peak(benchmark::State& state, Kernel const& kernel, StepCost const& cost, double member_steps) {
  Peak const peak(kernel.set, kernel.cell.arithmetic);
  auto const share = [&](double nanoseconds) {
    return Counter(member_steps * nanoseconds * 1e-9, Counter::kIsRate | Counter::kAvgThreads);
  };
  state.counters[counter_flops] = Counter(cost.flops, Counter::kAvgThreads);
  state.counters[counter_peak] = share(cost.flops / peak.multiply_and_add);
  state.counters[counter_adders] = share(peak.adders(cost));
  state.counters[counter_multipliers] = share(peak.multipliers(cost));
  state.counters[counter_divider] = share(peak.divider(cost));
}

}  // namespace

void register_kernel(std::shared_ptr<Catalogue const> const& catalogue, Kernel const& kernel, int threads) {
  auto const cost = std::make_shared<CostOfKernel>(catalogue, kernel);
  auto const run = [=](benchmark::State& state) {
    auto const unit = begin_trajectories(*catalogue, kernel.cell, starts_of_members(*catalogue, kernel.cell.system),
                                         kernel.whole_state, kernel.set);
    for (auto _ : state) unit->advance(kernel.cell.steps);
    auto const member_steps = static_cast<double>(state.iterations() * kernel.cell.steps * members);
    state.counters[counter_time] = Counter(member_steps * 1e-9, Counter::kIsRate | Counter::kInvert);
    if (auto const& counted = (*cost)()) report_share_of_peak(state, kernel, *counted, member_steps);
  };
  auto* const registered = benchmark::RegisterBenchmark(name_of(kernel).c_str(), run);
  if (threads > 1) registered->Threads(threads)->UseRealTime()->MinTime(0.1);  // by the wall: longer, or noise decides
}

}  // namespace brouwer::benchmarks
