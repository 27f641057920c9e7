#include "analysis/figures/cloud_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include <brouwer/error.hpp>

#include "analysis/escape.hpp"
#include "analysis/factors.hpp"
#include "analysis/figures/cloud_points.hpp"
#include "analysis/figures/figure_family.hpp"

namespace brouwer {
namespace {

Plane plane_of(Orbits const& cell) {
  if (cell.names.size() < 2) throw InputError("a picture of phase space needs a state of at least two components");
  return {cell.names[0], cell.names[1]};
}

// --- frames ---------------------------------------------------------------------------------------

/// Every n-th sample, so that time runs evenly, and the last.
std::vector<std::size_t> moments_of(std::size_t samples) {
  std::size_t const last = samples - 1,
                    stride = std::max<std::size_t>((samples + most_frames - 3) / (most_frames - 1), 1);
  std::vector<std::size_t> moments;
  for (std::size_t at = 0; at < last; at += stride) moments.push_back(at);
  moments.push_back(last);
  return moments;
}

/// Of a cell with fewer samples each frame shows the one that is as far from the start.
std::vector<std::size_t> samples_shown(CloudFilm const& film, Orbits const& cell) {
  auto const longest = std::max<std::size_t>(film.moments.back(), 1), last = cell.times.size() - 1;
  std::vector<std::size_t> shown;
  for (auto const moment : film.moments) shown.push_back((moment * last + longest / 2) / longest);
  return shown;
}

/// As many decimals as tell neighbouring frames apart; three digits where samples crowd towards the start.
std::vector<std::string> times_in_words(Orbits const& cell, std::vector<std::size_t> const& shown) {
  std::vector<double> times;
  for (auto const sample : shown) times.push_back(cell.times[sample] * cell.cell.step);
  double const even = times.back() / static_cast<double>(std::max<std::size_t>(times.size() - 1, 1));
  double const first = times.size() > 1 ? times[1] : even;
  int const decimals = first > 0 ? std::clamp(-static_cast<int>(std::floor(std::log10(1.001 * first))), 0, 12) : 0;
  std::vector<std::string> words;
  for (double const t : times)
    words.push_back(first >= 0.5 * even ? fmt::format("{:.{}f}", t, decimals) : fmt::format("{:.3g}", t));
  return words;
}

// --- words and data -------------------------------------------------------------------------------

std::vector<CellLabels> labels_of(std::span<Orbits const> cells) {
  std::vector<CellLabels> labels;
  for (auto const& cell : cells) labels.push_back(cell.cell);
  return labels;
}

std::string cells_in_words(std::size_t shown, std::size_t all) {
  return shown < all ? fmt::format(", the first {} of {} cells", shown, all) : "";
}

std::string members_in_words(std::vector<CloudPoints> const& clouds) {
  auto const drawn = clouds.front().members.size(), all = clouds.front().of->members;
  for (auto const& points : clouds)
    if (points.of->members != all) return "";
  return drawn < all ? fmt::format(", {} of {} members", drawn, all) : fmt::format(", {} members", all);
}

bool holds(Interval range, double x) { return range.low <= x && x <= range.high; }

std::size_t unseen(CloudFilm const& film, CloudPoints const& points, std::size_t time) {
  return static_cast<std::size_t>(std::count_if(points.members.begin(), points.members.end(), [&](auto member) {
    bool const inside = holds(film.x_range, points.px(member, time)) && holds(film.y_range, points.py(member, time));
    return !inside && !points.ended(member, time);
  }));
}

std::size_t ended(CloudPoints const& points, std::size_t time) {
  return static_cast<std::size_t>(std::count_if(points.members.begin(), points.members.end(),
                                                [&](auto member) { return points.ended(member, time); }));
}

CloudFilm::Cell cell_of(CloudFilm const& film, CloudPoints const& points, std::string const& title) {
  auto const shown = samples_shown(film, *points.of);
  CloudFilm::Cell cell{title, times_in_words(*points.of, shown), {}, {}, points.members.size()};
  for (auto const sample : shown) {
    cell.unseen.push_back(unseen(film, points, sample));
    cell.ended.push_back(ended(points, sample));
  }
  return cell;
}

std::string block_of(CloudPoints const& points, std::size_t time) {
  std::string text;
  for (std::size_t i = 0; i < points.members.size(); ++i) {
    double const x = points.px(points.members[i], time), y = points.py(points.members[i], time);
    text += fmt::format("{} {} 0x{}\n", plot_number(x), plot_number(y), points.colours[i].substr(1));
  }
  return text + "\n\n";
}

std::string data_of(CloudFilm const& film, std::vector<CloudPoints> const& clouds) {
  auto text = fmt::format("# frame by frame, cell by cell: {}  {}  colour\n", one_line(film.x), one_line(film.y));
  std::vector<std::vector<std::size_t>> shown;
  for (auto const& points : clouds) shown.push_back(samples_shown(film, *points.of));
  for (std::size_t frame = 0; frame < film.frames(); ++frame)
    for (std::size_t c = 0; c < clouds.size(); ++c) text += block_of(clouds[c], shown[c][frame]);
  return text;
}

}  // namespace

CloudFilm film_of(std::vector<Orbits> const& all, std::optional<Plane> const& plane) {
  CloudFilm film;
  std::span const cells(all.data(), std::min(all.size(), most_cells));
  auto const [x, y] = plane ? *plane : plane_of(cells.front());
  std::size_t samples = 1;
  std::vector<CloudPoints> clouds;
  for (auto const& cell : cells) {
    clouds.push_back(points_of(cell, {x, y}, most_points));
    samples = std::max(samples, cell.times.size());
  }
  film.moments = moments_of(samples);
  auto const axes = axes_of(clouds);
  film.x_range = axes.x;
  film.y_range = axes.y;
  auto const labels = labels_of(cells);
  auto const varying = varying_factors(labels);
  for (auto const& points : clouds)
    film.cells.push_back(cell_of(film, points, cells.size() > 1 ? short_label(points.of->cell, varying) : ""));
  film.x = x;
  film.y = y;
  film.subtitle = fmt::format("{}{}{}; colour: {} at the start", describe(labels.front(), constant_factors(labels)),
                              members_in_words(clouds), cells_in_words(cells.size(), all.size()), x);
  film.data = data_of(film, clouds);
  return film;
}

}  // namespace brouwer
