#include "analysis/causes/levels_in_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/factors.hpp"

namespace brouwer {
namespace {

std::string rounding(CellLabels const& cell) {
  if (cell.rounding == "stochastic") return "stochastic rounding";
  if (cell.rounding == "nearest") return "rounding to nearest";
  return "rounding " + (cell.rounding == "toward-zero" ? "toward zero" : cell.rounding);
}

/// The factors of the arithmetic, in the order in which they are told.
struct Words {
  char const* factor;
  std::string (*level)(CellLabels const&);
};
constexpr Words factors[] = {
    {"constants", [](CellLabels const& c) { return c.constants + " constants"; }},
    {"rounding", rounding},
    {"sum", [](CellLabels const& c) { return std::string(c.compensation ? "compensated sums" : "plain sums"); }},
    {"products",
     [](CellLabels const& c) { return std::string(c.contraction ? "fused products" : "separate products"); }},
    {"coefficients", [](CellLabels const& c) { return c.coefficients + " coefficients"; }},
    {"functions", [](CellLabels const& c) { return c.special_functions + " functions"; }},
    {"arithmetic", [](CellLabels const& c) { return c.arithmetic; }},
};

}  // namespace

std::vector<std::string> changed_factors(CellLabels const& from, CellLabels const& to) {
  std::vector<std::string> changed;
  for (auto const& words : factors)
    if (words.level(from) != words.level(to)) changed.emplace_back(words.factor);
  return changed;
}

std::string level_in_words(std::string const& factor, CellLabels const& cell) {
  auto const* const words =
      std::find_if(std::begin(factors), std::end(factors), [&](Words const& w) { return factor == w.factor; });
  return words == std::end(factors) ? factor : words->level(cell);
}

std::string changes_in_words(std::vector<std::string> const& changed, CellLabels const& cell) {
  std::vector<std::string> words;
  for (auto const& factor : changed) words.push_back(level_in_words(factor, cell));
  return enumerated(words);
}

std::string enumerated(std::vector<std::string> const& words) {
  if (words.empty()) return "";
  std::vector<std::string> const before(words.begin(), words.end() - 1);
  return before.empty() ? words.back() : fmt::format("{} and {}", fmt::join(before, ", "), words.back());
}

}  // namespace brouwer
