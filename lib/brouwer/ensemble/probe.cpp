#include <brouwer/ensemble/probe.hpp>

#include <Random123/philox.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <brouwer/ensemble/first_failure.hpp>
#include <brouwer/ensemble/observer.hpp>
#include <brouwer/ensemble/processor_time.hpp>
#include <brouwer/ensemble/reference.hpp>
#include <brouwer/ensemble/start.hpp>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <brouwer/store/failures.hpp>

namespace brouwer {
namespace {

/// Members that walk side by side: a pack of each instruction set, and little enough for threads to share the work.
constexpr std::int64_t block_size = 16;
constexpr std::int64_t least_length = 4;

/// A window of one member, and what was seen in it.
struct Window {
  std::size_t member = 0;                        ///< of the block
  std::int64_t number = 0;                       ///< of the member's windows
  std::int64_t begin = 0;                        ///< step
  std::vector<std::vector<double>> errors = {};  ///< of the first integrals before its first step, …, after its last
  std::vector<std::vector<Widest>> states = {};  ///< before its first step, …, after the last that is judged
};

/// What a component's numbers are in the lists that trajectories give.
struct Component {
  Quantity const* quantity;
  std::string name;
  std::size_t place;  ///< among the components of its kind; those of `rounding` stand as those of `integral`
};

std::vector<Component> components_of(SystemDescription const& system, Study const& study) {
  std::vector<Component> components;
  for (auto const& name : study.quantities) {
    std::map<Quantity::Kind, std::size_t> place;
    for (auto const& quantity : system.quantities)
      for (auto const& component : quantity.components) {
        std::size_t const here = place[quantity.kind]++;
        if (quantity.name == name && quantity.kind != Quantity::Kind::iterations)
          components.push_back({&quantity, component, here});
      }
  }
  return components;
}

/// A number of any arithmetic that judge_of accepts, as the sum of two doubles: exact.
void split(Widest const& x, double& high, double& low) {
  high = static_cast<double>(x);
  low = static_cast<double>(Widest(x - high));
}

Start start_from(std::vector<Widest> const& state, std::vector<double> const& parameters) {
  Start start{parameters, std::vector<double>(state.size()), std::vector<double>(state.size())};
  for (std::size_t n = 0; n < state.size(); ++n) split(state[n], start.state[n], start.state_rest[n]);
  return start;
}

/// The numbers of one component: members × steps.
struct Columns {
  ErrorMatrix change;                ///< by the working steps, of a first integral; all of the windows
  ErrorMatrix since_start;           ///< after the last step of each window
  ErrorMatrix rounding, truncation;  ///< of the judged steps
};

/// One cell under the probe.
class CellProbe {
 public:
  /// @param judged  steps of each window that are made in high precision, too
  CellProbe(Study const& study, Catalogue const& catalogue, CellLabels const& cell, ProbeDesign const& design,
            std::int64_t judged, InstructionSet widest)
      : study_(study),
        catalogue_(catalogue),
        system_(catalogue.system(study.system)),
        cell_(cell),
        judge_(reference_cell(cell, judge_of(catalogue, cell))),
        design_(design),
        judged_(judged),
        widest_(widest),
        whole_state_(Observer(system_, study.quantities, {}, 1).needs_whole_state()),
        components_(components_of(system_, study)),
        compares_states_(
            std::any_of(components_.begin(), components_.end(),
                        [](auto const& component) { return component.quantity->kind == Quantity::Kind::state; })),
        fates_(static_cast<std::size_t>(design.members)) {
    ErrorMatrix const steps(design.members, design.steps()), some(design.members, design.windows * judged),
        windows(design.members, design.windows);
    columns_.assign(components_.size(), {steps, windows, some, some});
  }

  /// Walks the members from `first`; writes what belongs to them and nothing else.
  void walk(std::int64_t first) {
    std::int64_t const count = std::min(block_size, design_.members - first);
    auto const starts = member_starts(study_, system_, cell_.arithmetic, first, count);
    auto const trajectories =
        begin_trajectories(catalogue_, cell_, starts, whole_state_, widest_, {study_.seed, first});
    auto const windows = recorded(*trajectories, windows_of(first, count));
    for (auto const& window : windows) put_changes(first, window);
    judge(first, windows, starts);
    for (std::size_t i = 0; i < trajectories->members(); ++i)
      if (auto const failure = trajectories->failure(i)) fate(first, i) = {failure->step, in_words(failure->reason)};
  }

  /// Is what the working steps change their rounding error, to 2⁻¹⁶ of its size?
  bool conserves() const {
    for (std::size_t c = 0; c < components_.size(); ++c)
      if (!is_of_state(c) && !conserved(columns_[c])) return false;
    return true;
  }

  std::vector<LocalErrors> take_errors() {
    std::vector<LocalErrors> all;
    for (std::size_t c = 0; c < components_.size(); ++c) all.push_back(errors_of(c));
    return all;
  }

 private:
  bool is_of_state(std::size_t c) const { return components_[c].quantity->kind == Quantity::Kind::state; }

  /// Neither the high-precision steps change it, nor is it lost that the errors since the start, of which the changes are
  /// differences, were rounded to double. What the high-precision steps round is no change.
  bool conserved(Columns const& columns) const {
    double const rounding = std::sqrt(columns.change.array().square().mean());
    double const noise = std::ldexp(1, 14 - catalogue_.arithmetic(judge_.arithmetic).bits);
    double const largest = columns.truncation.cwiseAbs().maxCoeff();
    double const since_start = 0x1p-53 * columns.since_start.cwiseAbs().maxCoeff();
    return std::max(largest, since_start) <= std::max(0x1p-16 * rounding, noise);
  }

  std::vector<Window> windows_of(std::int64_t first, std::int64_t count) const {
    std::vector<Window> windows;
    for (std::int64_t i = 0; i < count; ++i)
      for (std::int64_t w = 0; w < design_.windows; ++w)
        windows.push_back({static_cast<std::size_t>(i), w, window_begin(design_, study_.seed, first + i, w)});
    return windows;
  }

  /// What is seen in the windows on one walk through all of them.
  std::vector<Window> recorded(Trajectories& trajectories, std::vector<Window> windows) const {
    std::size_t const integrals = system_.count(Quantity::Kind::integral);
    std::vector<double> errors(integrals * trajectories.members());
    for (std::int64_t now = 0;;) {
      std::int64_t next = design_.covered;  // the nearest step at which a window is open
      bool observed = false;
      for (auto& window : windows) {
        std::int64_t const end = window.begin + design_.length;
        if (now < end) next = std::min(next, std::max(window.begin, now + 1));
        if (now < window.begin || now > end) continue;
        if (!observed) trajectories.first_integral_errors(errors);
        observed = true;
        look(trajectories, std::span(errors).subspan(window.member * integrals, integrals), window);
      }
      if (now == design_.covered) return windows;
      trajectories.advance(next - now);
      now = next;
    }
  }

  void look(Trajectories const& trajectories, std::span<double const> errors, Window& window) const {
    window.errors.emplace_back(errors.begin(), errors.end());
    if (std::ssize(window.states) > judged_) return;
    window.states.emplace_back(system_.state_components.size());
    trajectories.state(window.member, window.states.back());
  }

  void put_changes(std::int64_t first, Window const& window) {
    for (std::size_t c = 0; c < components_.size(); ++c) {
      if (is_of_state(c)) continue;
      std::size_t const place = components_[c].place;
      columns_[c].since_start(row(first, window), window.number) = window.errors.back()[place];
      for (std::size_t l = 0; l + 1 < window.errors.size(); ++l)
        columns_[c].change(row(first, window), window.number * design_.length + static_cast<Eigen::Index>(l)) =
            window.errors[l + 1][place] - window.errors[l][place];
    }
  }

  /// High-precision steps from the states in the windows.
  void judge(std::int64_t first, std::vector<Window> const& windows, std::vector<Start> const& members) {
    std::vector<Start> starts;
    for (auto const& window : windows)
      for (std::size_t l = 0; l + 1 < window.states.size(); ++l)
        starts.push_back(start_from(window.states[l], members[window.member].parameters));
    auto const steps = begin_trajectories(catalogue_, judge_, starts, whole_state_, widest_);
    steps->advance(1);
    std::vector<double> truncation(system_.count(Quantity::Kind::integral) * starts.size());
    steps->first_integral_errors(truncation);
    std::size_t at = 0;
    for (auto const& window : windows)
      for (std::size_t l = 0; l + 1 < window.states.size(); ++l, ++at)
        put_judgement(first, window, l, *steps, at, truncation);
  }

  void put_judgement(std::int64_t first, Window const& window, std::size_t l, Trajectories const& steps, std::size_t at,
                     std::vector<double> const& truncation) {
    std::vector<double> rounding(system_.count(Quantity::Kind::integral)), state(system_.count(Quantity::Kind::state));
    steps.rounding_errors(at, window.states[l + 1], rounding);
    if (compares_states_) steps.state_errors(at, window.states[l + 1], state);
    auto const column = window.number * judged_ + static_cast<Eigen::Index>(l);
    for (std::size_t c = 0; c < components_.size(); ++c) {
      std::size_t const place = components_[c].place;
      // minus: the trajectories judge the high-precision step by the working one
      columns_[c].rounding(row(first, window), column) = -(is_of_state(c) ? state : rounding)[place];
      columns_[c].truncation(row(first, window), column) =
          is_of_state(c) ? 0 : truncation[at * rounding.size() + place];
    }
    if (auto const failure = steps.failure(at))
      fate(first, window.member).reason = fmt::format("its high-precision step failed ({})", in_words(failure->reason));
  }

  static Eigen::Index row(std::int64_t first, Window const& window) {
    return first + static_cast<Eigen::Index>(window.member);
  }
  Fate& fate(std::int64_t first, std::size_t member) { return fates_[static_cast<std::size_t>(first) + member]; }

  LocalErrors errors_of(std::size_t c) const {
    auto const& quantity = *components_[c].quantity;
    LocalErrors errors{cell_,          judge_.arithmetic, components_[c].name, quantity.name, quantity.unit,
                       is_of_state(c), design_.windows,   design_.length,      judged_,       design_.covered};
    bool const all_judged = judged_ == design_.length || is_of_state(c);
    auto const& rounding = all_judged ? columns_[c].rounding : columns_[c].change;
    ErrorMatrix both(design_.members, rounding.cols() + columns_[c].truncation.cols());
    both << rounding, columns_[c].truncation;
    std::vector<std::string> nameless(fates_.size());  // members of a probe have no names
    errors.failures = drop_failed(both, fates_, nameless);
    errors.failed = design_.members - both.rows();
    errors.rounding = both.leftCols(rounding.cols());
    if (quantity.kind == Quantity::Kind::integral) errors.truncation = both.rightCols(columns_[c].truncation.cols());
    return errors;
  }

  Study const& study_;
  Catalogue const& catalogue_;
  SystemDescription const& system_;
  CellLabels cell_, judge_;
  ProbeDesign design_;
  std::int64_t judged_;
  InstructionSet widest_;
  bool whole_state_;
  std::vector<Component> components_;
  bool compares_states_;
  std::vector<Fate> fates_;       // of each member
  std::vector<Columns> columns_;  // of each component
};

/// All members, over threads. @return processor seconds
double walk_all(CellProbe& cell_probe, ProbeDesign const& design, RunOptions const& options) {
  double seconds = 0;
  FirstFailure failure;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads_of(options)) reduction(+ : seconds)
  for (std::int64_t first = 0; first < design.members; first += block_size) {
    try {
      double const begin = processor_seconds();
      cell_probe.walk(first);
      seconds += processor_seconds() - begin;
    } catch (...) {
      failure.keep_current();
    }
  }
  failure.rethrow();
  return seconds;
}

}  // namespace

ProbeDesign fitted(ProbeDesign design, Study const& study, CellLabels const& cell) {
  design.members = std::min(design.members, study.members);
  design.covered = std::min(std::max(design.covered, design.steps()), cell.steps);
  design.length = std::min(design.length, design.covered / design.windows) / least_length * least_length;
  return design;
}

std::int64_t window_begin(ProbeDesign const& design, std::uint64_t seed, std::int64_t member, std::int64_t window) {
  r123::Philox4x64 const philox;
  constexpr std::uint64_t of_windows = 1;  // member_start has the numbers with 0 there
  auto const bits =
      philox({{static_cast<std::uint64_t>(window), 0, 0, of_windows}}, {{seed, static_cast<std::uint64_t>(member)}});
  std::int64_t const part = design.covered / design.windows;
  auto const places = static_cast<std::uint64_t>(part - design.length + 1);
  return window * part + static_cast<std::int64_t>(bits[0] % places);
}

std::string judge_of(Catalogue const& catalogue, CellLabels const& cell) {
  int const bits = catalogue.arithmetic(cell.arithmetic).bits;
  if (bits <= 64) return "double-double";
  return bits <= 106 && !cell.compensation ? "mpfr-256" : "";
}

std::string reason_not_to_probe(Study const& study, Catalogue const& catalogue, CellLabels const& cell,
                                ProbeDesign const& design) {
  if (judge_of(catalogue, cell).empty())
    return fmt::format(
        "{} in {}{} is not probed: a high-precision step begins from two doubles, which do not hold such a "
        "state",
        cell.method, cell.compensation ? "compensated " : "", cell.arithmetic);
  if (fitted(design, study, cell).members < 2)
    return "a probe compares members with one another: expected at least 2, found 1";
  if (fitted(design, study, cell).length < least_length)
    return fmt::format("{} is not probed: {} windows of {} steps do not fit into {} steps", cell.method, design.windows,
                       least_length, cell.steps);
  return "";
}

Probe probe(Study const& study, Catalogue const& catalogue, CellLabels const& cell, ProbeDesign const& design,
            RunOptions const& options) {
  if (auto const reason = reason_not_to_probe(study, catalogue, cell, design); !reason.empty())
    throw InputError(reason);
  Probe found{{}, fitted(design, study, cell)};
  for (std::int64_t const judged : {std::int64_t{1}, found.design.length}) {
    CellProbe cell_probe(study, catalogue, cell, found.design, judged, options.widest);
    found.seconds += walk_all(cell_probe, found.design, options);
    found.errors = cell_probe.take_errors();
    if (cell_probe.conserves()) break;
  }
  return found;
}

}  // namespace brouwer
