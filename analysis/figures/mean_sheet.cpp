#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "analysis/distributions.hpp"
#include "analysis/escape.hpp"
#include "analysis/figures/figure_family.hpp"
#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

/// Standard errors that an interval of Student's law reaches to each side.
double reach(Estimates const& e) {
  return e.members < 2 ? 0 : student_upper_quantile((1 - e.levels.confidence) / 2, static_cast<double>(e.members - 1));
}

std::string data_block(Estimates const& e) {
  std::string text =
      fmt::format("# {}, {}\n# t  mean  low  high  drift\n0 0 0 0 0\n", one_line(e.quantity), one_line(e.cell.method));
  double const k = reach(e);
  for (std::size_t j = 0; j < e.times.size(); ++j)
    text += fmt::format("{} {} {} {} {}\n", plot_number(e.times[j]), plot_number(e.mean[j]),
                        plot_number(e.mean[j] - k * e.mean_error[j]), plot_number(e.mean[j] + k * e.mean_error[j]),
                        plot_number(e.drift.per_step * e.times[j]));
  return text + "\n\n";
}

/// All bands of a cell's components, and zero, with a little room.
Interval vertical_range(Family const& family, std::size_t cell) {
  Interval range{0, 0};
  for (auto const& row : family.rows) {
    if (row.cell != cell) continue;
    auto const& e = *row.estimates;
    for (std::size_t j = 0; j < e.mean.size(); ++j) {
      double const half = reach(e) * e.mean_error[j];
      if (std::isfinite(e.mean[j]) && std::isfinite(half))
        range = {std::min(range.low, e.mean[j] - half), std::max(range.high, e.mean[j] + half)};
    }
  }
  double const room = 0.06 * (range.high - range.low);
  return {range.low - room, range.high + room};
}

std::string colour_of(Family const& family, Family::Row const& row) {
  return family.components.size() == 1 ? family.colours[row.cell] : distinct_colour(row.component);
}

double last_time(Family const& family) {
  double last = 0;
  for (auto const& row : family.rows)
    if (!row.estimates->times.empty()) last = std::max(last, row.estimates->times.back());
  return last;
}

std::string superscript(int n) {
  static constexpr char const* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = n < 0 ? "⁻" : "";
  for (char const c : std::to_string(std::abs(n))) text += digits[c - '0'];
  return text;
}

/// The power of ten that the vertical axis leaves out, so that its numbers are short.
int power_of(Interval range) {
  double const largest = std::max(std::abs(range.low), std::abs(range.high));
  return largest > 1e-300 && std::isfinite(largest) ? static_cast<int>(std::floor(std::log10(largest))) : 0;
}

std::vector<std::string> settings(Family const& family, Interval range, int power) {
  double const last = last_time(family), unit = std::pow(10.0, power);
  return {"set xrange " + plot_range(0, last), "set yrange " + plot_range(range.low / unit, range.high / unit),
          last > 0 ? fmt::format("set xtics {:g}", tic_distance(last)) : "set xtics autofreq",
          fmt::format("set format x '{}'; set format y '%g'", last < 1e5 ? "%g" : "%.1h"),
          "set ytics autofreq; set xzeroaxis lw 1 lt 1 lc rgb '#444444'"};
}

/// Curves of one row, the index-th block of the data file.
void add_curves(Panel& panel, std::string const& block, std::string const& colour, int power, bool pale) {
  auto const add = [&](std::string const& columns, char const* style) {
    panel.curves.push_back(fmt::format("{} using {} {} lc rgb '{}'", block, columns, style, colour));
  };
  auto const scaled = [&](int column) { return fmt::format("(${}*1e{})", column, -power); };
  add("1:" + scaled(3) + ":" + scaled(4), pale ? "with filledcurves fs transparent solid 0.07" : "with filledcurves");
  add("1:" + scaled(2), "with lines lw 1.6");
  add("1:" + scaled(5), "with lines lw 1 dt 2");
}

Panel panel_of(Family const& family, std::size_t cell, std::string const& file) {
  auto const range = vertical_range(family, cell);
  int const power = power_of(range);
  Panel panel{family.cells[cell], "", power == 0 ? "" : "×10" + superscript(power), settings(family, range, power), {}};
  for (std::size_t i = 0; i < family.rows.size(); ++i) {
    auto const& row = family.rows[i];
    if (row.cell != cell) continue;
    add_curves(panel, fmt::format("{} index {}", file, i), colour_of(family, row), power, family.components.size() > 3);
    auto const& drift = row.estimates->drift;
    if (family.components.size() == 1)
      panel.subtitle = fmt::format("β = {}, t = {}", measured(drift.per_step, drift.interval), number(drift.t, 3));
  }
  return panel;
}

std::vector<FigureSheet::LegendEntry> legend(Family const& family) {
  std::vector<FigureSheet::LegendEntry> entries;
  if (family.components.size() > 1)
    for (std::size_t c = 0; c < family.components.size(); ++c)
      entries.push_back({fmt::format("with lines lw 1.6 lc rgb '{}'", distinct_colour(c)), family.components[c]});
  double const percent = 100 * family.rows.front().estimates->levels.confidence;
  entries.push_back({"with lines lw 1.6 lc rgb '#888888'", "mean over members"});
  entries.push_back({"with filledcurves lc rgb '#888888'", fmt::format("its {:g} % interval", percent)});
  entries.push_back({"with lines lw 1 dt 2 lc rgb '#888888'", "fitted drift βt"});
  return entries;
}

}  // namespace

FigureSheet mean_sheet(Family const& family) {
  FigureSheet sheet;
  sheet.stem = "mean-" + family.stem;
  sheet.title = fmt::format("Does the mean error of {} drift?", family.name);
  sheet.subtitle = family.shared;
  sheet.x_label = family.time_label();
  sheet.y_label = family.error_label("mean error");
  for (std::size_t c = 0; c < family.cells.size(); ++c)
    sheet.panels.push_back(panel_of(family, c, gnuplot_string(sheet.data_file())));
  sheet.legend = legend(family);
  for (auto const& row : family.rows) sheet.data += data_block(*row.estimates);
  return sheet;
}

}  // namespace brouwer
