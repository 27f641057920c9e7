#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include <brouwer/ensemble/observer.hpp>
#include <brouwer/ensemble/operations.hpp>
#include <brouwer/ensemble/processor_time.hpp>
#include <brouwer/ensemble/reference.hpp>
#include <brouwer/ensemble/run.hpp>
#include <brouwer/ensemble/start.hpp>

namespace brouwer {
namespace {

/// What is told to the outside while a unit runs.
class Watch {
 public:
  Watch(Progress& progress, std::atomic<bool> const* stop) : progress_(progress), stop_(stop) {}

  /// Advances, in strides of about 10 to 40 ms, after each of which it looks at the signal and tells the progress; no
  /// influence on the numbers.
  /// @return false if stopped midway
  bool advance(Trajectories& trajectories, std::int64_t steps) {
    using clock = std::chrono::steady_clock;
    while (steps > 0 && !stopped()) {
      std::int64_t const now = std::min(steps, stride_);
      auto const begin = clock::now();
      trajectories.advance(now);
      double const seconds = std::chrono::duration<double>(clock::now() - begin).count();
      if (seconds > 0.04) stride_ = std::max<std::int64_t>(1, stride_ / 2);
      if (seconds < 0.01 && now == stride_) stride_ *= 2;
      steps -= now;
      progress_.steps_done.fetch_add(now * static_cast<std::int64_t>(trajectories.members()),
                                     std::memory_order_relaxed);
    }
    return steps == 0;
  }

 private:
  bool stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }

  Progress& progress_;
  std::atomic<bool> const* stop_;
  std::int64_t stride_ = 16;
};

/// Where members should be: by the exact flow, or by the same method in the reference's arithmetic.
class Comparison {
 public:
  /// @param reference  "exact", or an arithmetic
  Comparison(Catalogue const& catalogue, CellLabels const& cell, std::string const& reference,
             std::vector<Start> const& starts, bool whole_state, InstructionSet widest)
      : exact_(reference == "exact"),
        companion_(begin_trajectories(catalogue,
                                      exact_ ? with_standard_operations(cell) : reference_cell(cell, reference), starts,
                                      whole_state, exact_ ? InstructionSet::none : widest)),
        state_(catalogue.system(cell.system).state_components.size()) {}

  std::size_t members() const { return companion_->members(); }
  std::optional<MemberFailure> failure(std::size_t member) const { return companion_->failure(member); }

  /// @return false if stopped midway
  bool advance(std::int64_t steps, Watch& watch) {
    now_ += steps;
    return exact_ || watch.advance(*companion_, steps);
  }

  /// The state that a member should have now.
  std::span<Widest const> state(std::size_t member) {
    if (exact_)
      companion_->exact_state(member, now_, state_);
    else
      companion_->state(member, state_);
    return state_;
  }

 private:
  bool exact_;
  std::unique_ptr<Trajectories> companion_;
  std::vector<Widest> state_;
  std::int64_t now_ = 0;
};

/// Names of the numbers of some fields: inertia-1, inertia-2 …
std::vector<std::string> parameter_names(SystemDescription const& system) {
  std::vector<std::string> names;
  for (auto const& field : system.fields)
    for (int i = 1; field.parameter && i <= field.size; ++i)
      names.push_back(field.size == 1 ? field.name : field.name + "-" + std::to_string(i));
  return names;
}

/// A unit in work: its members side by side, from sample to sample.
class UnitWork {
 public:
  UnitWork(Study const& study, Catalogue const& catalogue, Plan const& plan, Unit const& unit, InstructionSet widest,
           Watch watch)
      : study_(study),
        catalogue_(catalogue),
        system_(catalogue.system(study.system)),
        cell_(plan.cells[unit.cell]),
        reference_(plan.references[unit.cell]),
        unit_(unit),
        widest_(widest),
        watch_(watch),
        samples_(sample_steps(study.samples, cell_.steps)),
        observer_(system_, study.quantities, members_of(study, catalogue.method(cell_.system, cell_.method), unit),
                  samples_.size()) {}

  UnitOutcome run(std::string const& hash) {
    auto const starts = member_starts(study_, system_, cell_.arithmetic, unit_.first_member, unit_.members);
    auto const trajectories = begin_trajectories(catalogue_, cell_, starts, observer_.needs_whole_state(), widest_,
                                                 {study_.seed, unit_.first_member});
    UnitRecord record = labelled(hash);
    if (!observe_along(*trajectories, starts, record)) return {};
    for (auto const& start : starts) {
      record.start.insert(record.start.end(), start.parameters.begin(), start.parameters.end());
      record.start.insert(record.start.end(), start.state.begin(), start.state.end());
    }
    put_final_states(*trajectories, record);
    put_failures(*trajectories, record);
    record.series = observer_.take_series();
    return {true, std::move(record), seconds_};
  }

 private:
  UnitRecord labelled(std::string const& hash) const {
    UnitRecord record;
    record.study_hash = hash;
    record.cell = cell_;
    record.reference = reference_;
    record.first_member = unit_.first_member;
    record.members = unit_.members;
    record.sample_steps = samples_;
    record.start_names = parameter_names(system_);
    record.start_names.insert(record.start_names.end(), system_.state_components.begin(),
                              system_.state_components.end());
    record.state_names = integrated_components();
    return record;
  }

  static Observer::Members members_of(Study const& study, MethodEntry const& method, Unit const& unit) {
    return {unit.members, compared_members(study, unit), method.counts_iterations ? unit.members : 0};
  }

  /// A member's state now, rounded to double, as far as it is integrated.
  template <class Out>
  Out put_state(Trajectories const& trajectories, std::size_t member, Out out) const {
    std::vector<Widest> now(system_.state_components.size());
    trajectories.state(member, now);
    return std::transform(now.begin(), now.begin() + std::ssize(integrated_components()), out,
                          [](Widest const& v) { return static_cast<double>(v); });
  }

  void put_final_states(Trajectories const& trajectories, UnitRecord& record) const {
    for (std::size_t i = 0; i < trajectories.members(); ++i)
      put_state(trajectories, i, std::back_inserter(record.final_state));
  }

  /// [member][sample][component]
  void put_states(Trajectories const& trajectories, std::size_t sample, UnitRecord& record) const {
    std::size_t const size = record.state_names.size();
    record.states.resize(trajectories.members() * samples_.size() * size);
    for (std::size_t i = 0; i < trajectories.members(); ++i)
      put_state(trajectories, i, record.states.begin() + std::ptrdiff_t((i * samples_.size() + sample) * size));
  }

  /// A failed reference is no failure of the member: it costs what was compared with it.
  void put_failures(Trajectories const& trajectories, UnitRecord& record) const {
    record.failed_at.assign(trajectories.members(), -1);
    record.failure.assign(trajectories.members(), "");
    for (std::size_t i = 0; i < trajectories.members(); ++i)
      if (auto const own = trajectories.failure(i)) {
        record.failed_at[i] = own->step;
        record.failure[i] = in_words(own->reason);
      } else if (auto const its = comparison_ && i < comparison_->members() ? comparison_->failure(i) : std::nullopt) {
        record.failure[i] = fmt::format("its reference failed after step {} ({})", its->step, in_words(its->reason));
      }
  }

  /// The components of the state that are integrated in this unit.
  std::vector<std::string> integrated_components() const {
    auto names = system_.state_components;
    if (!observer_.needs_whole_state()) names.resize(system_.always_integrated);
    return names;
  }

  /// false if stopped midway
  bool observe_along(Trajectories& trajectories, std::vector<Start> const& starts, UnitRecord& record) {
    comparison_ = begin_comparison(starts);
    std::int64_t now = 0;
    for (std::size_t j = 0; j < samples_.size(); ++j) {
      std::int64_t const steps = samples_[j] - now;
      now = samples_[j];
      double const begin = processor_seconds();
      if (!watch_.advance(trajectories, steps)) return false;
      seconds_ += processor_seconds() - begin;
      if (comparison_ && !comparison_->advance(steps, watch_)) return false;
      observer_.observe(trajectories, j, now);
      if (study_.states) put_states(trajectories, j, record);
      for (std::size_t i = 0; comparison_ && i < comparison_->members(); ++i) {
        if (comparison_->failure(i)) observer_.lose_reference(i);
        observer_.observe_state(trajectories, i, comparison_->state(i), j);
      }
    }
    return true;
  }

  /// Of the unit's first members; nothing where none is compared.
  std::unique_ptr<Comparison> begin_comparison(std::vector<Start> starts) const {
    starts.resize(static_cast<std::size_t>(compared_members(study_, unit_)));
    if (starts.empty() || !observer_.needs_reference()) return nullptr;
    return std::make_unique<Comparison>(catalogue_, cell_, reference_, starts, observer_.needs_whole_state(), widest_);
  }

  Study const& study_;
  Catalogue const& catalogue_;
  SystemDescription const& system_;
  CellLabels const& cell_;
  std::string const& reference_;
  Unit unit_;
  InstructionSet widest_;
  Watch watch_;
  std::vector<std::int64_t> samples_;
  Observer observer_;
  std::unique_ptr<Comparison> comparison_;
  double seconds_ = 0;
};

}  // namespace

UnitOutcome compute_unit(Study const& study, Catalogue const& catalogue, Plan const& plan, Unit const& unit,
                         std::string const& hash, Progress& progress, std::atomic<bool> const* stop,
                         InstructionSet widest) {
  return UnitWork(study, catalogue, plan, unit, widest, {progress, stop}).run(hash);
}

}  // namespace brouwer
