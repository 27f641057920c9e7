#include <fmt/format.h>

#include "analysis/pages/tables.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/findings.hpp"

namespace brouwer {

int table(TableCommand const& command) {
  TableFormat const format = table_format(command.format);  // before the work, which may be long
  Findings const findings(command.results, command.levels);
  fmt::print("{}", render_table(findings.rows(), format));
  return done;
}

}  // namespace brouwer
