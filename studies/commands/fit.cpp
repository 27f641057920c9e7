#include <fmt/format.h>

#include "analysis/csv.hpp"
#include "analysis/inference.hpp"
#include "analysis/tables.hpp"
#include "studies/commands/commands.hpp"

namespace brouwer {

int fit(FitCommand const& command) {
  TableFormat const format = table_format(command.format);
  auto const ensembles = read_csv(command.file);
  std::vector<Estimates> rows;
  for (auto const& ensemble : ensembles) rows.push_back(estimate(ensemble, command.levels));
  fmt::print("{}", render_table(rows, format));
  if (format == TableFormat::text)
    for (auto const& row : rows) fmt::print("\n{}: {}\n", row.quantity, row.sentence);
  return done;
}

}  // namespace brouwer
