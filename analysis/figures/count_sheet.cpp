// A number of something, iterations per step say, in the course of a run.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/escape.hpp"
#include "analysis/figures/figure_family.hpp"
#include "analysis/verdict/verdict.hpp"

namespace brouwer {
namespace {

/// Standard deviation over members at one sample.
double deviation(Estimates const& e, std::size_t sample) {
  double const variance = e.rms[sample] * e.rms[sample] - e.mean[sample] * e.mean[sample];
  return std::sqrt(std::max(variance, 0.0));
}

std::string data_block(Estimates const& e) {
  std::string text =
      fmt::format("# {}, {}\n# t  mean  mean-sd  mean+sd\n", one_line(e.quantity), one_line(e.cell.method));
  for (std::size_t j = 0; j < e.times.size(); ++j)
    text += fmt::format("{} {} {} {}\n", plot_number(e.times[j]), plot_number(e.mean[j]),
                        plot_number(e.mean[j] - deviation(e, j)), plot_number(e.mean[j] + deviation(e, j)));
  return text + "\n\n";
}

/// Of the times, and of the numbers with their deviations and 0.
std::pair<Interval, Interval> ranges(Family const& family) {
  Interval times{1, 1}, numbers{0, 0};
  for (auto const& row : family.rows) {
    auto const& e = *row.estimates;
    times = {std::min(times.low, e.times.front()), std::max(times.high, e.times.back())};
    for (std::size_t j = 0; j < e.times.size(); ++j)
      numbers = {std::min(numbers.low, e.mean[j] - deviation(e, j)),
                 std::max(numbers.high, e.mean[j] + deviation(e, j))};
  }
  return {times, {1.08 * numbers.low, 1.08 * numbers.high}};
}

Panel panel_of(Family const& family, std::size_t component, std::string const& file) {
  auto const [times, numbers] = ranges(family);
  Panel panel;
  if (family.components.size() > 1) panel.title = family.components[component];
  panel.settings = {"set logscale x", "set format x '10^{%T}'", "set xrange " + plot_range(times.low, times.high),
                    "set yrange " + plot_range(numbers.low, numbers.high)};
  for (std::size_t i = 0; i < family.rows.size(); ++i) {
    auto const& row = family.rows[i];
    if (row.component != component) continue;
    auto const add = [&](char const* columns, char const* style) {
      panel.curves.push_back(
          fmt::format("{} index {} using {} {} lc rgb '{}'", file, i, columns, style, family.colours[row.cell]));
    };
    add("1:3:4", "with filledcurves");
    add("1:2", "with lines lw 1.6");
  }
  return panel;
}

}  // namespace

FigureSheet count_sheet(Family const& family) {
  FigureSheet sheet;
  sheet.stem = "count-" + family.stem;
  sheet.title = fmt::format("How many {}?", counted_things(*family.rows.front().estimates));
  sheet.subtitle = family.shared;
  sheet.x_label = family.time_label();
  sheet.y_label = counted_things(*family.rows.front().estimates);
  for (std::size_t c = 0; c < family.components.size(); ++c)
    sheet.panels.push_back(panel_of(family, c, gnuplot_string(sheet.data_file())));
  for (std::size_t i = 0; i < family.cells.size(); ++i)
    sheet.legend.push_back({fmt::format("with lines lw 1.6 lc rgb '{}'", family.colours[i]), family.cells[i]});
  sheet.legend.push_back({"with lines lw 1.6 lc rgb '#888888'", "mean over members"});
  sheet.legend.push_back({"with filledcurves lc rgb '#888888'", "± their standard deviation"});
  for (auto const& row : family.rows) sheet.data += data_block(*row.estimates);
  return sheet;
}

}  // namespace brouwer
