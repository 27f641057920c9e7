#include <filesystem>

#include "analysis/plots.hpp"
#include "studies/commands/commands.hpp"
#include "studies/commands/findings.hpp"

namespace brouwer {

int plot(PlotCommand const& command) {
  Findings const findings(command.results, command.levels);
  auto const standard = std::filesystem::path(command.results.front()) / "figures";
  auto const folder = command.folder.empty() ? standard : std::filesystem::path(command.folder);
  draw_and_say(findings.rows(), findings.final_errors(), folder, command.format, findings.cpu_seconds());
  return done;
}

}  // namespace brouwer
