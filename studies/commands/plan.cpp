#include <fmt/format.h>

#include <cmath>

#include <brouwer/ensemble/run.hpp>
#include <brouwer/error.hpp>

#include "analysis/factors.hpp"
#include "analysis/numbers.hpp"
#include "studies/commands/calibration.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/power_text.hpp"
#include "studies/commands/probe_cell.hpp"
#include "studies/commands/progress_line.hpp"
#include "studies/commands/run_study.hpp"

namespace brouwer {
namespace {

/// How many members have a quantity in the whole study.
std::int64_t members_of(Study const& study, Catalogue const& catalogue, std::string const& family) {
  bool const compared = catalogue.quantity(study.system, family).needs_reference();
  return compared ? study.reference.members : study.members;
}

void print_row(PlanCommand const& command, StudyFile const& file, Catalogue const& catalogue, LocalErrors const& errors,
               double seconds_a_member_step) {
  if (errors.rounding.rows() < 2) {
    fmt::print("  {} all members but {} failed in the probe\n", left_aligned(errors.quantity, 22),
               errors.rounding.rows());
    return;
  }
  auto const local = estimate(errors, command.settings.levels);
  if (auto const prediction = predict(local, errors.cell.steps))
    fmt::print("{}",
               power_text({local, *prediction, members_of(file.study, catalogue, errors.family), seconds_a_member_step},
                          command.drift));
}

void print_cell(PlanCommand const& command, StudyFile const& file, Catalogue const& catalogue, CellLabels const& cell,
                CellCosts const& costs, RunOptions const& options) {
  fmt::print("\n{}: {} on one thread ({:.2g} ns a member-step)\n", describe(cell),
             duration_text(costs.seconds(file.study, cell)), 1e9 * costs.member.step);
  if (auto const reason = reason_not_to_probe(file.study, catalogue, cell, {}); !reason.empty()) {
    fmt::print("  {}\n", reason);
    return;
  }
  for (auto const& errors : probe_cell(file.study, catalogue, cell, {}, options, command.settings.levels).errors)
    print_row(command, file, catalogue, errors, costs.member.step / threads_of(options));
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
  fmt::print(
      "Visible: a drift seen at the level {} with a chance of {}. Excluded: where there is no drift, the {:g} % "
      "interval of β lies inside with that chance. Both from the local errors of a probe.\n",
      levels.test, levels.power, 100 * levels.confidence);
  return done;
}

}  // namespace brouwer
