#include <fmt/format.h>

#include <cmath>

#include <brouwer/ensemble/run.hpp>
#include <brouwer/error.hpp>

#include "analysis/factors.hpp"
#include "analysis/numbers.hpp"
#include "studies/commands/calibration.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/pilot.hpp"
#include "studies/commands/progress_line.hpp"
#include "studies/commands/run_study.hpp"

namespace brouwer {
namespace {

/// How many members a row has in the whole study, from how many it had in the trial.
std::int64_t members_of(Study const& study, Catalogue const& catalogue, Estimates const& row) {
  bool const compared = catalogue.quantity(study.system, row.family).needs_reference();
  return compared ? study.reference.members : study.members;
}

/// "1.2e+09 member-steps: 128 members over 9.4e+06 steps, or 2.4e+04 members over 50000"
std::string cost_text(double member_steps, std::int64_t members, std::int64_t steps) {
  return fmt::format("{:.2g} member-steps: {} members over {:.2g} steps, or {:.2g} members over {}", member_steps,
                     members, std::ceil(member_steps / static_cast<double>(members)),
                     std::ceil(member_steps / static_cast<double>(steps)), steps);
}

void print_row(PlanCommand const& command, Estimates const& row, std::int64_t members, std::int64_t steps) {
  Levels const& levels = command.settings.levels;
  double const sigma = row.diffusion.per_sqrt_step;
  fmt::print("  {} smallest visible drift {} per step with {} members\n", left_aligned(row.quantity, 22),
             number(smallest_visible_drift(sigma, members, steps, levels), 2), members);
  if (!command.drift || members < 2) return;
  double const cost = member_steps_to_see(*command.drift, sigma, members, levels);
  fmt::print("  {:22} to see {} per step: {}\n", "", number(*command.drift, 2), cost_text(cost, members, steps));
}

void print_cell(PlanCommand const& command, StudyFile const& file, Catalogue const& catalogue, CellLabels const& cell,
                CellCosts const& costs, RunOptions const& options) {
  fmt::print("\n{}: {} on one thread ({:.2g} ns a member-step)\n", describe(cell),
             duration_text(costs.seconds(file.study, cell)), 1e9 * costs.member.step);
  for (auto const& row : try_cell(file.study, catalogue, cell, options, command.settings.levels))
    print_row(command, row, members_of(file.study, catalogue, row), cell.steps);
}

}  // namespace

int plan(PlanCommand const& command, Catalogue const& catalogue) {
  if (command.drift && !(*command.drift != 0 && std::isfinite(*command.drift)))
    throw InputError("--drift: expected a number other than 0");
  RunOptions const options = run_options(command.settings);
  StudyFile const file = read_study(command.study, catalogue, command.settings.overrides);
  print_study(file, catalogue, result_folder(file, command.settings));
  double seconds = 0;
  for (auto const& cell : file.plan.cells) {
    CellCosts const costs = calibrate(file.study, catalogue, cell, options);
    print_cell(command, file, catalogue, cell, costs, options);
    seconds += costs.seconds(file.study, cell);
  }
  int const threads = threads_of(options);
  fmt::print("\nAll of it takes about {} on {} threads.\n", duration_text(seconds / threads), threads);
  Levels const& levels = command.settings.levels;
  fmt::print("Visible: seen at the level {} with a chance of {}, if the error is the random walk of a short trial.\n",
             levels.test, levels.power);
  return done;
}

}  // namespace brouwer
