#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/distributions.hpp"
#include "analysis/escape.hpp"
#include "analysis/figures/figure_family.hpp"

namespace brouwer {
namespace {

/// More curves than this are drawn without bands and laws: they would hide one another.
constexpr std::size_t crowded = 8;
constexpr int marks_on_a_curve = 14;
constexpr int point_types[] = {7, 5, 9, 13, 6, 4, 8, 12};

/// x/f for the x that χ²(f) does not exceed with probability p; from 30 degrees of freedom on by the cube-root
/// transformation of Wilson & Hilferty (1931), whose 10⁻⁴ no eye sees.
double relative_chi_squared(double p, double f) {
  if (f < 30) return chi_squared_quantile(p, f) / f;
  double const c = 2 / (9 * f);
  return std::pow(1 - c + gsl_cdf_ugaussian_Pinv(p) * std::sqrt(c), 3);
}

/// An interval for the RMS over M independent normal members with mean μ and variance s²: M·RMS²/s² is a noncentral χ²
/// with M degrees of freedom, here by a central one with the same first two moments (P. B. Patnaik, Biometrika 36
/// (1949) 202): f = M(1 + δ)²/(1 + 2δ), δ = μ²/s². For μ = 0 it is exact.
Interval rms_interval(double rms, double mean, double members, double confidence) {
  double const variance = rms * rms - mean * mean;
  if (!(variance > 0) || members < 2) return {rms, rms};
  double const delta = mean * mean / variance, f = members * (1 + delta) * (1 + delta) / (1 + 2 * delta);
  double const tail = (1 - confidence) / 2;
  return {rms / std::sqrt(relative_chi_squared(1 - tail, f)), rms / std::sqrt(relative_chi_squared(tail, f))};
}

/// The model of inference.hpp without bounded noise: RMS² = σ²t + (β² + τ²)t².
double fitted_rms(Estimates const& e, double t) {
  double const walk = e.diffusion.per_sqrt_step * std::sqrt(t);
  return std::hypot(walk, e.drift.per_step * t, e.persistence.per_step * t);
}

std::string data_block(Estimates const& e) {
  std::string text = fmt::format("# {}, {}\n# t  rms  rms-low  rms-high  fitted  brouwer\n", one_line(e.quantity),
                                 one_line(e.cell.method));
  for (std::size_t j = 0; j < e.times.size(); ++j) {
    double const t = e.times[j];
    auto const [low, high] = rms_interval(e.rms[j], e.mean[j], static_cast<double>(e.members), e.levels.confidence);
    text +=
        fmt::format("{} {} {} {} {} {}\n", plot_number(t), plot_number(e.rms[j]), plot_number(low), plot_number(high),
                    plot_number(fitted_rms(e, t)), plot_number(e.diffusion.per_sqrt_step * std::sqrt(t)));
  }
  return text + "\n\n";
}

/// Smallest and largest positive finite number that `values` yields for the rows, a little widened.
template <class Values>
Interval logarithmic_range(Family const& family, Values values) {
  Interval range{std::numeric_limits<double>::infinity(), 0};
  for (auto const& row : family.rows)
    for (double const x : values(*row.estimates))
      if (std::isfinite(x) && x > 0) range = {std::min(range.low, x), std::max(range.high, x)};
  if (!(range.high > 0)) return {1e-17, 1e-16};  // every error is zero: an empty panel
  return {range.low / 1.6, range.high * 1.6};
}

std::vector<std::string> settings(Family const& family) {
  auto const x = logarithmic_range(family, [](Estimates const& e) { return e.times; });
  auto const y = logarithmic_range(family, [](Estimates const& e) { return e.rms; });
  return {"set logscale xy", "set format xy '10^{%T}'", "set xrange " + plot_range(x.low, x.high),
          "set yrange " + plot_range(y.low, y.high)};
}

/// Curves of one row, the index-th block of the data file.
void add_curves(std::vector<std::string>& curves, Family const& family, std::size_t index, std::string const& file) {
  auto const& row = family.rows[index];
  bool const alone = family.cells.size() <= crowded;
  auto const& colour = family.colours[row.cell];
  auto const add = [&](char const* columns, std::string const& style) {
    curves.push_back(fmt::format("{} index {} using {} {} lc rgb '{}'", file, index, columns, style, colour));
  };
  auto const samples = row.estimates->times.size(), every = std::max<std::size_t>(samples / marks_on_a_curve, 1);
  auto const first = samples == 0 ? 0 : (samples - 1) % every;  // so that the last sample has a mark
  int const mark = point_types[static_cast<std::size_t>(family.marks[row.cell]) % std::size(point_types)];
  if (alone) {
    add("1:3:4", "with filledcurves");
    add("1:6", "with lines lw 1 dt 2");
    add("1:5", "with lines lw 1.2");
    add("1:2", fmt::format("every {}::{} with points pt {}", every, first, mark));
  } else {
    add("1:2", fmt::format("with linespoints pi {} lw 1 pt {}", every, mark));
  }
}

/// Where the curves are many: one line of slope ½ for the eye, of median σ.
std::string brouwer_guide(Family const& family) {
  std::vector<double> sigma;
  for (auto const& row : family.rows) sigma.push_back(row.estimates->diffusion.per_sqrt_step);
  std::sort(sigma.begin(), sigma.end());
  return fmt::format("{:.9g}*sqrt(x) with lines lw 1.5 dt 2 lc rgb '#555555'",
                     gsl_stats_median_from_sorted_data(sigma.data(), 1, sigma.size()));
}

Panel panel_of(Family const& family, std::size_t component, std::string const& file) {
  Panel panel;
  if (family.components.size() > 1) panel.title = family.components[component];
  panel.settings = settings(family);
  for (std::size_t i = 0; i < family.rows.size(); ++i)
    if (family.rows[i].component == component) add_curves(panel.curves, family, i, file);
  if (family.cells.size() > crowded) panel.curves.push_back(brouwer_guide(family));
  return panel;
}

std::vector<FigureSheet::LegendEntry> legend(Family const& family) {
  std::vector<FigureSheet::LegendEntry> entries;
  bool const alone = family.cells.size() <= crowded;
  for (std::size_t i = 0; i < family.cells.size(); ++i) {
    int const mark = point_types[static_cast<std::size_t>(family.marks[i]) % std::size(point_types)];
    entries.push_back(
        {fmt::format("with linespoints lw 1.2 pt {} lc rgb '{}'", mark, family.colours[i]), family.cells[i]});
  }
  if (alone) {
    entries.push_back({"with points pt 7 lc rgb '#888888'", "RMS over members"});
    entries.push_back({"with filledcurves lc rgb '#888888'",
                       fmt::format("its {:g} % band", 100 * family.rows.front().estimates->levels.confidence)});
    entries.push_back({"with lines lw 1.2 lc rgb '#888888'", "fitted √(σ²t + (β² + τ²)t²)"});
  }
  entries.push_back(
      {"with lines lw 1.5 dt 2 lc rgb '#555555'", alone ? "Brouwer's law σ√t" : "slope ½ (Brouwer's law)"});
  return entries;
}

}  // namespace

FigureSheet growth_sheet(Family const& family) {
  FigureSheet sheet;
  sheet.stem = "growth-" + family.stem;
  sheet.title = fmt::format("How does the error of {} grow?", family.name);
  sheet.subtitle = family.shared;
  sheet.x_label = family.time_label();
  sheet.y_label = family.error_label("RMS error");
  for (std::size_t c = 0; c < family.components.size(); ++c)
    sheet.panels.push_back(panel_of(family, c, gnuplot_string(sheet.data_file())));
  sheet.legend = legend(family);
  for (auto const& row : family.rows) sheet.data += data_block(*row.estimates);
  return sheet;
}

}  // namespace brouwer
