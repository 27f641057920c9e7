#include "analysis/factors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace brouwer {
namespace {

using Cell = CellLabels;

/// The level of an option that only some methods have.
std::string said(std::string const& level) { return level == no_level ? "" : level; }

std::string functions(Cell const& c) { return said(c.special_functions); }
std::string coefficients(Cell const& c) { return said(c.coefficients); }
std::string step(Cell const& c) { return c.step > 0 ? fmt::format("{}", c.step) : ""; }
/// Of another program's ensemble, which has no steps, nobody knows how it was summed.
std::string sum(Cell const& c) { return c.steps == 0 ? "" : c.compensation ? "compensated" : "plain"; }
std::string steps(Cell const& c) { return c.steps > 0 ? fmt::format("{}", c.steps) : ""; }

/// The standard is not worth words: nothing is known of how the ensembles of other programs were computed.
std::string rounding(Cell const& c) {
  if (c.rounding == Cell{}.rounding) return "";
  return c.rounding == "stochastic" ? "stochastic rounding" : "rounding " + c.rounding;
}

std::string with(char const* before, std::string const& level, char const* after) {
  return level.empty() ? "" : before + level + after;
}

Factor const factors[] = {
    {"system", [](Cell const& c) { return c.system; }, [](Cell const& c) { return c.system; }},
    {"method", [](Cell const& c) { return c.method; }, [](Cell const& c) { return c.method; }},
    {"arithmetic", [](Cell const& c) { return c.arithmetic; }, [](Cell const& c) { return c.arithmetic; }},
    {"functions", functions, [](Cell const& c) { return with("", functions(c), " functions"); }},
    {"coefficients", coefficients, [](Cell const& c) { return with("", coefficients(c), " coefficients"); }},
    {"sum", sum, [](Cell const& c) { return sum(c) == "plain" ? "not compensated" : sum(c); }},
    {"rounding", [](Cell const& c) { return c.rounding; }, rounding},
    {"constants", [](Cell const& c) { return c.constants; },
     [](Cell const& c) { return std::string(c.constants == "exact" ? "exact constants" : ""); }},
    {"products", [](Cell const& c) { return std::string(c.contraction ? "fused" : "separate"); },
     [](Cell const& c) { return std::string(c.contraction ? "fused products" : ""); }},
    {"h", step, [](Cell const& c) { return with("h = ", step(c), ""); }},
    {"steps", steps, [](Cell const& c) { return with("", steps(c), " steps"); }},
};

std::set<std::string> levels(Factor const& factor, std::vector<Cell> const& cells) {
  std::set<std::string> found;
  for (auto const& cell : cells) found.insert(factor.level(cell));
  return found;
}

/// With `until` a step h has one number of steps: naming both says the same twice.
bool step_decides_steps(std::vector<Cell> const& cells) {
  std::map<double, std::int64_t> seen;
  return std::all_of(cells.begin(), cells.end(),
                     [&](Cell const& cell) { return seen.emplace(cell.step, cell.steps).first->second == cell.steps; });
}

/// Nothing is known of the cell: its missing compensation is no fact either.
bool is_anonymous(Cell const& cell) { return cell.method.empty() && cell.arithmetic.empty(); }

}  // namespace

std::span<Factor const> all_factors() { return factors; }

std::vector<CellLabels> cells_of(std::vector<Estimates> const& rows) {
  std::vector<CellLabels> cells;
  for (auto const& row : rows) cells.push_back(row.cell);
  return cells;
}

Factors varying_factors(std::vector<CellLabels> const& cells) {
  Factors varying;
  for (auto const& factor : factors) {
    bool const redundant = factor.level == &steps && step_decides_steps(cells);
    if (levels(factor, cells).size() > 1 && !redundant) varying.push_back(&factor);
  }
  return varying;
}

Factors constant_factors(std::vector<CellLabels> const& cells) {
  Factors constant;
  if (cells.empty() || std::all_of(cells.begin(), cells.end(), is_anonymous)) return constant;
  for (auto const& factor : factors) {
    auto const found = levels(factor, cells);
    if (found.size() == 1 && !found.begin()->empty()) constant.push_back(&factor);
  }
  return constant;
}

std::string describe(CellLabels const& cell, Factors const& chosen) {
  std::string text;
  for (auto const* factor : chosen)
    if (auto const words = factor->in_words(cell); !words.empty()) text += (text.empty() ? "" : ", ") + words;
  return text;
}

std::string describe(CellLabels const& cell) {
  auto const text = describe(cell, constant_factors({cell}));
  return text.empty() ? "ensemble" : text;
}

std::string brief(CellLabels const& cell, bool with_step) {
  static std::set<std::string> const unsaid = {"system", "steps"},
                                     usual = {"own", "per-step", "plain", "nearest", "rounded", "separate"};
  Factors telling;
  for (auto const& factor : factors) {
    bool const is_step = factor.level == &step;
    if (!unsaid.contains(factor.name) && !usual.contains(factor.level(cell)) && (with_step || !is_step))
      telling.push_back(&factor);
  }
  return describe(cell, telling);
}

std::string short_label(CellLabels const& cell, Factors const& varying) {
  auto const text = describe(cell, varying);
  return text.empty() ? describe(cell) : text;
}

}  // namespace brouwer
