#include <fmt/format.h>

#include "analysis/correct.hpp"
#include "analysis/csv.hpp"
#include "analysis/inference.hpp"
#include "analysis/plots.hpp"
#include "analysis/tables.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/findings.hpp"

namespace brouwer {

int fit(FitCommand const& command) {
  TableFormat const format = table_format(command.format);
  std::vector<Estimates> rows;
  std::vector<std::vector<double>> final_errors;
  for (auto const& ensemble : read_csv(command.file)) {
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
