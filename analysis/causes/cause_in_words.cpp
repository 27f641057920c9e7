#include "analysis/causes/cause_in_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/causes/causes.hpp"
#include "analysis/causes/evidence.hpp"
#include "analysis/causes/levels_in_words.hpp"
#include "analysis/causes/remainder.hpp"
#include "analysis/numbers.hpp"
#include "analysis/verdict/phrases.hpp"

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
      {Cause::truncation, "is the method's own, a truncation error", {Change::higher_precision}},
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
      {Cause::needs_constants, "needs the rounded constants", {Change::constants}},
      {Cause::needs_rounding, "needs rounding errors that are alike in every step", {Change::unbiased_rounding}},
      {Cause::coefficients, "comes from the method's coefficients", {Change::coefficients}},
      {Cause::functions, "comes from the special functions", {Change::functions}},
      {Cause::summation, "comes from adding the increments", {Change::sum}},
      {Cause::contraction, "depends on how products are rounded before they are added", {Change::products}},
      {Cause::unnamed,
       "is round-off, but of none of these causes",
       {Change::higher_precision, Change::constants, Change::unbiased_rounding, Change::constants_and_rounding}},
      {Cause::round_off, "is round-off", {Change::higher_precision}},
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

Cells with_remainder(Cells cells, Remainder remainder, Subject subject) {
  std::erase_if(cells, [&](auto const* cell) { return remainder_of(left_of(*cell, subject)) != remainder; });
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
  auto const gone = with_remainder(others, Remainder::gone, e.subject),
             there = with_remainder(others, Remainder::there, e.subject),
             unknown = with_remainder(others, Remainder::unknown, e.subject);
  std::string text;
  if (!gone.empty()) text += fmt::format(" It also {}.", said(gone, e.subject));
  if (!there.empty()) text += fmt::format(" Most of it stays with {}.", names_of(there));
  if (!unknown.empty()) text += fmt::format(" Whether it stays with {} is not resolved.", names_of(unknown));
  return text;
}

/// The changes by which the causes in every operation are told from one another.
constexpr Change telling[] = {Change::constants, Change::unbiased_rounding, Change::constants_and_rounding,
                              Change::higher_precision};

/// Members that would bring the widest interval among these to ±25 %; none where the nominal drift is not told from 0.
std::optional<double> members_needed(Explanation const& e) {
  Evidence const evidence(e, e.subject);
  double widest = 0;
  for (auto const change : telling)
    if (auto const* const cell = evidence.cell(change); cell && evidence.remainder(change) == Remainder::unknown) {
      auto const& [low, high] = left_of(*cell, e.subject).interval;
      widest = std::max(widest, (high - low) / 2);
    }
  if (!(widest > 0.25) || !std::isfinite(widest)) return std::nullopt;
  return static_cast<double>(e.members) * std::pow(widest / 0.25, 2);
}

std::string more_members(Explanation const& e) {
  auto const members = members_needed(e);
  return members ? fmt::format("; about {} members would tell more", number(*members, 2)) : "";
}

std::string unresolved(Explanation const& e) {
  return fmt::format("{}: where it comes from is not resolved{}.", noun(e.subject), more_members(e)) +
         others_in_words(e, {});
}

/// Nothing that asks for a cause: no drift is seen, or there are errors of another kind, of which the nominal sentence says.
std::string nothing(Explanation const& e) {
  auto const& nominal = e.nominal;
  if (nominal.members < 2 || e.members < 2) return "There is nothing to compare. " + nominal.sentence;
  auto const& [low, high] = nominal.drift.interval;
  if (nominal.verdict != Verdict::random_walk || !(low <= 0 && 0 <= high))
    return "There is no cause to ask for. " + nominal.sentence;
  return fmt::format("There is no drift to explain: {}). One of {}{} would have been seen with a chance of {}.",
                     drift_interval(nominal.drift, nominal), brief(nominal.smallest_visible_drift), per(nominal),
                     percent(nominal.levels.power));
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

/// Why it is not known more exactly, where one of two remedies is enough.
std::string open_question(Explanation const& e, Change other, char const* remedy, char const* alone) {
  auto const* const cell = Evidence(e, e.subject).cell(other);
  if (!cell) return fmt::format(" Whether {} was not asked: there is no cell with {}.", alone, remedy);
  return fmt::format(" Whether {} is not resolved{}: with {} it {}.", alone, more_members(e), remedy,
                     in_words(left_of(*cell, e.subject)));
}

/// Effects of the two causes that do not add up.
std::string interaction(Explanation const& e) {
  Evidence const evidence(e, e.subject);
  double const sum = left_of(*evidence.cell(Change::constants), e.subject).value +
                     left_of(*evidence.cell(Change::unbiased_rounding), e.subject).value;
  auto const both =
      std::find_if(e.effects.begin(), e.effects.end(), [](auto const& effect) { return effect.factors.size() == 2; });
  bool const seen = both != e.effects.end() && both->drift.p < 0.05 && e.subject == Subject::drift;
  return seen ? fmt::format(" They do not add up: the sum of the two would be {}.", percent(sum)) : "";
}

/// What belongs to one cause alone.
std::string remark(Explanation const& e) {
  switch (e.cause) {
    case Cause::needs_constants:
      return open_question(e, Change::unbiased_rounding, "stochastic rounding",
                           "they make it by themselves or only under rounding errors that are alike in every step");
    case Cause::needs_rounding:
      return open_question(e, Change::constants, "exact constants",
                           "they make it by themselves or only of rounded constants");
    case Cause::constants_and_rounding:
      return interaction(e);
    case Cause::round_off:
      return fmt::format(" Which operation makes it is not resolved{}.", more_members(e));
    default:
      return "";
  }
}

/// Of a truncation error that round-off adds to, or takes from.
char const* mostly(Explanation const& e, Cells const& cells) {
  bool const whole = e.cause != Cause::truncation || in_a_word(left_of(*cells.front(), e.subject)) == "stays";
  return whole ? "" : ", for the most part";
}

/// … and in the remark.
Cells told_by(Explanation const& e, Cells cells) {
  if (e.cause != Cause::needs_constants && e.cause != Cause::needs_rounding) return cells;
  auto const in_remark = shown_by(e, {std::begin(telling), std::end(telling)});
  cells.insert(cells.end(), in_remark.begin(), in_remark.end());
  return cells;
}

std::string named(Explanation const& e) {
  auto const saying =
      std::find_if(sayings().begin(), sayings().end(), [&](auto const& s) { return s.cause == e.cause; });
  auto const cells = shown_by(e, saying->shown_by);
  std::string const text = fmt::format("{} {}{}: it {}.{}", noun(e.subject), saying->words, mostly(e, cells),
                                       said(cells, e.subject), remark(e));
  return e.cause == Cause::truncation ? text : text + others_in_words(e, told_by(e, cells));
}

std::string cause_alone(Explanation const& e) {
  if (e.cause == Cause::none_seen) return nothing(e);
  return e.cause == Cause::not_resolved ? unresolved(e) : named(e);
}

}  // namespace

std::string cause_in_words(Explanation const& e) { return cause_alone(e) + diffusion_in_words(e); }

}  // namespace brouwer
