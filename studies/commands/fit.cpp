#include <fmt/format.h>

#include "analysis/expectations/correct.hpp"
#include "analysis/expectations/guards.hpp"
#include "analysis/figures/plots.hpp"
#include "analysis/files/ensembles_file.hpp"
#include "analysis/growth/inference.hpp"
#include "analysis/pages/tables.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/findings.hpp"

namespace brouwer {

int fit(FitCommand const& command) {
  TableFormat const format = table_format(command.format);
  std::vector<Estimates> rows;
  std::vector<std::vector<double>> final_errors;
  for (auto const& ensemble : read_ensembles(command.file, command.reading)) {
    for (auto const& doubt : doubts(ensemble)) fmt::print(stderr, "brouwer: {}: {}\n", ensemble.quantity, doubt);
    rows.push_back(estimate(ensemble, command.levels));
    final_errors.push_back(final_errors_of(ensemble));
  }
  correct(rows, command.levels.correction.value_or(Correction::none));
  fmt::print("{}", render_table(rows, format));
  if (format == TableFormat::text) print_verdicts(rows);
  if (!command.figures.empty()) draw_and_say(rows, final_errors, command.figures, "svg");
  return done;
}

}  // namespace brouwer
