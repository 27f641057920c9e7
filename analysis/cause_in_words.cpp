#include "analysis/cause_in_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/causes.hpp"
#include "analysis/evidence.hpp"
#include "analysis/fate.hpp"
#include "analysis/levels_in_words.hpp"
#include "analysis/numbers.hpp"
#include "analysis/phrases.hpp"

namespace brouwer {
namespace {

using Cells = std::vector<ComparedCell const*>;

char const* noun(Subject subject) {
  if (subject == Subject::drift) return "The drift";
  return subject == Subject::slopes ? "The spread of the slopes" : "The error";
}

/// How a cause is said, and by which changes it is shown.
struct Saying {
  Cause cause;
  char const* words;  ///< after the noun
  std::vector<Change> shown_by;
};

std::vector<Saying> const& sayings() {
  static std::vector<Saying> const all = {
      {Cause::truncation, "is the method's own, a truncation error and not round-off", {Change::higher_precision}},
      {Cause::rounding_mode, "comes from the directed rounding", {Change::nearest_for_directed}},
      {Cause::constants, "comes from the rounded constants", {Change::unbiased_rounding, Change::constants}},
      {Cause::repeated_rounding,
       "comes from rounding errors that are alike in every step, not from the constants",
       {Change::constants, Change::unbiased_rounding}},
      {Cause::constants_or_rounding,
       "comes from what rounding to nearest makes of the rounded constants, and it takes both",
       {Change::constants, Change::unbiased_rounding}},
      {Cause::constants_and_rounding,
       "has two causes, the rounded constants and rounding errors that are alike in every step, and each alone makes "
       "one",
       {Change::unbiased_rounding, Change::constants, Change::constants_and_rounding}},
      {Cause::coefficients, "comes from the method's coefficients", {Change::coefficients}},
      {Cause::functions, "comes from the special functions", {Change::functions}},
      {Cause::summation, "comes from adding the increments", {Change::sum}},
      {Cause::contraction, "depends on how products are rounded before they are added", {Change::products}},
  };
  return all;
}

/// "it persists (97 … 103 %) with stochastic rounding and vanishes (−2 … 1 %) with exact constants"
std::string said(Cells const& cells, Subject subject) {
  std::vector<std::string> parts;
  for (auto const* cell : cells)
    parts.push_back(
        fmt::format("{} with {}", in_words(left_of(*cell, subject)), changes_in_words(cell->changed, cell->cell)));
  return enumerated(parts);
}

Cells shown_by(Explanation const& e, std::vector<Change> const& changes) {
  Evidence const evidence(e, e.subject);
  Cells cells;
  for (auto const change : changes)
    if (auto const* const cell = evidence.cell(change)) cells.push_back(cell);
  return cells;
}

/// Changes of one factor, but for those that answer another question: how much a directed rounding or less precision does.
bool is_told(ComparedCell const& cell, Explanation const& e) {
  bool const directed = cell.cell.rounding != "nearest" && cell.cell.rounding != "stochastic";
  return cell.changed.size() == 1 && cell.bits == e.bits && !(directed && cell.changed.front() == "rounding");
}

Cells with_fate(Cells cells, Fate fate, Subject subject) {
  std::erase_if(cells, [&](auto const* cell) { return fate_of(left_of(*cell, subject)) != fate; });
  return cells;
}

std::string names_of(Cells const& cells) {
  std::vector<std::string> names;
  for (auto const* cell : cells) names.push_back(changes_in_words(cell->changed, cell->cell));
  return enumerated(names);
}

/// What else takes it away, and in few words what does not.
std::string others_in_words(Explanation const& e, Cells const& told) {
  Cells others;
  for (auto const& cell : e.cells)
    if (is_told(cell, e) && std::find(told.begin(), told.end(), &cell) == told.end()) others.push_back(&cell);
  auto const gone = with_fate(others, Fate::gone, e.subject), there = with_fate(others, Fate::there, e.subject),
             unknown = with_fate(others, Fate::unknown, e.subject);
  std::string text;
  if (!gone.empty()) text += fmt::format(" It also {}.", said(gone, e.subject));
  if (!there.empty()) text += fmt::format(" Most of it stays with {}.", names_of(there));
  if (!unknown.empty()) text += fmt::format(" Whether it stays with {} is not resolved.", names_of(unknown));
  return text;
}

/// Members that would bring the widest interval in question to ±25 %; none where even the nominal drift is not told from 0.
std::optional<double> members_needed(Explanation const& e) {
  double widest = 0;
  for (auto const& cell : e.cells) {
    auto const& left = left_of(cell, e.subject);
    if (cell.bits == e.bits && fate_of(left) == Fate::unknown)
      widest = std::max(widest, (left.interval.high - left.interval.low) / 2);
  }
  if (!(widest > 0) || !std::isfinite(widest)) return std::nullopt;
  return static_cast<double>(e.members) * std::pow(std::max(widest / 0.25, 1.0), 2);
}

std::string unresolved(Explanation const& e) {
  std::string text = fmt::format("{}: where it comes from is not resolved", noun(e.subject));
  if (e.members < 2) return text + "; its cells have fewer than 2 members in common.";
  if (auto const members = members_needed(e); members && *members > static_cast<double>(e.members))
    text += fmt::format("; about {} members would tell more", number(*members, 1));
  return text + "." + others_in_words(e, {});
}

/// Nothing that asks for a cause.
std::string nothing(Explanation const& e) {
  auto const& nominal = e.nominal;
  if (nominal.members < 2 || e.members < 2 || nominal.verdict == Verdict::exact)
    return "There is nothing to compare. " + nominal.sentence;
  return fmt::format(
      "There is no drift to explain: {}).{}", drift_interval(nominal.drift, nominal),
      std::isfinite(nominal.smallest_visible_drift)
          ? fmt::format(" One of {}{} would have been seen with a chance of {}.", brief(nominal.smallest_visible_drift),
                        per(nominal), percent(nominal.levels.power))
          : "");
}

/// By how much σ changes, where it is more than a factor of two.
std::string diffusion_in_words(Explanation const& e) {
  std::vector<std::string> parts;
  for (auto const& cell : e.cells) {
    auto const& [ratio, interval] = cell.diffusion_left;
    if (!is_told(cell, e) || !(interval.high < 0.5 || interval.low > 2)) continue;
    std::string const by = ratio > 1 ? fmt::format("multiplied by {}", number(ratio, 3))
                                     : fmt::format("divided by {}", number(1 / ratio, 3));
    parts.push_back(fmt::format("{} with {}", by, changes_in_words(cell.changed, cell.cell)));
  }
  return parts.empty() ? "" : fmt::format(" σ is {}.", enumerated(parts));
}

std::string unnamed(Explanation const& e) {
  return fmt::format(
      "{} has none of these causes: it {}.", noun(e.subject),
      said(shown_by(e, {Change::constants, Change::unbiased_rounding, Change::constants_and_rounding}), e.subject));
}

std::string named(Explanation const& e) {
  auto const saying =
      std::find_if(sayings().begin(), sayings().end(), [&](auto const& s) { return s.cause == e.cause; });
  auto const cells = shown_by(e, saying->shown_by);
  return fmt::format("{} {}: it {}.{}", noun(e.subject), saying->words, said(cells, e.subject),
                     e.cause == Cause::truncation ? "" : others_in_words(e, cells));
}

std::string cause_alone(Explanation const& e) {
  switch (e.cause) {
    case Cause::none_seen:
      return nothing(e);
    case Cause::not_resolved:
      return unresolved(e);
    case Cause::unnamed:
      return unnamed(e);
    default:
      return named(e);
  }
}

}  // namespace

std::string cause_in_words(Explanation const& e) { return cause_alone(e) + diffusion_in_words(e); }

}  // namespace brouwer
