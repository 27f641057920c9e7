// What the processor can do in an instruction set, alone and with a second thread beside it.
#include <benchmark/benchmark.h>

#include "tests/benchmarks/registered.hpp"

namespace brouwer::benchmarks {

std::string name_of(Mix mix, InstructionSet set, std::string const& arithmetic) {
  return "peak/" + name_of(mix) + "/" + arithmetic + "/" + name_of(set);
}

void register_peak(Mix mix, InstructionSet set, std::string const& arithmetic, int threads) {
  PeakLoop const loop(mix, set, arithmetic);
  auto const run = [loop](benchmark::State& state) {
    constexpr std::int64_t turns = 10'000;
    for (auto _ : state) loop.run(turns);
    state.counters[counter_rate] =
        benchmark::Counter(static_cast<double>(state.iterations() * turns) * loop.operations_per_turn() * 1e-9,
                           benchmark::Counter::kIsRate);
  };
  auto* const registered = benchmark::RegisterBenchmark(name_of(mix, set, arithmetic).c_str(), run);
  if (threads > 1) registered->Threads(threads)->UseRealTime();
}

}  // namespace brouwer::benchmarks
