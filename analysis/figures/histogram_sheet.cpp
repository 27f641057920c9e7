#include <fmt/format.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/escape.hpp"
#include "analysis/figures/figure_family.hpp"
#include "analysis/increments/histogram.hpp"
#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

using Numbers = std::vector<double>;

/// Standardised values of one row, and what the standardisation took away.
struct Bars {
  Numbers z, density;
  std::string of;        ///< "64 members"
  std::string subtitle;  ///< for people
};

Bars bars_of_final_errors(Numbers const& errors) {
  double const mean = gsl_stats_mean(errors.data(), 1, errors.size());
  double const deviation = errors.size() < 2 ? 0 : gsl_stats_sd_m(errors.data(), 1, errors.size(), mean);
  Histogram histogram(errors.size());
  for (double const e : errors)
    if (deviation > 0) histogram.add((e - mean) / deviation);
  Bars bars{{},
            histogram.density(),
            fmt::format("{} members, mean {}, standard deviation {}", errors.size(), plot_number(mean),
                        plot_number(deviation)),
            fmt::format("mean {}, sd {}", number(mean, 2), number(deviation, 2))};
  for (std::size_t b = 0; b < histogram.bins(); ++b) bars.z.push_back(histogram.centre(b));
  return bars;
}

std::optional<Bars> final_errors(Family::Row const& row) {
  if (row.final_errors == nullptr) return std::nullopt;
  return bars_of_final_errors(*row.final_errors);
}

std::optional<Bars> increments(Family::Row const& row) {
  auto const& tests = row.estimates->increments;
  if (!tests) return std::nullopt;
  auto const& shape = tests->normality;
  return Bars{
      tests->histogram_z, tests->histogram_density, fmt::format("{} increments", tests->count),
      fmt::format("skewness {}, excess kurtosis {}", number(shape.skewness, 2), number(shape.excess_kurtosis, 2))};
}

/// What is shown against the normal law.
struct Shown {
  char const* stem;
  char const* question;
  char const* x_label;
  char const* legend;
  std::optional<Bars> (*bars)(Family::Row const&);
};

std::string data_block(Family::Row const& row, Bars const& bars) {
  std::string text = fmt::format("# {}, {}: {}\n# z  density\n", one_line(row.estimates->quantity),
                                 one_line(row.estimates->cell.method), bars.of);
  for (std::size_t b = 0; b < bars.z.size(); ++b) text += fmt::format("{:.6g} {:.6g}\n", bars.z[b], bars.density[b]);
  return text + "\n\n";
}

std::string style(Family const& family, Family::Row const& row) {
  bool const single = family.components.size() == 1;
  auto const colour = single ? family.colours[row.cell] : distinct_colour(row.component);
  return fmt::format("with {} lc rgb '{}'", single ? "boxes fs transparent solid 0.45 noborder" : "histeps lw 1.3",
                     colour);
}

/// One vertical range for all panels: room for the highest bin, and for the normal law's 0.399.
std::vector<std::string> settings(Family const& family, Shown const& shown) {
  double highest = 0.42;
  for (auto const& row : family.rows)
    if (auto const bars = shown.bars(row))
      for (double const h : bars->density) highest = std::max(highest, h);
  return {"set xrange [-4.2:4.2]; set xtics 2", "set yrange " + plot_range(0, 1.05 * highest),
          highest < 1 ? "set ytics 0.2" : "set ytics autofreq"};
}

std::vector<FigureSheet::LegendEntry> legend(Family const& family, Shown const& shown) {
  std::vector<FigureSheet::LegendEntry> entries;
  if (family.components.size() > 1)
    for (std::size_t c = 0; c < family.components.size(); ++c)
      entries.push_back({fmt::format("with lines lw 1.5 lc rgb '{}'", distinct_colour(c)), family.components[c]});
  else
    entries.push_back({"with boxes fs transparent solid 0.45 noborder lc rgb '#888888'", shown.legend});
  entries.push_back({"with lines lw 1.3 dt 2 lc rgb '#222222'", "normal law"});
  return entries;
}

/// A panel a cell, in which there is something to show.
void add_panels(FigureSheet& sheet, Family const& family, Shown const& shown) {
  auto const file = gnuplot_string(sheet.data_file());
  std::size_t block = 0, cell = family.cells.size();
  for (auto const& row : family.rows) {
    auto const bars = shown.bars(row);
    if (!bars) continue;
    if (row.cell != cell) {
      // With one component there is room for what the standardisation took away.
      std::string const subtitle = family.components.size() > 1 ? "" : bars->subtitle;
      sheet.panels.push_back({family.cells[row.cell], subtitle, "", settings(family, shown), {}});
      cell = row.cell;
    }
    sheet.panels.back().curves.push_back(fmt::format("{} index {} using 1:2 {}", file, block++, style(family, row)));
    sheet.data += data_block(row, *bars);
  }
  for (auto& panel : sheet.panels)
    panel.curves.emplace_back("exp(-x*x/2)/sqrt(2*pi) with lines lw 1.3 dt 2 lc rgb '#222222'");
}

FigureSheet sheet_of(Family const& family, Shown const& shown) {
  FigureSheet sheet;
  sheet.stem = shown.stem + family.stem;
  sheet.title = fmt::format(fmt::runtime(shown.question), family.name);
  sheet.subtitle = family.shared;
  sheet.x_label = shown.x_label;
  sheet.y_label = "density";
  add_panels(sheet, family, shown);
  sheet.legend = legend(family, shown);
  return sheet;
}

}  // namespace

FigureSheet histogram_sheet(Family const& family) {
  return sheet_of(family, {"histogram-", "Are the final errors of {} normal?",
                           "(error − its mean) / its standard deviation", "members' final errors", final_errors});
}

FigureSheet increments_sheet(Family const& family) {
  return sheet_of(family, {"increments-", "Are the increments of the error of {} normal?",
                           "increment less the slope so far / its standard deviation", "increments", increments});
}

}  // namespace brouwer
