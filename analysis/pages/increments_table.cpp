#include "analysis/pages/increments_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/expectations/decision.hpp"
#include "analysis/factors.hpp"
#include "analysis/increments/increments_objection.hpp"

namespace brouwer {
namespace {

using Rows = std::vector<Estimates>;

struct Column {
  char const* heading;
  std::string (*cell)(Estimates const&);
};

std::string bare_p(double p) { return p < 1e-300 ? "< 1e-300" : number(p, 2); }

std::string at(VarianceRatio const& ratio) {
  return fmt::format("{} at {}", measured(ratio.ratio, ratio.interval), number(ratio.scale, 2));
}

std::string clearest(std::vector<VarianceRatio> const& scales) {
  return scales.empty() ? "–" : at(clearest_ratio(scales));
}

std::string first_correlation(IncrementTests const& tests) {
  auto const& lags = tests.autocorrelations;
  return lags.empty() ? "–" : measured(lags.front().rho, lags.front().interval);
}

std::string first_p(IncrementTests const& tests) {
  return tests.autocorrelations.empty() ? "–" : bare_p(tests.autocorrelations.front().p);
}

constexpr Column increments[] = {
    {"increments", [](Estimates const& e) { return fmt::format("{}", e.increments->count); }},
    {"ρ₁", [](Estimates const& e) { return first_correlation(*e.increments); }},
    {"p", [](Estimates const& e) { return first_p(*e.increments); }},
    {"clearest variance ratio", [](Estimates const& e) { return clearest(e.increments->variance_ratios); }},
    {"p of all", [](Estimates const& e) { return bare_p(e.increments->variance_ratio_p); }},
    {"skewness", [](Estimates const& e) { return number(e.increments->normality.skewness, 2); }},
    {"excess kurtosis", [](Estimates const& e) { return number(e.increments->normality.excess_kurtosis, 2); }},
    {"A²", [](Estimates const& e) { return number(e.increments->normality.anderson_darling, 2); }},
    {"p", [](Estimates const& e) { return bare_p(e.increments->normality.p); }},
};

constexpr Column decisions[] = {
    {"seen with 50 %", [](Estimates const& e) { return number(drift_seen_with(0.5, e), 2); }},
    {"90 %", [](Estimates const& e) { return number(drift_seen_with(0.9, e), 2); }},
    {"99 %", [](Estimates const& e) { return number(drift_seen_with(0.99, e), 2); }},
    {"|β| proven below", [](Estimates const& e) { return number(smallest_provable_drift(e), 2); }},
    {"p of β = 0", [](Estimates const& e) { return bare_p(e.drift.own_p()); }},
    {"adjusted", [](Estimates const& e) { return e.drift.p_alone ? bare_p(e.drift.p) : "–"; }},
};

/// A table of these columns, beside what tells the rows apart.
template <std::size_t n>
GrowthTable table_of(Rows const& rows, Column const (&columns)[n], CellsAs layout) {
  GrowthTable table;
  auto const factors = varying_factors(cells_of(rows));
  bool const names_cell = layout == CellsAs::columns && !factors.empty();
  if (names_cell) table.headings.push_back({"cell", true});
  table.headings.push_back({"error of", true});
  for (auto const& column : columns) table.headings.push_back({column.heading, false});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto const cell = short_label(rows[i].cell, factors);
    std::vector<std::string> words;
    if (names_cell) words.push_back(cell);
    words.push_back(rows[i].quantity);
    for (auto const& column : columns) words.push_back(column.cell(rows[i]));
    table.rows.push_back({cell, words, i == 0 || !(rows[i].cell == rows[i - 1].cell)});
  }
  return table;
}

template <class Chosen>
Rows only(Rows rows, Chosen chosen) {
  rows.erase(std::remove_if(rows.begin(), rows.end(), [&](auto const& row) { return !chosen(row); }), rows.end());
  return rows;
}

}  // namespace

GrowthTable increments_table(Rows const& all, CellsAs layout) {
  auto const rows = only(all, [](Estimates const& e) { return e.increments.has_value(); });
  auto table = table_of(rows, increments, layout);
  table.legend = {
      "ρ₁: correlation of increments that follow one another; 0 for a walk. ± is half an interval over members.",
      fmt::format(
          "clearest variance ratio: variance of increments over so many {}s, per {}, over that of the single ones "
          "in them; 1 for a walk. p is of the ratios at all scales (Holm).",
          rows.empty() ? "step" : rows.front().time_unit, rows.empty() ? "step" : rows.front().time_unit),
      "A²: Anderson–Darling, of normal increments. A small p beside small effects says that the ensemble is large."};
  return table;
}

GrowthTable decisions_table(Rows const& all, CellsAs layout) {
  auto const rows = only(all, [](Estimates const& e) { return std::isfinite(e.drift.p); });
  auto table = table_of(rows, decisions, layout);
  if (rows.empty()) return table;
  auto const& levels = rows.front().levels;
  table.legend = {
      fmt::format(
          "Tests at level {:g}: with this chance a walk is called a drift. A drift of the size that is seen with "
          "90 % is missed with 10 %. Per {}.",
          levels.test, rows.front().time_unit),
      fmt::format("|β| proven below: the smallest bound for which two one-sided tests at level {:g} prove |β| smaller.",
                  levels.test)};
  auto const correction = levels.correction.value_or(Correction::none);
  if (correction != Correction::none)
    table.legend.push_back(
        fmt::format("adjusted: p corrected for {} drifts ({}).", rows.size(), to_string(correction)));
  return table;
}

}  // namespace brouwer
