#include "analysis/increments_objection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

bool rests_on_independence(Verdict verdict) {
  using enum Verdict;
  return verdict == random_walk || verdict == drift || verdict == persistent_slopes || verdict == not_resolved;
}

bool ratio_tells(VarianceRatio const& v) { return std::abs(v.ratio - 1) >= telling_ratio; }

bool correlated(IncrementTests const& tests, double level) {
  auto const& lags = tests.autocorrelations;
  auto const& ratios = tests.variance_ratios;
  bool const neighbours = !lags.empty() && lags.front().p < level && std::abs(lags.front().rho) >= telling_correlation;
  return neighbours || (tests.variance_ratio_p < level && std::any_of(ratios.begin(), ratios.end(), ratio_tells));
}

bool overlap(Interval const& a, Interval const& b) { return a.low <= b.high && b.low <= a.high; }

/// The shortest scale from which on no ratio is told from that of the longest.
VarianceRatio const& settled(std::vector<VarianceRatio> const& ratios) {
  auto const told = std::find_if(ratios.rbegin(), ratios.rend(),
                                 [&](VarianceRatio const& v) { return !overlap(v.interval, ratios.back().interval); });
  return told == ratios.rbegin() ? ratios.back() : *(told.base());
}

/// What σ is at longer scales; σ̂ is made of single increments.
std::string where_sigma_holds(IncrementTests const& tests, std::string const& unit) {
  auto const& ratios = tests.variance_ratios;
  if (ratios.empty()) return "σ and F are made for increments that are not";
  std::string const factor = fmt::format("is {} times as large as said", number(std::sqrt(ratios.back().ratio), 3));
  std::string const scale = number(ratios.back().scale, 2);
  if (&settled(ratios) == &ratios.back() && ratios.size() > 1)
    return fmt::format("σ per √{} depends on the scale, and at {} {}s, the longest seen, {}", unit, scale, unit,
                       factor);
  return fmt::format("at scales of {} {}s and more σ {}", number(settled(ratios).scale, 2), unit, factor);
}

std::string of_correlation(Estimates const& e) {
  auto const& tests = *e.increments;
  if (!correlated(tests, e.levels.test)) return "";
  auto const& lag = tests.autocorrelations.front();
  return fmt::format("Its increments are correlated (ρ₁ = {}, {}; variance ratio {}): {}.",
                     measured(lag.rho, lag.interval), probability(lag.p),
                     tests.variance_ratios.empty() ? "–" : number(tests.variance_ratios.back().ratio, 2),
                     where_sigma_holds(tests, e.time_unit));
}

/// Of a law with excess kurtosis κ the variance of σ̂² is 1 + κ/2 times that of a normal one.
std::string of_shape(Estimates const& e) {
  auto const& shape = e.increments->normality;
  bool const large =
      std::abs(shape.excess_kurtosis) >= telling_kurtosis || std::abs(shape.skewness) >= telling_skewness;
  if (!(shape.p < e.levels.test) || !large) return "";
  return fmt::format(
      "Its increments are not normal (skewness {}, excess kurtosis {}, {}): the interval of σ is to be {} times as "
      "wide.",
      number(shape.skewness, 2), number(shape.excess_kurtosis, 2), probability(shape.p),
      number(std::sqrt(std::max(0.0, 1 + shape.excess_kurtosis / 2)), 2));
}

}  // namespace

std::string increments_objection(Estimates const& e) {
  if (!e.increments || !rests_on_independence(e.verdict)) return "";
  auto const correlation = of_correlation(e), shape = of_shape(e);
  return correlation + (correlation.empty() || shape.empty() ? "" : " ") + shape;
}

}  // namespace brouwer
