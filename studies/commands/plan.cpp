#include <fmt/format.h>

#include <brouwer/ensemble/run.hpp>
#include <brouwer/error.hpp>

#include "analysis/factors.hpp"
#include "analysis/numbers.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/pilot.hpp"
#include "studies/commands/progress_line.hpp"
#include "studies/commands/run_study.hpp"

namespace brouwer {
namespace {

double seconds_of(Study const& study, CellLabels const& cell, Pilot const& pilot) {
  double const of_member = static_cast<double>(cell.steps) * pilot.seconds_per_step;
  return static_cast<double>(study.members) * of_member +
         static_cast<double>(study.reference.members) * pilot.seconds_of_reference;
}

/// How many members a row has in the whole study, from how many it had in the trial.
std::int64_t members_of(Study const& study, Catalogue const& catalogue, Estimates const& row) {
  bool const compared = catalogue.quantity(study.system, row.family).needs_reference;
  return compared ? study.reference.members : study.members;
}

void print_cell(StudyFile const& file, Catalogue const& catalogue, CellLabels const& cell, Pilot const& pilot,
                Levels const& levels) {
  fmt::print("\n{}: {} on one thread ({:.2g} s a member-step)\n", describe(cell),
             duration_text(seconds_of(file.study, cell, pilot)), pilot.seconds_per_step);
  for (auto const& row : pilot.rows) {
    std::int64_t const members = members_of(file.study, catalogue, row);
    double const visible = smallest_visible_drift(row.diffusion.per_sqrt_step, members, cell.steps, levels);
    fmt::print("  {} smallest visible drift {} per step with {} members\n", left_aligned(row.quantity, 22),
               number(visible, 2), members);
  }
}

}  // namespace

int plan(PlanCommand const& command, Catalogue const& catalogue) {
  StudyFile const file = read_study(command.study, catalogue, command.settings.overrides);
  print_study(file, catalogue, result_folder(file, command.settings));
  double seconds = 0;
  for (auto const& cell : file.plan.cells) {
    Pilot const pilot = try_cell(file.study, catalogue, cell, command.settings.levels);
    print_cell(file, catalogue, cell, pilot, command.settings.levels);
    seconds += seconds_of(file.study, cell, pilot);
  }
  int const threads = threads_of({command.settings.threads, nullptr});
  fmt::print("\nAll of it takes about {} on {} threads.\n", duration_text(seconds / threads), threads);
  Levels const& levels = command.settings.levels;
  fmt::print("Visible: seen at the level {} with a chance of {}, if the error is the random walk of a short trial.\n",
             levels.test, levels.power);
  return done;
}

}  // namespace brouwer
