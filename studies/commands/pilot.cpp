#include "studies/commands/pilot.hpp"

#include <algorithm>
#include <brouwer/ensemble/run.hpp>
#include <brouwer/error.hpp>
#include <chrono>
#include <cmath>
#include <limits>

#include "analysis/inference.hpp"

namespace brouwer {
namespace {

constexpr std::int64_t trial_members = 16;
constexpr std::int64_t trial_steps = 1000;
/// A trial twice as long is not made: at most 0.2 s, twice (with a reference, and without).
constexpr double enough_seconds = 0.1;

/// The cell alone, with few members and steps.
Study shortened(Study study, CellLabels const& cell, std::int64_t steps) {
  study.methods = {cell.method};
  study.arithmetics = {cell.arithmetic};
  if (cell.special_functions != no_level) study.special_functions = {cell.special_functions};
  if (cell.coefficients != no_level) study.coefficients = {cell.coefficients};
  study.compensation = {cell.compensation};
  study.step = {cell.step};
  study.until.reset();
  study.steps = steps;
  study.members = std::min(study.members, trial_members);
  study.reference.members = std::min(study.reference.members, study.members);
  study.samples.count = std::min(study.samples.count, steps);
  return study;
}

/// The study with first integrals only: those that it observes, or any; nothing where the system has none.
std::optional<Study> without_reference(Study study, Catalogue const& catalogue) {
  auto const needs = [&](auto const& name) { return catalogue.quantity(study.system, name).needs_reference; };
  std::erase_if(study.quantities, needs);
  if (study.quantities.empty())
    for (auto const& quantity : catalogue.system(study.system).quantities)
      if (!quantity.needs_reference) study.quantities = {quantity.name};
  study.reference = {};
  return study.quantities.empty() ? std::nullopt : std::optional(study);
}

struct Trial {
  double seconds = 0;
  std::vector<UnitRecord> records;
};

Trial carry_out(Study const& study, Catalogue const& catalogue) {
  Plan const plan = make_plan(study, catalogue);
  Progress progress;
  Trial trial;
  auto const begin = std::chrono::steady_clock::now();
  for (auto const& unit : plan.units)
    trial.records.push_back(compute_unit(study, catalogue, plan, unit, "", progress, nullptr).record);
  trial.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return trial;
}

struct Longest {
  Trial trial;
  std::int64_t steps = 0;
};

/// Trials of 8, 16, 32 … steps, until one has taken long enough to be measured.
Longest longest_trial(Study const& study, Catalogue const& catalogue, CellLabels const& cell) {
  std::int64_t const limit = std::min(trial_steps, cell.steps);
  for (std::int64_t steps = std::min<std::int64_t>(8, limit);; steps = std::min(2 * steps, limit)) {
    auto trial = carry_out(shortened(study, cell, steps), catalogue);
    if (steps == limit || trial.seconds > enough_seconds) return {std::move(trial), steps};
  }
}

/// How much more a member's reference costs than in a trial of so many steps: the same method makes every step, the
/// exact flow is evaluated at the samples only.
double times_longer(Study const& study, CellLabels const& cell, std::int64_t steps) {
  auto const ratio = [](std::int64_t a, std::int64_t b) { return static_cast<double>(a) / static_cast<double>(b); };
  if (study.reference.kind == Reference::Kind::exact)
    return ratio(study.samples.count, std::min(study.samples.count, steps));
  return ratio(cell.steps, steps);
}

/// Members of one series with finite errors, over all units.
Ensemble ensemble_of(std::vector<UnitRecord> const& records, std::size_t series) {
  auto const& first = records.front();
  Ensemble ensemble{
      first.cell, first.series[series].name, first.series[series].quantity, first.series[series].unit, {}, {}, 0};
  ensemble.times.assign(first.sample_steps.begin(), first.sample_steps.end());
  auto const columns = static_cast<Eigen::Index>(ensemble.times.size());
  for (auto const& record : records) {
    auto const& numbers = record.series[series];
    Eigen::Map<ErrorMatrix const> const errors(numbers.errors.data(), numbers.members, columns);
    for (Eigen::Index member = 0; member < errors.rows(); ++member) {
      if (!errors.row(member).allFinite()) continue;
      ensemble.errors.conservativeResize(ensemble.errors.rows() + 1, columns);
      ensemble.errors.bottomRows(1) = errors.row(member);
    }
  }
  return ensemble;
}

std::vector<Estimates> estimates_of(std::vector<UnitRecord> const& records, Levels const& levels) {
  std::vector<Estimates> rows;
  for (std::size_t series = 0; series < records.front().series.size(); ++series)
    if (auto const ensemble = ensemble_of(records, series); ensemble.errors.rows() > 0)
      rows.push_back(estimate(ensemble, levels));
  return rows;
}

}  // namespace

Pilot try_cell(Study const& study, Catalogue const& catalogue, CellLabels const& cell, Levels const& levels) {
  auto const members = std::min(study.members, trial_members);
  auto const references = std::min(study.reference.members, members);
  auto const alone = without_reference(study, catalogue);
  Longest trial = longest_trial(alone ? *alone : study, catalogue, cell);
  Pilot pilot;
  pilot.seconds_per_step = trial.trial.seconds / static_cast<double>(trial.steps * members);
  if (alone && references > 0) {
    trial = longest_trial(study, catalogue, cell);
    double const of_members = pilot.seconds_per_step * static_cast<double>(trial.steps * members);
    double const of_references = std::max(0.0, trial.trial.seconds - of_members) / static_cast<double>(references);
    pilot.seconds_of_reference = of_references * times_longer(study, cell, trial.steps);
  }
  pilot.rows = estimates_of(trial.trial.records, levels);
  return pilot;
}

double smallest_visible_drift(double diffusion, std::int64_t members, std::int64_t steps, Levels const& levels) {
  if (members < 2) return std::numeric_limits<double>::quiet_NaN();
  return diffusion / std::sqrt(static_cast<double>(members) * static_cast<double>(steps)) *
         visible_noncentrality(static_cast<double>(members - 1), levels);
}

}  // namespace brouwer
