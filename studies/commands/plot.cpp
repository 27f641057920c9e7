#include <filesystem>

#include "studies/commands/commands.hpp"
#include "studies/commands/findings.hpp"

namespace brouwer {

int plot(PlotCommand const& command) {
  Findings const findings(command.results, command.levels);
  auto const standard = std::filesystem::path(command.results.front()) / "figures";
  auto const folder = command.folder.empty() ? standard : std::filesystem::path(command.folder);
  draw_and_say(findings, folder, command.format);
  return done;
}

}  // namespace brouwer
