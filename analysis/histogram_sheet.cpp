#include <fmt/format.h>
#include <gsl/gsl_histogram.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "analysis/escape.hpp"
#include "analysis/figure_family.hpp"
#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

using Errors = std::vector<double>;

struct Moments {
  double mean, deviation;
};

Moments moments(Errors const& errors) {
  double const mean = gsl_stats_mean(errors.data(), 1, errors.size());
  double const deviation = errors.size() < 2 ? 0 : gsl_stats_sd_m(errors.data(), 1, errors.size(), mean);
  return {mean, deviation};
}

/// Rice's rule, 2 n^⅓, for the part of the axis that holds nearly all of a normal sample; the range is −4 … 4.
std::size_t bins_for(std::size_t n) {
  auto const rice = static_cast<std::size_t>(2 * std::cbrt(static_cast<double>(n)) * 8 / 5);
  return std::clamp<std::size_t>(rice | 1u, 9, 81);  // odd: one bin is centred on the mean
}

/// Density of the standardised errors in equal bins; what lies beyond ±4 counts in the outermost bins.
Errors density(Errors const& errors, std::size_t bins) {
  auto const [mean, deviation] = moments(errors);
  std::unique_ptr<gsl_histogram, decltype(&gsl_histogram_free)> const histogram(gsl_histogram_alloc(bins),
                                                                                gsl_histogram_free);
  gsl_histogram_set_ranges_uniform(histogram.get(), -4, 4);
  for (double const e : errors)
    if (deviation > 0) gsl_histogram_increment(histogram.get(), std::clamp((e - mean) / deviation, -3.999, 3.999));
  double const width = 8.0 / static_cast<double>(bins);
  gsl_histogram_scale(histogram.get(), 1 / (width * static_cast<double>(errors.size())));
  return {histogram->bin, histogram->bin + bins};
}

std::string data_block(Family::Row const& row) {
  auto const& e = *row.estimates;
  auto const& errors = *row.final_errors;
  auto const bins = bins_for(errors.size());
  auto const heights = density(errors, bins);
  auto const [mean, deviation] = moments(errors);
  double const width = 8.0 / static_cast<double>(bins);
  std::string text =
      fmt::format("# {}, {}: {} members, mean {}, standard deviation {}\n# z  density\n", one_line(e.quantity),
                  one_line(e.cell.method), errors.size(), plot_number(mean), plot_number(deviation));
  for (std::size_t b = 0; b < bins; ++b)
    text += fmt::format("{:.6g} {:.6g}\n", -4 + width * (static_cast<double>(b) + 0.5), heights[b]);
  return text + "\n\n";
}

/// With one component there is room for what the standardisation took away.
std::string subtitle(Family const& family, Family::Row const& row) {
  if (family.components.size() > 1) return "";
  auto const [mean, deviation] = moments(*row.final_errors);
  return fmt::format("mean {}, sd {}", number(mean, 2), number(deviation, 2));
}

std::string style(Family const& family, Family::Row const& row) {
  bool const single = family.components.size() == 1;
  auto const colour = single ? family.colours[row.cell] : distinct_colour(row.component);
  return fmt::format("with {} lc rgb '{}'", single ? "boxes fs transparent solid 0.45 noborder" : "histeps lw 1.3",
                     colour);
}

/// One vertical range for all panels: room for the highest bin, and for the normal law's 0.399.
std::vector<std::string> settings(Family const& family) {
  double highest = 0.42;
  for (auto const& row : family.rows)
    if (row.final_errors != nullptr)
      for (double const h : density(*row.final_errors, bins_for(row.final_errors->size())))
        highest = std::max(highest, h);
  return {"set xrange [-4.2:4.2]; set xtics 2", "set yrange " + plot_range(0, 1.05 * highest),
          highest < 1 ? "set ytics 0.2" : "set ytics autofreq"};
}

std::vector<FigureSheet::LegendEntry> legend(Family const& family) {
  std::vector<FigureSheet::LegendEntry> entries;
  if (family.components.size() > 1)
    for (std::size_t c = 0; c < family.components.size(); ++c)
      entries.push_back({fmt::format("with lines lw 1.5 lc rgb '{}'", distinct_colour(c)), family.components[c]});
  else
    entries.push_back({"with boxes fs transparent solid 0.45 noborder lc rgb '#888888'", "members' final errors"});
  entries.push_back({"with lines lw 1.3 dt 2 lc rgb '#222222'", "normal law"});
  return entries;
}

}  // namespace

FigureSheet histogram_sheet(Family const& family) {
  FigureSheet sheet;
  sheet.stem = "histogram-" + family.stem;
  sheet.title = fmt::format("Are the final errors of {} normal?", family.name);
  sheet.subtitle = family.shared;
  sheet.x_label = "(error − its mean) / its standard deviation";
  sheet.y_label = "density";
  auto const file = gnuplot_string(sheet.data_file());
  std::size_t block = 0, cell = family.cells.size();
  for (auto const& row : family.rows) {
    if (row.final_errors == nullptr) continue;
    if (row.cell != cell) {
      sheet.panels.push_back({family.cells[row.cell], subtitle(family, row), "", settings(family), {}});
      cell = row.cell;
    }
    sheet.panels.back().curves.push_back(fmt::format("{} index {} using 1:2 {}", file, block++, style(family, row)));
    sheet.data += data_block(row);
  }
  for (auto& panel : sheet.panels)
    panel.curves.emplace_back("exp(-x*x/2)/sqrt(2*pi) with lines lw 1.3 dt 2 lc rgb '#222222'");
  sheet.legend = legend(family);
  return sheet;
}

}  // namespace brouwer
