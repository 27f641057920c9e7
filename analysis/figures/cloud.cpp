#include "analysis/figures/cloud.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <brouwer/store/whole_file.hpp>

#include "analysis/escape.hpp"
#include "analysis/figures/cloud_points.hpp"
#include "analysis/figures/cloud_script.hpp"

namespace brouwer {
namespace {

/// "cloud: the first 12 of 58 cells", or nothing.
std::string note_of(std::size_t cells) {
  return cells > most_cells ? fmt::format("cloud: the first {} of {} cells", most_cells, cells) : "";
}

}  // namespace

void check_plane(std::vector<Orbits> const& cells, Plane const& plane) {
  if (plane.x == plane.y)
    throw InputError(fmt::format("a plane has two different components, not '{}' twice", one_line(plane.x)));
  bool any = false;
  for (auto const& cell : cells) {
    if (cell.members == 0) continue;
    points_of(cell, plane, 1);
    any = true;
  }
  if (!any) throw InputError("there are no states to show in a plane: run the study with observe.states = true");
}

Figures draw_clouds(std::vector<Orbits> const& cells, std::filesystem::path const& folder,
                    std::optional<Plane> const& plane, std::string const& format) {
  auto const chosen = figure_format(format);
  auto there = cells;
  std::erase_if(there, [](Orbits const& cell) { return cell.members == 0; });
  Figures figures;
  if (there.empty()) return figures;
  auto const film = film_of(there, plane);
  make_figure_folder(folder);
  write_whole(folder / "cloud.dat", film.data);
  draw_script(folder, "cloud", "gif", moving_script(film), figures);
  draw_script(folder, "cloud-still", format, still_script(film, chosen), figures);
  figures.note = joined_notes(note_of(there.size()), figures.note);
  return figures;
}

}  // namespace brouwer
