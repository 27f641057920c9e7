#include "analysis/expectations/expectations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <cmath>
#include <set>

#include "analysis/escape.hpp"
#include "analysis/expectations/confront.hpp"
#include "analysis/expectations/correct.hpp"
#include "analysis/factors.hpp"
#include "analysis/growth/sweep.hpp"
#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

using Rows = std::vector<Estimates>;
using Indices = std::vector<std::size_t>;

// --- what an expectation speaks of ----------------------------------------------------------------

bool is_named(std::string const& name, Estimates const& row) { return row.quantity == name || row.family == name; }

Indices selected(Expectation const& expectation, Rows const& rows) {
  Indices found;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (speaks_of(expectation, rows[i])) found.push_back(i);
  return found;
}

std::string in_words(Interval const& steps) { return fmt::format("{} … {}", steps.low, steps.high); }

std::string in_words(Selector const& where) {
  std::string words;
  auto const add = [&](char const* key, std::string const& level) {
    words += fmt::format("{}{} = {}", words.empty() ? " where " : ", ", key, level);
  };
  if (where.method) add("method", *where.method);
  if (where.arithmetic) add("arithmetic", *where.arithmetic);
  if (where.special_functions) add("special functions", *where.special_functions);
  if (where.coefficients) add("coefficients", *where.coefficients);
  if (where.compensation) add("compensation", *where.compensation ? "true" : "false");
  if (where.rounding) add("rounding", *where.rounding);
  if (where.constants) add("constants", *where.constants);
  if (where.contraction) add("contraction", *where.contraction ? "true" : "false");
  if (where.step) add("step", fmt::format("{}", *where.step));
  if (where.step_range) add("step", in_words(*where.step_range));
  return words;
}

std::string listed(std::set<std::string> const& words) { return fmt::format("{}", fmt::join(words, ", ")); }

/// Says what there is instead: other quantities, or the cells that have this one.
std::string what_there_is(Expectation const& expectation, Rows const& rows) {
  std::set<std::string> quantities, cells;
  for (auto const& row : rows) {
    quantities.insert(row.quantity);
    if (is_named(expectation.of, row)) cells.insert(brief(row.cell));
  }
  if (rows.empty()) return "there are no results";
  if (cells.empty()) return fmt::format("no result has '{}'; there are {}", expectation.of, listed(quantities));
  return fmt::format("no cell is like that; '{}' was observed in: {}", expectation.of, listed(cells));
}

// --- the exponent of the step, over rows that differ in the step alone ----------------------------

bool differ_in_step_alone(Estimates const& a, Estimates const& b) {
  auto cell = b.cell;
  cell.step = a.cell.step;
  cell.steps = a.cell.steps;  // with `until`, h decides how many
  return a.quantity == b.quantity && a.cell == cell;
}

std::vector<Indices> sweeps(Indices const& chosen, Rows const& rows) {
  std::vector<Indices> groups;
  for (auto const i : chosen) {
    auto const same = [&](Indices const& group) { return differ_in_step_alone(rows[group.front()], rows[i]); };
    auto const group = std::find_if(groups.begin(), groups.end(), same);
    if (group == groups.end())
      groups.push_back({i});
    else
      group->push_back(i);
  }
  return groups;
}

std::string sweep_found(SweepLaw const& law, std::set<double> const& steps) {
  return fmt::format("p = {}, q = {} over {} steps h = {} … {}", measured(law.step_exponent, law.step_interval),
                     measured(law.time_exponent, law.time_interval), steps.size(), *steps.begin(), *steps.rbegin());
}

std::set<double> steps_of(Indices const& group, Rows const& rows) {
  std::set<double> steps;
  for (auto const i : group) steps.insert(rows[i].cell.step);
  return steps;
}

std::string left_out_of(Indices const& group, Rows const& rows) {
  std::string text;
  for (auto const i : group)
    if (rows[i].failed > 0) text += but_for_failures(rows[i]) + fmt::format(" at h = {}", rows[i].cell.step);
  return text;
}

std::string sweep_claim(Expectation const& expectation, Estimates const& row) {
  auto const& [exponent, within] = *expectation.step_exponent;
  auto const& range = expectation.where.step_range;
  return fmt::format("{}{}: grows as h^p t^q with p = {:g} ± {:g}", claimed_of(row, false),
                     range ? ", h = " + in_words(*range) : "", exponent, within);
}

Outcome check_sweep(Expectation const& expectation, Indices const& group, Rows const& rows, FitSweep const& fit) {
  auto const& wanted = *expectation.step_exponent;
  auto const steps = steps_of(group, rows);
  Outcome outcome;
  outcome.claim = sweep_claim(expectation, rows[group.front()]);
  outcome.found = fmt::format("{} is a count: it has no law in h", rows[group.front()].quantity);
  if (rows[group.front()].count) return outcome;
  outcome.found = fmt::format("a law in h needs at least three steps; here is {}", steps.size());
  if (steps.size() < 3) return outcome;
  try {
    auto const law = fit(group);
    outcome.passed = std::abs(law.step_exponent - wanted.exponent) <= wanted.within;
    outcome.found = sweep_found(law, steps) + left_out_of(group, rows);
  } catch (InputError const& error) {  // no law can be fitted to these cells; the other expectations still count
    outcome.found = error.what();
  }
  return outcome;
}

// --- one expectation ------------------------------------------------------------------------------

void require_known_verdicts(Expectation const& expectation) {
  auto const words = verdict_words();
  for (auto const& word : expectation.verdict)
    if (std::find(words.begin(), words.end(), word) == words.end())
      throw InputError(fmt::format("{}there is no verdict '{}'{}",
                                   expectation.line > 0 ? fmt::format("line {}: ", expectation.line) : "",
                                   one_line(word), suggestion(word, words)));
}

void check_one(Expectation const& expectation, Rows const& rows, FitSweep const& fit, std::vector<Outcome>& outcomes) {
  auto const chosen = selected(expectation, rows);
  auto const before = outcomes.size();
  for (auto const i : chosen)
    for (auto& outcome : confront(expectation, rows[i])) outcomes.push_back(std::move(outcome));
  if (expectation.step_exponent)
    for (auto const& group : sweeps(chosen, rows)) outcomes.push_back(check_sweep(expectation, group, rows, fit));
  std::string const claim = expectation.of + in_words(expectation.where);
  if (chosen.empty())
    outcomes.push_back({false, claim, what_there_is(expectation, rows)});
  else if (outcomes.size() == before)
    outcomes.push_back({false, claim, "the expectation does not say what is expected"});
}

}  // namespace

bool speaks_of(Expectation const& expectation, Estimates const& row) {
  return is_named(expectation.of, row) && expectation.where.matches(row.cell);
}

bool Selector::matches(CellLabels const& cell) const {
  auto const is = [](auto const& wanted, auto const& level) { return !wanted || *wanted == level; };
  return is(method, cell.method) && is(arithmetic, cell.arithmetic) && is(special_functions, cell.special_functions) &&
         is(coefficients, cell.coefficients) && is(compensation, cell.compensation) && is(rounding, cell.rounding) &&
         is(constants, cell.constants) && is(contraction, cell.contraction) && is(step, cell.step) &&
         (!step_range || (step_range->low <= cell.step && cell.step <= step_range->high));
}

std::vector<std::string> verdict_words() {
  using enum Verdict;
  std::vector<std::string> words;
  for (auto const verdict :
       {random_walk, persistent_slopes, drift, bounded, faster_than_drift, exact, not_resolved, count})
    words.push_back(to_string(verdict));
  return words;
}

std::vector<Outcome> check(std::vector<Expectation> const& expectations, Rows const& estimates, FitSweep const& sweep,
                           Correction correction) {
  for (auto const& expectation : expectations) require_known_verdicts(expectation);
  std::vector<Outcome> outcomes;
  for (auto const& expectation : expectations) check_one(expectation, estimates, sweep, outcomes);
  correct(outcomes, correction);
  return outcomes;
}

}  // namespace brouwer
