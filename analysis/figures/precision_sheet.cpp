// Work and precision: what an error at the end costs, in steps and in time. A colour for each series of methods, paler
// from its best to its worst; dashes for what else varies.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "analysis/escape.hpp"
#include "analysis/factors.hpp"
#include "analysis/figures/figure_family.hpp"
#include "analysis/figures/precision.hpp"

namespace brouwer {
namespace {

constexpr int point_types[] = {7, 5, 9, 11, 13, 6, 4, 8};
constexpr int dashes[] = {1, 2, 4, 3, 5};
constexpr double palest = 0.45;  ///< how much white is in the colour of a series' first method

using Words = std::vector<std::string>;

std::size_t index_in(Words& list, std::string const& item) {
  auto const found = std::find(list.begin(), list.end(), item);
  if (found != list.end()) return static_cast<std::size_t>(found - list.begin());
  list.push_back(item);
  return list.size() - 1;
}

std::vector<CellLabels> cells_of(WorkPrecision const& work) {
  std::vector<CellLabels> cells;
  for (auto const& line : work.lines) cells.push_back(line.cell);
  return cells;
}

bool is_method(Factor const* factor) { return std::string(factor->name) == "method"; }

/// Factors other than the method of which one method has several levels. That methods differ in an option which only
/// some of them have tells nothing apart.
Factors varying_within_methods(std::vector<CellLabels> const& cells) {
  auto factors = varying_factors(cells);
  std::erase_if(factors, [&](Factor const* factor) {
    std::map<std::string, std::string> level;
    return is_method(factor) || std::all_of(cells.begin(), cells.end(), [&](CellLabels const& cell) {
             return level.emplace(cell.method, factor->level(cell)).first->second == factor->level(cell);
           });
  });
  return factors;
}

/// The method, where there are several, and what varies within methods.
std::string label_of(CellLabels const& cell, std::vector<CellLabels> const& cells) {
  Factors telling;
  auto const within = varying_within_methods(cells);
  for (auto const* factor : varying_factors(cells))
    if (is_method(factor) || std::find(within.begin(), within.end(), factor) != within.end()) telling.push_back(factor);
  return short_label(cell, telling);
}

/// How a line is drawn; gnuplot's words but for the columns.
struct Pen {
  std::string colour;
  int dash = 1, mark = 7;
  std::string words() const { return fmt::format("lw 1.6 dt {} pt {} lc rgb '{}'", dash, mark, colour); }
};

/// Methods by series, in the order in which they appear: their rank is their shade and their mark.
struct Palette {
  Words series;
  std::vector<Words> methods;  // of each series

  explicit Palette(std::vector<CellLabels> const& cells) {
    for (auto const& cell : cells) {
      auto const at = index_in(series, series_of(cell.method));
      methods.resize(series.size());
      index_in(methods[at], cell.method);
    }
  }
  std::pair<std::size_t, std::size_t> place_of(std::string const& method) {
    auto const at = index_in(series, series_of(method));
    return {at, index_in(methods[at], method)};
  }
};

std::vector<Pen> pens_of(std::vector<CellLabels> const& cells) {
  Palette palette(cells);
  auto const others = varying_within_methods(cells), varying = varying_factors(cells);
  bool const one_method = std::none_of(varying.begin(), varying.end(), is_method);
  Words combinations;
  std::vector<Pen> pens;
  for (auto const& cell : cells) {
    auto const [series, rank] = palette.place_of(cell.method);
    auto const other = index_in(combinations, describe(cell, others));
    auto const last = palette.methods[series].size() - 1;
    double const white = last == 0 ? 0 : palest * static_cast<double>(last - rank) / static_cast<double>(last);
    pens.push_back({paler(distinct_colour(one_method ? other : series), white),
                    dashes[(other + series / 7) % std::size(dashes)],
                    point_types[(one_method ? other : rank) % std::size(point_types)]});
  }
  return pens;
}

std::string data_block(PrecisionLine const& line) {
  std::string text = fmt::format("# {}\n# steps  error  CPU-seconds\n", one_line(describe(line.cell)));
  for (auto const& point : line.points)
    text +=
        fmt::format("{} {} {}\n", plot_number(point.steps), plot_number(point.error), plot_number(point.cpu_seconds));
  return text + "\n\n";
}

/// The range of one coordinate, a little widened.
Interval range_of(WorkPrecision const& work, double PrecisionPoint::*coordinate) {
  Interval range{std::numeric_limits<double>::infinity(), 0};
  for (auto const& line : work.lines)
    for (auto const& point : line.points)
      if (double const x = point.*coordinate; std::isfinite(x) && x > 0)
        range = {std::min(range.low, x), std::max(range.high, x)};
  return {range.low / 1.5, range.high * 1.5};
}

/// Where decades are few, 1, 2 and 5 of each have a tic, too.
std::string logarithmic_axis(char axis, Interval range) {
  auto text = fmt::format("set {}range {}; set format {} '10^{{%T}}'; set {}tics autofreq", axis,
                          plot_range(range.low, range.high), axis, axis);
  if (range.high > 100 * range.low) return text;
  Words tics;
  for (int e = static_cast<int>(std::floor(std::log10(range.low))); std::pow(10.0, e) <= range.high; ++e)
    for (int const digit : {1, 2, 5}) tics.push_back(fmt::format("{}e{}", digit, e));
  bool const plain = range.low >= 1e-4 && range.high < 1e5;
  return fmt::format("{}; set format {} '{}'; set {}tics ({})", text, axis, plain ? "%g" : "%.0t·10^{%T}", axis,
                     fmt::join(tics, ", "));
}

Panel panel_of(WorkPrecision const& work, std::vector<Pen> const& pens, std::string const& file, bool by_time) {
  auto const coordinate = by_time ? &PrecisionPoint::cpu_seconds : &PrecisionPoint::steps;
  Panel panel;
  panel.settings = {"set logscale xy", logarithmic_axis('x', range_of(work, coordinate)),
                    logarithmic_axis('y', range_of(work, &PrecisionPoint::error))};
  for (std::size_t i = 0; i < work.lines.size(); ++i)
    panel.curves.push_back(
        fmt::format("{} index {} using {}:2 with linespoints {}", file, i, by_time ? 3 : 1, pens[i].words()));
  panel.x_label = by_time ? "CPU seconds per member" : "steps";
  return panel;
}

std::string subtitle(Family const& family, std::vector<CellLabels> const& cells, WorkPrecision const& work) {
  auto text = describe(cells.front(), constant_factors(cells));
  if (!family.members.empty()) text += (text.empty() ? "" : ", ") + family.members;
  text += fmt::format("{}t = {:.6g}", text.empty() ? "" : ", ", work.time);
  return text + (work.has_cpu_seconds() ? "" : "; CPU times were not recorded");
}

}  // namespace

FigureSheet precision_sheet(Family const& family) {
  FigureSheet sheet;
  auto const work = work_precision(family);
  if (work.lines.empty()) return sheet;
  auto const cells = cells_of(work);
  auto const pens = pens_of(cells);
  bool const has_times = work.has_cpu_seconds(), is_norm = family.components.size() > 1;
  sheet.stem = "precision-" + family.stem;
  sheet.title = fmt::format("What does precision of {} cost?", family.name);
  sheet.subtitle = subtitle(family, cells, work);
  sheet.y_label = family.error_label(is_norm ? "error norm" : "RMS error");
  for (bool const by_time : {false, true})
    if (!by_time || has_times) sheet.panels.push_back(panel_of(work, pens, gnuplot_string(sheet.data_file()), by_time));
  for (std::size_t i = 0; i < cells.size(); ++i)
    sheet.legend.push_back({"with linespoints " + pens[i].words(), label_of(cells[i], cells)});
  for (auto const& line : work.lines) sheet.data += data_block(line);
  return sheet;
}

}  // namespace brouwer
