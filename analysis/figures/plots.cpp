#include "analysis/figures/plots.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include <brouwer/error.hpp>
#include <brouwer/store/whole_file.hpp>

#include "analysis/figures/figure_family.hpp"
#include "analysis/figures/gnuplot.hpp"

namespace brouwer {
namespace {

std::vector<FigureSheet> sheets_of(Family const& family) {
  std::vector<FigureSheet> sheets;
  if (family.rows.front().estimates->count) return {count_sheet(family)};
  for (auto* const sheet : {growth_sheet, histogram_sheet, increments_sheet, mean_sheet, precision_sheet})
    if (auto drawn = sheet(family); !drawn.panels.empty()) sheets.push_back(std::move(drawn));
  return sheets;
}

void draw(FigureSheet const& sheet, FigureFormat format, std::filesystem::path const& folder, Figures& figures) {
  write_whole(folder / sheet.data_file(), sheet.data);
  draw_script(folder, sheet.stem, extension(format), gnuplot_script(sheet, format), figures);
}

bool contains(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

}  // namespace

std::string joined_notes(std::string const& a, std::string const& b) {
  if (contains(a, b)) return a;
  return contains(b, a) ? b : a + "; " + b;
}

void draw_script(std::filesystem::path const& folder, std::string const& stem, std::string const& extension,
                 std::string const& script, Figures& figures) {
  std::string const figure = stem + "." + extension;
  write_whole(folder / (stem + ".gp"), script);
  if (auto const complaint = gnuplot_complaint(folder, stem + ".gp", figure))
    figures.note = fmt::format("{}; the scripts and data of the figures are in {}", *complaint, folder.string());
  else
    figures.files.push_back(folder / figure);
}

void make_figure_folder(std::filesystem::path const& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw RunError(fmt::format("cannot make the folder {} for figures: {}", folder.string(), error.message()));
}

Figures draw_figures(std::vector<Estimates> const& estimates, std::vector<std::vector<double>> const& final_errors,
                     std::filesystem::path const& folder, std::string const& format,
                     std::vector<double> const& cpu_seconds) {
  auto const chosen = figure_format(format);
  make_figure_folder(folder);
  auto rows = estimates;  // where every member failed there is nothing to draw
  auto last = final_errors;
  auto seconds = cpu_seconds;
  last.resize(rows.size());
  seconds.resize(rows.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = rows.size(); i-- > 0;)
    if (std::isnan(rows[i].rms_final)) {
      auto const at = static_cast<std::ptrdiff_t>(i);
      rows.erase(rows.begin() + at);
      last.erase(last.begin() + at);
      seconds.erase(seconds.begin() + at);
    }
  Figures figures;
  for (auto const& family : families(rows, last, seconds))
    for (auto const& sheet : sheets_of(family)) draw(sheet, chosen, folder, figures);
  return figures;
}

}  // namespace brouwer
