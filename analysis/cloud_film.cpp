#include "analysis/cloud_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>

#include "analysis/escape.hpp"
#include "analysis/factors.hpp"
#include "analysis/figure_family.hpp"

namespace brouwer {
namespace {

constexpr double most_beyond = 1.7;       ///< how far axes follow a cloud that runs away, in half widths of the tamest
constexpr double least_aspect = 1.0 / 3;  ///< of the shorter side of a panel to the longer
constexpr int shades = 24;                ///< a GIF has 256 colours in all

/// The members of one cell in the plane.
struct Points {
  Orbits const* of;
  std::size_t x, y;                  // components
  std::vector<std::size_t> members;  // that are drawn
  std::vector<std::string> colours;  // of these

  double px(std::size_t member, std::size_t time) const { return of->at(member, time, x); }
  double py(std::size_t member, std::size_t time) const { return of->at(member, time, y); }
};

std::size_t component(Orbits const& cell, std::string const& name) {
  auto const found = std::find(cell.names.begin(), cell.names.end(), name);
  if (found == cell.names.end())
    throw InputError(fmt::format("the state has no component '{}'{}", one_line(name), suggestion(name, cell.names)));
  return static_cast<std::size_t>(found - cell.names.begin());
}

Plane plane_of(Orbits const& cell) {
  if (cell.names.size() < 2) throw InputError("a picture of phase space needs a state of at least two components");
  return {cell.names[0], cell.names[1]};
}

/// `count` of 0 … n − 1, evenly, with both ends.
std::vector<std::size_t> evenly(std::size_t n, std::size_t count) {
  std::vector<std::size_t> chosen(std::min(n, count));
  for (std::size_t i = 0; i < chosen.size(); ++i)
    chosen[i] = chosen.size() < 2 ? 0 : (i * (n - 1) + (chosen.size() - 1) / 2) / (chosen.size() - 1);
  return chosen;
}

/// By rank of x at the start, in a few shades.
std::vector<std::string> colours_of(Points const& points) {
  std::vector<std::size_t> order(points.members.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  auto const start = [&](std::size_t i) {
    double const x = points.px(points.members[i], 0);
    return std::isnan(x) ? std::numeric_limits<double>::infinity() : x;
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return start(a) < start(b); });
  std::vector<std::string> colours(order.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    auto const shade = static_cast<double>(shades * rank / order.size());
    colours[order[rank]] = ordered_colour(shade / (shades - 1));
  }
  return colours;
}

Points points_of(Orbits const& cell, Plane const& plane) {
  Points points{&cell, component(cell, plane.x), component(cell, plane.y), evenly(cell.members, most_points), {}};
  points.colours = colours_of(points);
  return points;
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

// --- axes -----------------------------------------------------------------------------------------

struct Box {
  Interval x{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}, y = x;
  double size() const { return std::hypot(x.high - x.low, y.high - y.low); }
};

void widen(Interval& range, double value) { range = {std::min(range.low, value), std::max(range.high, value)}; }

Box box_of(Points const& points) {
  Box box;
  for (auto const member : points.members)
    for (std::size_t time = 0; time < points.of->times.size(); ++time) {
      double const x = points.px(member, time), y = points.py(member, time);
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      widen(box.x, x);
      widen(box.y, y);
    }
  return box;
}

/// `range` as far as the tamest cloud's multiple allows.
Interval followed(Interval tame, Interval range) {
  double const middle = (tame.low + tame.high) / 2, reach = most_beyond * (tame.high - tame.low) / 2;
  return {std::min(tame.low, std::max(range.low, middle - reach)),
          std::max(tame.high, std::min(range.high, middle + reach))};
}

Box common_box(std::vector<Points> const& clouds) {
  std::vector<Box> boxes;
  for (auto const& points : clouds)
    if (auto const box = box_of(points); box.x.low <= box.x.high) boxes.push_back(box);
  if (boxes.empty()) return {{0, 1}, {0, 1}};
  auto const tame = *std::min_element(boxes.begin(), boxes.end(), [](auto& a, auto& b) { return a.size() < b.size(); });
  Box all = tame;
  for (auto const& box : boxes) {
    auto const x = followed(tame.x, box.x), y = followed(tame.y, box.y);
    for (double const end : {x.low, x.high}) widen(all.x, end);
    for (double const end : {y.low, y.high}) widen(all.y, end);
  }
  return all;
}

Interval at_least(Interval range, double width) {
  double const missing = std::max(width - (range.high - range.low), 0.0) / 2;
  return {range.low - missing, range.high + missing};
}

/// Room around, and a panel that is no slit.
void choose_axes(CloudFilm& film, Box box) {
  double const longest = std::max(box.x.high - box.x.low, box.y.high - box.y.low);
  double const scale = std::max({std::abs(box.x.high), std::abs(box.y.high), 1.0});
  double const side = longest > 0 ? longest : scale, room = 0.06 * side;
  film.x_range = at_least({box.x.low - room, box.x.high + room}, least_aspect * side);
  film.y_range = at_least({box.y.low - room, box.y.high + room}, least_aspect * side);
}

// --- words and data -------------------------------------------------------------------------------

std::vector<CellLabels> labels_of(std::vector<Orbits> const& cells) {
  std::vector<CellLabels> labels;
  for (auto const& cell : cells) labels.push_back(cell.cell);
  return labels;
}

std::string members_in_words(std::vector<Points> const& clouds) {
  auto const drawn = clouds.front().members.size(), all = clouds.front().of->members;
  for (auto const& points : clouds)
    if (points.of->members != all) return "";
  return drawn < all ? fmt::format(", {} of {} members", drawn, all) : fmt::format(", {} members", all);
}

bool holds(Interval range, double x) { return range.low <= x && x <= range.high; }

std::size_t unseen(CloudFilm const& film, Points const& points, std::size_t time) {
  return static_cast<std::size_t>(std::count_if(points.members.begin(), points.members.end(), [&](auto member) {
    return !holds(film.x_range, points.px(member, time)) || !holds(film.y_range, points.py(member, time));
  }));
}

CloudFilm::Cell cell_of(CloudFilm const& film, Points const& points, std::string const& title) {
  auto const shown = samples_shown(film, *points.of);
  CloudFilm::Cell cell{title, times_in_words(*points.of, shown), {}, points.members.size()};
  for (auto const sample : shown) cell.unseen.push_back(unseen(film, points, sample));
  return cell;
}

std::string block_of(Points const& points, std::size_t time) {
  std::string text;
  for (std::size_t i = 0; i < points.members.size(); ++i) {
    double const x = points.px(points.members[i], time), y = points.py(points.members[i], time);
    text += fmt::format("{} {} 0x{}\n", plot_number(x), plot_number(y), points.colours[i].substr(1));
  }
  return text + "\n\n";
}

std::string data_of(CloudFilm const& film, std::vector<Points> const& clouds) {
  auto text = fmt::format("# frame by frame, cell by cell: {}  {}  colour\n", one_line(film.x), one_line(film.y));
  std::vector<std::vector<std::size_t>> shown;
  for (auto const& points : clouds) shown.push_back(samples_shown(film, *points.of));
  for (std::size_t frame = 0; frame < film.frames(); ++frame)
    for (std::size_t c = 0; c < clouds.size(); ++c) text += block_of(clouds[c], shown[c][frame]);
  return text;
}

}  // namespace

CloudFilm film_of(std::vector<Orbits> const& cells, std::optional<Plane> const& plane) {
  CloudFilm film;
  auto const [x, y] = plane ? *plane : plane_of(cells.front());
  std::size_t samples = 1;
  std::vector<Points> clouds;
  for (auto const& cell : cells) {
    clouds.push_back(points_of(cell, {x, y}));
    samples = std::max(samples, cell.times.size());
  }
  film.moments = moments_of(samples);
  choose_axes(film, common_box(clouds));
  auto const labels = labels_of(cells);
  auto const varying = varying_factors(labels);
  for (auto const& points : clouds)
    film.cells.push_back(cell_of(film, points, cells.size() > 1 ? short_label(points.of->cell, varying) : ""));
  film.x = x;
  film.y = y;
  film.subtitle = fmt::format("{}{}; colour: {} at the start", describe(labels.front(), constant_factors(labels)),
                              members_in_words(clouds), x);
  film.data = data_of(film, clouds);
  return film;
}

}  // namespace brouwer
