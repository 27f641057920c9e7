#include <brouwer/ensemble/reference.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <brouwer/ensemble/operations.hpp>

namespace brouwer {
namespace {

constexpr char const* judge = "mpfr-256";

/// Long enough for errors to have grown, and a matter of some tenths of a second.
constexpr std::int64_t most_steps = 1000, most_members = 2;

/// The study's samples up to the end of the check, and that end.
std::vector<std::int64_t> checked_samples(Study const& study, CellLabels const& cell) {
  std::int64_t const end = std::min(cell.steps, most_steps);
  auto samples = sample_steps(study.samples, cell.steps);
  std::erase_if(samples, [&](std::int64_t step) { return step >= end; });
  samples.push_back(end);
  return samples;
}

double largest(std::vector<double> const& errors) {
  double size = 0;
  for (double e : errors) size = std::isfinite(e) ? std::max(size, std::abs(e)) : e;
  return size;
}

/// The trajectories that are compared: of the cell, of its reference, of the judge.
class Trio {
 public:
  Trio(Study const& study, Catalogue const& catalogue, CellLabels const& cell, std::int64_t members) {
    auto const& system = catalogue.system(study.system);
    auto const starts = member_starts(study, system, cell.arithmetic, 0, members);
    for (auto const& each : {cell, reference_cell(cell, study.reference.arithmetic), reference_cell(cell, judge)})
      all_.push_back(begin_trajectories(catalogue, each, starts, true, widest_instruction_set(), {study.seed, 0}));
    exact_.resize(system.state_components.size());
    errors_.resize(system.count(Quantity::Kind::state));
  }

  void advance(std::int64_t steps) {
    for (auto const& trajectories : all_) trajectories->advance(steps);
  }

  /// The reference's error over the working arithmetic's; 0 where that has none, or has failed; ∞ where the reference has.
  double ratio(std::size_t member) {
    all_[2]->state(member, exact_);
    all_[0]->state_errors(member, exact_, errors_);
    double const own = largest(errors_);
    all_[1]->state_errors(member, exact_, errors_);
    if (!(own > 0 && std::isfinite(own))) return 0;
    double const ratio = largest(errors_) / own;
    return std::isfinite(ratio) ? ratio : std::numeric_limits<double>::infinity();
  }

 private:
  std::vector<std::unique_ptr<Trajectories>> all_;
  std::vector<Widest> exact_;
  std::vector<double> errors_;
};

}  // namespace

CellLabels reference_cell(CellLabels cell, std::string const& arithmetic) {
  cell.step = rounded_to(cell.arithmetic, cell.step);
  cell.arithmetic = arithmetic;
  cell.compensation = false;  // what the reference itself rounds is far below what it judges
  cell = with_standard_operations(cell);
  if (cell.special_functions != no_level && !variant_exists(cell.special_functions, arithmetic))
    cell.special_functions = "own";
  return cell;
}

bool needs_reference(Study const& study, Catalogue const& catalogue) {
  return std::any_of(study.quantities.begin(), study.quantities.end(),
                     [&](auto const& name) { return catalogue.quantity(study.system, name).needs_reference(); });
}

ReferenceCheck check_reference(Study const& study, Catalogue const& catalogue, CellLabels const& cell) {
  ReferenceCheck check;
  check.members = std::min(most_members, study.reference.members);
  Trio trio(study, catalogue, cell, check.members);
  for (std::int64_t const sample : checked_samples(study, cell)) {
    trio.advance(sample - check.steps);
    check.steps = sample;
    for (std::int64_t i = 0; i < check.members; ++i)
      check.worst = std::max(check.worst, trio.ratio(static_cast<std::size_t>(i)));
  }
  return check;
}

std::vector<std::string> check_references(Study const& study, Catalogue const& catalogue, Plan& plan) {
  std::vector<std::string> failures;
  if (study.reference.kind != Reference::Kind::same_method || !needs_reference(study, catalogue)) return failures;
  for (std::size_t c = 0; c < plan.cells.size(); ++c) {
    auto const& cell = plan.cells[c];
    if (plan.references[c] != "double-double") continue;
    auto const check = check_reference(study, catalogue, cell);
    if (check.passed()) continue;
    plan.references[c] = judge;
    failures.push_back(
        fmt::format("the double-double reference of {} ({}, step {}) is off by {:.1e} of the error that it should "
                    "judge (expected at "
                    "most {:.0e}, over {} steps of {} members): it is replaced by {}",
                    cell.method, cell.arithmetic, cell.step, check.worst, ReferenceCheck::limit, check.steps,
                    check.members, judge));
  }
  return failures;
}

}  // namespace brouwer
