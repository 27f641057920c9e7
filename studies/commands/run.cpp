#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include "analysis/pages/tables.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/findings.hpp"
#include "studies/commands/run_study.hpp"

namespace brouwer {

int run(RunCommand const& command, Catalogue const& catalogue) {
  RunOptions const options = run_options(command.settings);
  StudyFile const file = read_study(command.study, catalogue, command.settings.overrides);
  auto const folder = result_folder(file, command.settings);
  print_study(file, catalogue, folder);
  if (!run_missing(file, catalogue, folder, options)) return interrupted;
  Findings const findings({folder.string()}, levels_of(file, command.settings));
  fmt::print("\n{}", render_table(findings.rows(), TableFormat::text));
  print_verdicts(findings.rows());
  auto const outcomes = findings.check(file.expectations);
  print_outcomes(outcomes, file.unjudged);
  if (std::fflush(stdout) != 0) throw std::system_error(errno, std::generic_category(), "standard output");
  if (!command.no_figures) draw_and_say(findings, catalogue, folder / "figures", "svg");
  return exit_status(outcomes);
}

}  // namespace brouwer
