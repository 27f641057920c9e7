#include "analysis/increments/increments_objection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers.hpp"
#include "analysis/verdict/phrases.hpp"

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
  return neighbours || (tests.variance_ratio_p < level && ratio_tells(clearest_ratio(ratios)));
}

/// σ from a scale on, as one number.
struct Settled {
  std::vector<VarianceRatio>::const_iterator from;
  double log_sigma, half;  ///< of its interval, in the logarithm
};

Settled settled_at(std::vector<VarianceRatio>::const_iterator scale) {
  return {scale, std::log(scale->sigma), std::log(scale->sigma_interval.high / scale->sigma_interval.low) / 2};
}

/// The mean of both, each by how well it is known.
Settled mean(Settled const& shorter, Settled const& longer) {
  double const a = 1 / (shorter.half * shorter.half), b = 1 / (longer.half * longer.half);
  return {shorter.from, (a * shorter.log_sigma + b * longer.log_sigma) / (a + b), 1 / std::sqrt(a + b)};
}

/// From the longest scale down to the shortest that is not told from those above it: off by no more than 1.5 times the
/// half of the interval of the difference, because one of many scales is easily off by a half.
Settled settled(std::vector<VarianceRatio> const& scales) {
  Settled above = settled_at(scales.end() - 1);
  while (above.from != scales.begin()) {
    auto const next = settled_at(above.from - 1);
    if (std::abs(next.log_sigma - above.log_sigma) > 1.5 * std::hypot(next.half, above.half)) break;
    above = mean(next, above);
  }
  return above;
}

/// σ̂ is made of single increments; what it is at longer scales.
std::string where_sigma_holds(Estimates const& e) {
  auto const& scales = e.increments->variance_ratios;
  if (scales.empty() || e.members < 2) return "σ, F and their tests are made for increments that are not";
  auto const [from, log_sigma, half] = settled(scales);
  double const sigma = std::exp(log_sigma);
  std::string const above = fmt::format("{}{}, {} times what is said", number(sigma, 2), per_root(e),
                                        number(sigma / e.diffusion.per_sqrt_step, 2));
  if (from + 1 == scales.end())
    return fmt::format("σ depends on the scale, also at the longest seen, {} {}s, where it is {}",
                       number(from->scale, 2), e.time_unit, above);
  return fmt::format("from scales of {} {}s on σ is {}", number(from->scale, 2), e.time_unit, above);
}

std::string clearest(std::vector<VarianceRatio> const& scales, std::string const& unit) {
  if (scales.empty()) return "";
  auto const& clear = clearest_ratio(scales);
  return fmt::format("; variance ratio {} at {} {}s", measured(clear.ratio, clear.interval), number(clear.scale, 2),
                     unit);
}

std::string of_correlation(Estimates const& e) {
  auto const& tests = *e.increments;
  if (!correlated(tests, e.levels.test)) return "";
  auto const& lag = tests.autocorrelations.front();
  return fmt::format("Its increments are correlated (ρ₁ = {}, {}{}): {}.", measured(lag.rho, lag.interval),
                     probability(lag.p), clearest(tests.variance_ratios, e.time_unit), where_sigma_holds(e));
}

/// Of a law with excess kurtosis κ the variance of σ̂² is 1 + κ/2 times that of a normal one.
std::string of_shape(Estimates const& e) {
  auto const& shape = e.increments->normality;
  bool const large =
      std::abs(shape.excess_kurtosis) >= telling_kurtosis || std::abs(shape.skewness) >= telling_skewness;
  if (!(shape.p < e.levels.test) || !large) return "";
  std::string const worth = shape.excess_kurtosis < telling_kurtosis
                                ? ""
                                : fmt::format(": σ is known from them as from {} times fewer normal ones",
                                              number(1 + shape.excess_kurtosis / 2, 2));
  return fmt::format("Its increments are not normal (skewness {}, excess kurtosis {}, {}){}.",
                     number(shape.skewness, 2), number(shape.excess_kurtosis, 2), probability(shape.p), worth);
}

}  // namespace

VarianceRatio const& clearest_ratio(std::vector<VarianceRatio> const& scales) {
  return *std::min_element(scales.begin(), scales.end(),
                           [](VarianceRatio const& a, VarianceRatio const& b) { return a.p < b.p; });
}

std::string increments_objection(Estimates const& e) {
  if (!e.increments || !rests_on_independence(e.verdict)) return "";
  auto const correlation = of_correlation(e), shape = of_shape(e);
  return correlation + (correlation.empty() || shape.empty() ? "" : " ") + shape;
}

}  // namespace brouwer
