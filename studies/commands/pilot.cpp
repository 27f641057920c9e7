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

constexpr std::int64_t trial_members = 64;
constexpr std::int64_t trial_steps = 1000;
/// A trial twice as long is not made.
constexpr double enough_seconds = 0.05;

/// The cell alone, with few members and steps.
Study shortened(Study study, CellLabels const& cell, std::int64_t steps) {
  study.methods = {cell.method};
  study.arithmetics = {cell.arithmetic};
  if (cell.special_functions != no_level) study.special_functions = {cell.special_functions};
  study.coefficients.clear();
  if (cell.coefficients != no_level) study.coefficients = {cell.coefficients};
  study.compensation = {cell.compensation};
  study.rounding = {cell.rounding};
  study.constants = {cell.constants};
  study.contraction = {cell.contraction};
  study.step = {cell.step};
  study.until.reset();
  study.steps = steps;
  study.members = std::min(study.members, trial_members);
  study.reference.members = std::min(study.reference.members, study.members);
  study.samples.count = std::min(study.samples.count, steps);
  return study;
}

/// A trial is about errors; and a count may not be of this cell's method.
Study without_counts(Study study, SystemDescription const& system) {
  for (auto const& quantity : system.quantities)
    if (quantity.kind == Quantity::Kind::iterations) std::erase(study.quantities, quantity.name);
  return study;
}

struct Trial {
  double seconds = 0;
  std::vector<UnitRecord> records;
};

Trial carry_out(Study const& study, Catalogue const& catalogue, RunOptions const& options) {
  Plan const plan = make_plan(study, catalogue);
  Progress progress;
  Trial trial;
  auto const begin = std::chrono::steady_clock::now();
  for (auto const& unit : plan.units)
    trial.records.push_back(compute_unit(study, catalogue, plan, unit, "", progress, nullptr, options.widest).record);
  trial.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return trial;
}

/// Trials of 8, 16, 32 … steps, until one has taken long enough.
Trial longest_trial(Study const& study, Catalogue const& catalogue, CellLabels const& cell, RunOptions const& options) {
  Study const observed = without_counts(study, catalogue.system(study.system));
  std::int64_t const limit = std::min(trial_steps, cell.steps);
  for (std::int64_t steps = std::min<std::int64_t>(8, limit);; steps = std::min(2 * steps, limit)) {
    auto trial = carry_out(shortened(observed, cell, steps), catalogue, options);
    if (steps == limit || trial.seconds > enough_seconds) return trial;
  }
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

std::vector<Estimates> try_cell(Study const& study, Catalogue const& catalogue, CellLabels const& cell,
                                RunOptions const& options, Levels const& levels) {
  return estimates_of(longest_trial(study, catalogue, cell, options).records, levels);
}

double smallest_visible_drift(double diffusion, std::int64_t members, std::int64_t steps, Levels const& levels) {
  if (members < 2) return std::numeric_limits<double>::quiet_NaN();
  return diffusion / std::sqrt(static_cast<double>(members) * static_cast<double>(steps)) *
         visible_noncentrality(static_cast<double>(members - 1), levels);
}

double member_steps_to_see(double drift, double diffusion, std::int64_t members, Levels const& levels) {
  if (members < 2) return std::numeric_limits<double>::quiet_NaN();
  double const root = diffusion * visible_noncentrality(static_cast<double>(members - 1), levels) / drift;
  return root * root;
}

}  // namespace brouwer
