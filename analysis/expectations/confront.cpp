#include "analysis/expectations/confront.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/expectations/decision.hpp"
#include "analysis/factors.hpp"
#include "analysis/growth/inference.hpp"
#include "analysis/numbers.hpp"
#include "analysis/verdict/failures.hpp"

namespace brouwer {
namespace {

struct Test {
  Expectation const& expectation;
  Estimates const& row;

  double level() const { return expectation.level.value_or(row.levels.test); }
};

/// What rests on a test: it must be significant, or must not.
Outcome judged(ClaimTest const& test, std::string claim, std::string found) {
  return {test.holds(test.p), std::move(claim), std::move(found), test};
}

/// The estimates state it at Levels::test; at another level it goes with the noncentrality that is seen there.
double smallest_visible_drift(Test const& test) {
  auto const visible = [&](double level) {
    Levels levels = test.row.levels;
    levels.test = level;
    return visible_noncentrality(test.row.drift_degrees(), levels);
  };
  double const own = test.level(), stated = test.row.levels.test;
  return test.row.smallest_visible_drift * (own == stated ? 1 : visible(own) / visible(stated));
}

std::string drift_found(Test const& test) {
  auto const& drift = test.row.drift;
  return fmt::format("β = {} per step (t = {}, {}); the smallest drift visible at level {:g} with chance {:g} is {}",
                     measured(drift.per_step, drift.interval), number(drift.t, 3), probability(drift.own_p()),
                     test.level(), test.row.levels.power, number(smallest_visible_drift(test), 2));
}

Outcome no_drift(Test const& test) {
  return judged({test.row.drift.own_p(), test.level(), false}, fmt::format("no drift at level {:g}", test.level()),
                drift_found(test));
}

Outcome drift_in_band(Test const& test) {
  auto const [low, high] = test.expectation.drift_band;
  double const beta = test.row.drift.per_step;
  bool const inside = low <= beta && beta <= high, excludes_zero = low > 0 || high < 0;
  std::string const claim = fmt::format("drift between {} and {} per step", number(low, 3), number(high, 3));
  if (!excludes_zero) return {inside, claim, drift_found(test)};
  return judged({test.row.drift.own_p(), test.level(), true, inside},
                claim + fmt::format(", seen at level {:g}", test.level()), drift_found(test));
}

Outcome drift_smaller_than(Test const& test) {
  double const bound = test.expectation.drift_bound;
  auto const found = equivalence(test.row, bound, test.level());
  auto const& drift = test.row.drift;
  return judged(
      {found.p, test.level()},
      fmt::format("|drift| < {} per step, proven at level {:g}", number(bound, 3), test.level()),
      fmt::format(
          "β = {} per step (t = {} from −δ, {} from δ, {}; {:g} % interval {} … {}); the smallest δ proven is {}",
          measured(drift.per_step, drift.interval), number(found.t_above, 3), number(found.t_below, 3),
          probability(found.p), 100 * (1 - 2 * test.level()), number(found.interval.low, 2),
          number(found.interval.high, 2), number(found.provable, 2)));
}

/// What is expected of an error's law cannot be true of a count.
Outcome no_law(Test const& test, std::string const& of) {
  return {false, fmt::format("something is expected of its {}", of),
          fmt::format("{} is a count: it has no {}, only a mean and a spread", test.row.quantity, of)};
}

std::optional<Outcome> drift(Test const& test) {
  using Wanted = Expectation::DriftWanted;
  if (test.expectation.drift == Wanted::unsaid) return std::nullopt;
  if (test.row.count) return no_law(test, "drift");
  if (test.expectation.drift == Wanted::smaller_than) return drift_smaller_than(test);
  return test.expectation.drift == Wanted::none ? no_drift(test) : drift_in_band(test);
}

std::optional<Outcome> growth(Test const& test) {
  auto const& wanted = test.expectation.growth;
  if (!wanted) return std::nullopt;
  if (test.row.count) return no_law(test, "law of growth");
  auto const& [q, interval] = test.row.growth;
  return Outcome{std::abs(q - wanted->exponent) <= wanted->within,
                 fmt::format("grows as t^q with q = {:g} ± {:g}", wanted->exponent, wanted->within),
                 fmt::format("q = {} ({:g} % interval {} … {})", number(q, 3), 100 * test.row.levels.confidence,
                             number(interval.low, 3), number(interval.high, 3))};
}

std::optional<Outcome> persistence(Test const& test) {
  auto const& wanted = test.expectation.persistence;
  if (!wanted) return std::nullopt;
  if (test.row.count) return no_law(test, "persistent slope");
  auto const& found = test.row.persistence;
  return judged(
      {found.p, test.level(), *wanted},
      fmt::format("{} at level {:g}", *wanted ? "persistent slopes" : "no persistent slopes", test.level()),
      fmt::format("F = {} ({}), τ = {} per step", number(found.F, 3), probability(found.p), number(found.per_step, 2)));
}

Outcome in_band(char const* what, Interval const& band, double value, std::string const& found) {
  return {band.low <= value && value <= band.high,
          fmt::format("{} at the end between {} and {}", what, number(band.low, 3), number(band.high, 3)),
          fmt::format("{} = {}", what, found)};
}

std::optional<Outcome> mean(Test const& test) {
  auto const& wanted = test.expectation.mean;
  if (!wanted) return std::nullopt;
  double const value = test.row.mean.back(), error = test.row.mean_error.back();
  return in_band(
      "mean", *wanted, value,
      fmt::format("{} (standard error {}) over {} members", number(value, 3), number(error, 2), test.row.members));
}

std::optional<Outcome> rms(Test const& test) {
  auto const& wanted = test.expectation.rms_final;
  if (!wanted) return std::nullopt;
  double const value = test.row.rms_final;
  return in_band("RMS", *wanted, value, fmt::format("{} over {} members", number(value, 3), test.row.members));
}

std::optional<Outcome> verdict(Test const& test) {
  auto const& wanted = test.expectation.verdict;
  if (wanted.empty()) return std::nullopt;
  std::string const found = to_string(test.row.verdict);
  return Outcome{std::find(wanted.begin(), wanted.end(), found) != wanted.end(),
                 fmt::format("verdict {}", fmt::join(wanted, " or ")),
                 test.row.sentence.empty() ? found : found + ": " + test.row.sentence};
}

std::optional<Outcome> failed(Test const& test) {
  auto const& most = test.expectation.failed;
  if (!most) return std::nullopt;
  return Outcome{test.row.failed <= *most,
                 *most == 0 ? "no member failed" : fmt::format("at most {} members failed", *most),
                 fmt::format("{} of {}", test.row.failed, test.row.members + test.row.failed)};
}

constexpr std::optional<Outcome> (*parts[])(Test const&) = {drift, growth, persistence, mean, rms, failed, verdict};

}  // namespace

std::string claimed_of(Estimates const& row, bool with_step) {
  auto const cell = brief(row.cell, with_step);
  return row.quantity + (cell.empty() ? "" : ", " + cell);
}

std::string but_for_failures(Estimates const& row) {
  return row.failed > 0 ? "; " + left_out(row, " failed and were left out") : "";
}

std::vector<Outcome> confront(Expectation const& expectation, Estimates const& row) {
  std::vector<Outcome> outcomes;
  for (auto* const part : parts)
    if (auto outcome = part({expectation, row})) {
      outcome->claim = claimed_of(row) + ": " + outcome->claim;
      outcome->found += but_for_failures(row);
      outcomes.push_back(std::move(*outcome));
    }
  return outcomes;
}

}  // namespace brouwer
