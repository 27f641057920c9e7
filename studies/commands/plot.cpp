#include <filesystem>

#include "studies/commands/commands.hpp"
#include "studies/commands/findings.hpp"

namespace brouwer {
namespace {

std::optional<Plane> plane_of(PlotCommand const& command) {
  if (command.plane.empty()) return std::nullopt;
  return Plane{command.plane.front(), command.plane.back()};
}

}  // namespace

int plot(PlotCommand const& command, Catalogue const& catalogue) {
  Findings const findings(command.results, command.levels);
  auto const standard = std::filesystem::path(command.results.front()) / "figures";
  auto const folder = command.folder.empty() ? standard : std::filesystem::path(command.folder);
  draw_and_say(findings, catalogue, folder, command.format, plane_of(command));
  return done;
}

}  // namespace brouwer
