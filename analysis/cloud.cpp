#include "analysis/cloud.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <brouwer/store/whole_file.hpp>

#include "analysis/cloud_script.hpp"
#include "analysis/gnuplot.hpp"

namespace brouwer {
namespace {

void draw(std::filesystem::path const& folder, std::string const& stem, std::string const& extension,
          std::string const& script, Figures& figures) {
  write_whole(folder / (stem + ".gp"), script);
  if (auto const complaint = gnuplot_complaint(folder, stem + ".gp"))
    figures.note = fmt::format("{}; the scripts and data of the figures are in {}", *complaint, folder.string());
  else
    figures.files.push_back(folder / (stem + "." + extension));
}

}  // namespace

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
  draw(folder, "cloud", "gif", moving_script(film), figures);
  draw(folder, "cloud-still", format, still_script(film, chosen), figures);
  return figures;
}

}  // namespace brouwer
