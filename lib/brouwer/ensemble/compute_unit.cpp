#include <algorithm>

#include <brouwer/ensemble/observer.hpp>
#include <brouwer/ensemble/run.hpp>
#include <brouwer/ensemble/start.hpp>

namespace brouwer {
namespace {

/// Steps between two looks at the clock, the signal and the progress; no influence on the numbers.
constexpr std::int64_t stride = 4096;

/// What is told to the outside while a unit runs.
struct Watch {
  Progress& progress;
  std::atomic<bool> const* stop;
  bool stopped() const { return stop != nullptr && stop->load(std::memory_order_relaxed); }
};

/// Advances, in strides; false if stopped midway.
bool advance_watched(Trajectory& trajectory, std::int64_t steps, Watch const& watch) {
  while (steps > 0 && !watch.stopped()) {
    std::int64_t const now = std::min(steps, stride);
    trajectory.advance(now);
    steps -= now;
    watch.progress.steps_done.fetch_add(now, std::memory_order_relaxed);
  }
  return steps == 0;
}

/// Where a member should be: by the exact flow, or by the same method in the reference's arithmetic.
class Comparison {
 public:
  Comparison(Study const& study, Catalogue const& catalogue, CellLabels cell, Start const& start, bool attitude)
      : kind_(study.reference.kind), state_(catalogue.system(study.system).state_components.size()) {
    if (kind_ != Reference::Kind::same_method) return;
    cell.step = rounded_to(cell.arithmetic, cell.step);
    cell.arithmetic = study.reference.arithmetic;
    if (!variant_exists(cell.special_functions, cell.arithmetic)) cell.special_functions = "own";
    companion_ = begin_trajectory(catalogue, cell, start, attitude);
  }

  /// The state that `member` should have at step `now`, `steps` after the last call; false if stopped midway.
  bool move_to(Trajectory const& member, std::int64_t now, std::int64_t steps, Watch const& watch) {
    if (kind_ == Reference::Kind::exact) {
      member.exact_state(now, state_);
      return true;
    }
    if (!advance_watched(*companion_, steps, watch)) return false;
    companion_->state(state_);
    return true;
  }

  std::span<Widest const> state() const { return state_; }

 private:
  Reference::Kind kind_;
  std::vector<Widest> state_;
  std::unique_ptr<Trajectory> companion_;
};

/// Names of the numbers of some fields: inertia-1, inertia-2 …
std::vector<std::string> parameter_names(SystemDescription const& system) {
  std::vector<std::string> names;
  for (auto const& field : system.fields)
    for (int i = 1; field.parameter && i <= field.size; ++i)
      names.push_back(field.size == 1 ? field.name : field.name + "-" + std::to_string(i));
  return names;
}

/// A unit in work: the loop over its members and their samples.
class UnitWork {
 public:
  UnitWork(Study const& study, Catalogue const& catalogue, CellLabels const& cell, Unit const& unit, Watch watch)
      : study_(study),
        catalogue_(catalogue),
        system_(catalogue.system(study.system)),
        cell_(cell),
        unit_(unit),
        watch_(watch),
        samples_(sample_steps(study.samples, cell.steps)),
        observer_(system_, study.quantities, unit.members, compared_members(study, unit), samples_.size()) {}

  UnitOutcome run(std::string const& hash) {
    UnitRecord record;
    record.study_hash = hash;
    record.cell = cell_;
    record.first_member = unit_.first_member;
    record.members = unit_.members;
    record.sample_steps = samples_;
    record.start_names = parameter_names(system_);
    record.start_names.insert(record.start_names.end(), system_.state_components.begin(),
                              system_.state_components.end());
    record.state_names = integrated_components();
    for (std::int64_t i = 0; i < unit_.members; ++i)
      if (!run_member(i, record)) return {};
    record.series = observer_.take_series();
    return {true, std::move(record)};
  }

 private:
  bool run_member(std::int64_t i, UnitRecord& record) {
    auto const start = rounded_to(cell_.arithmetic, member_start(study_, system_, unit_.first_member + i));
    record.start.insert(record.start.end(), start.parameters.begin(), start.parameters.end());
    record.start.insert(record.start.end(), start.state.begin(), start.state.end());
    auto const trajectory = begin_trajectory(catalogue_, cell_, start, observer_.needs_attitude());
    if (!observe_along(*trajectory, start, i)) return false;

    std::vector<Widest> last(system_.state_components.size());
    trajectory->state(last);
    auto const end = last.begin() + std::ssize(record.state_names);
    std::transform(last.begin(), end, std::back_inserter(record.final_state),
                   [](Widest const& v) { return static_cast<double>(v); });
    return true;
  }

  /// The components of the state that are integrated in this unit.
  std::vector<std::string> integrated_components() const {
    auto names = system_.state_components;
    if (!observer_.needs_attitude()) names.resize(system_.always_integrated);
    return names;
  }

  /// false if stopped midway
  bool observe_along(Trajectory& trajectory, Start const& start, std::int64_t i) {
    std::unique_ptr<Comparison> comparison;
    if (observer_.needs_reference() && i < compared_members(study_, unit_))
      comparison = std::make_unique<Comparison>(study_, catalogue_, cell_, start, observer_.needs_attitude());
    std::int64_t now = 0;
    for (std::size_t j = 0; j < samples_.size(); ++j) {
      std::int64_t const steps = samples_[j] - now;
      now = samples_[j];
      if (!advance_watched(trajectory, steps, watch_)) return false;
      if (comparison && !comparison->move_to(trajectory, now, steps, watch_)) return false;
      auto const reference = comparison ? comparison->state() : std::span<Widest const>();
      if (!observer_.observe(trajectory, reference, i, j)) break;  // the member has failed; the others go on
    }
    return true;
  }

  Study const& study_;
  Catalogue const& catalogue_;
  SystemDescription const& system_;
  CellLabels cell_;
  Unit unit_;
  Watch watch_;
  std::vector<std::int64_t> samples_;
  Observer observer_;
};

}  // namespace

UnitOutcome compute_unit(Study const& study, Catalogue const& catalogue, Plan const& plan, Unit const& unit,
                         std::string const& hash, Progress& progress, std::atomic<bool> const* stop) {
  return UnitWork(study, catalogue, plan.cells[unit.cell], unit, {progress, stop}).run(hash);
}

}  // namespace brouwer
