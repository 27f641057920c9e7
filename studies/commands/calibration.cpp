#include "studies/commands/calibration.hpp"

#include <algorithm>
#include <brouwer/ensemble/observer.hpp>
#include <brouwer/ensemble/reference.hpp>
#include <brouwer/ensemble/start.hpp>
#include <chrono>

namespace brouwer {
namespace {

/// As many members as a unit has at least.
constexpr std::int64_t most_members = 64;
/// A measurement that has taken so long is not made twice as long.
constexpr double enough_seconds = 0.02;

template <class Work>
double seconds_of(Work work) {
  auto const begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Seconds of work(n) for n = 1; n is doubled, up to `most`, until the work can be measured.
template <class Work>
double seconds_per(Work work, std::int64_t most) {
  for (std::int64_t n = 1;; n = std::min(2 * n, most)) {
    double const seconds = seconds_of([&] { work(n); });
    if (seconds > enough_seconds || n == most) return seconds / static_cast<double>(n);
  }
}

/// A block of members that can be measured.
class Block {
 public:
  Block(Study const& study, Catalogue const& catalogue, CellLabels const& own, CellLabels const& cell,
        std::int64_t members, InstructionSet widest)
      : steps_(cell.steps) {
    auto const& system = catalogue.system(study.system);
    Observer const observer(system, study.quantities, {}, 1);
    auto const starts = member_starts(study, system, own.arithmetic, 0, std::min(members, most_members));
    members_ = static_cast<double>(starts.size());
    costs_.begin = seconds_of(
        [&] { trajectories_ = begin_trajectories(catalogue, cell, starts, observer.needs_whole_state(), widest); });
    state_.resize(system.state_components.size());
    integral_errors_.resize(system.count(Quantity::Kind::integral) * starts.size());
    state_errors_.resize(system.count(Quantity::Kind::state));
  }

  void measure_steps() {
    costs_.step = seconds_per([this](std::int64_t n) { trajectories_->advance(n); }, steps_);
  }
  void measure_integrals() {
    measure_samples([this] { trajectories_->first_integral_errors(integral_errors_); });
  }
  /// @param exact  the reference is the exact flow, not these trajectories
  void measure_comparison(bool exact) {
    measure_samples([this, exact] {
      for (std::size_t i = 0; i < trajectories_->members(); ++i) {
        if (exact)
          trajectories_->exact_state(i, steps_, state_);
        else
          trajectories_->state(i, state_);
        trajectories_->state_errors(i, state_, state_errors_);
      }
    });
  }

  Costs of_one_member() const { return {costs_.begin / members_, costs_.step / members_, costs_.sample / members_}; }

 private:
  template <class Look>
  void measure_samples(Look look) {
    costs_.sample = seconds_per(
        [&](std::int64_t n) {
          for (std::int64_t i = 0; i < n; ++i) look();
        },
        1000);
  }

  std::int64_t steps_;
  double members_ = 0;
  std::unique_ptr<Trajectories> trajectories_;
  std::vector<Widest> state_;
  std::vector<double> integral_errors_, state_errors_;
  Costs costs_;
};

CellCosts measured_here(Study const& study, Catalogue const& catalogue, CellLabels const& cell, InstructionSet widest) {
  CellCosts costs;
  Block block(study, catalogue, cell, cell, study.members, widest);
  block.measure_steps();
  block.measure_integrals();
  costs.member = block.of_one_member();
  if (study.reference.members == 0 || !needs_reference(study, catalogue)) return costs;
  bool const exact = study.reference.kind == Reference::Kind::exact;
  Block reference(study, catalogue, cell, exact ? cell : reference_cell(cell, study.reference.arithmetic),
                  study.reference.members, exact ? InstructionSet::none : widest);
  if (!exact) reference.measure_steps();
  reference.measure_comparison(exact);
  costs.reference = reference.of_one_member();
  return costs;
}

}  // namespace

double CellCosts::seconds(Study const& study, CellLabels const& cell) const {
  auto const of = [&](Costs const& costs, std::int64_t members) {
    return static_cast<double>(members) * (costs.begin + static_cast<double>(cell.steps) * costs.step +
                                           static_cast<double>(study.samples.count) * costs.sample);
  };
  return of(member, study.members) + of(reference, study.reference.members);
}

CellCosts calibrate(Study const& study, Catalogue const& catalogue, CellLabels const& cell, RunOptions const& options) {
  int const threads = threads_of(options);
  std::vector<CellCosts> each(static_cast<std::size_t>(threads));
#pragma omp parallel for schedule(static, 1) num_threads(threads)
  for (int i = 0; i < threads; ++i)
    each[static_cast<std::size_t>(i)] = measured_here(study, catalogue, cell, options.widest);
  // the quickest had the least of other programs' noise, the slowest the most: the middle
  std::nth_element(each.begin(), each.begin() + threads / 2, each.end(),
                   [](auto const& a, auto const& b) { return a.member.step < b.member.step; });
  return each[static_cast<std::size_t>(threads / 2)];
}

}  // namespace brouwer
