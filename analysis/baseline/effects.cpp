// Two rows of a baseline against one another: what changed, and how sure that is.
#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/baseline/compare_baseline.hpp"
#include "analysis/distributions.hpp"

namespace brouwer {
namespace {

struct Pair {
  BaselineRow const& recorded;
  BaselineRow const& now;
  bool paired;
};

double degrees(BaselineRow const& row) { return static_cast<double>(row.members - 1); }

/// Of the difference of two means with these standard errors [B. L. Welch, Biometrika 34 (1947) 28].
Effect welch(Effect::Of of, double change, double a, double b, Pair const& pair) {
  double const total = a * a + b * b;
  double const inverse =
      a * a / total * (a * a / total) / degrees(pair.recorded) + b * b / total * (b * b / total) / degrees(pair.now);
  double const dof = total > 0 ? 1 / inverse : degrees(pair.recorded) + degrees(pair.now);
  return {of, change, std::sqrt(total), dof, change > 0, 1};
}

bool can_be_paired(Pair const& pair) {
  auto const& a = pair.recorded;
  auto const& b = pair.now;
  return pair.paired && a.failed == 0 && b.failed == 0 && a.slopes.size() > 1 && a.slopes.size() == b.slopes.size();
}

/// Standard error of the mean of the members' differences.
double paired_error(Pair const& pair) {
  double const mean = pair.now.slope_mean - pair.recorded.slope_mean,
               largest = std::max(std::abs(pair.now.slopes[0]), std::abs(mean));
  double const unit = largest > 0 ? largest : 1;  // no square of a slope of 1e-170 is to vanish
  double sum = 0;
  for (std::size_t i = 0; i < pair.now.slopes.size(); ++i) {
    double const off = (pair.now.slopes[i] - pair.recorded.slopes[i] - mean) / unit;
    sum += off * off;
  }
  auto const members = static_cast<double>(pair.now.slopes.size());
  return unit * std::sqrt(sum / (members * (members - 1)));
}

Effect drift(Pair const& pair) {
  double const change = pair.now.slope_mean - pair.recorded.slope_mean;
  auto effect = welch(Effect::Of::drift, change, pair.recorded.slope_error, pair.now.slope_error, pair);
  if (can_be_paired(pair)) effect = {Effect::Of::drift, change, paired_error(pair), degrees(pair.now), false, 1};
  effect.is_larger = std::abs(pair.now.slope_mean) > std::abs(pair.recorded.slope_mean);
  return effect;
}

Effect diffusion(Pair const& pair) {
  return welch(Effect::Of::diffusion, std::log(pair.now.increment_size / pair.recorded.increment_size),
               pair.recorded.increment_log_error, pair.now.increment_log_error, pair);
}

Effect slopes(Pair const& pair) {
  auto const& [a, b] = std::tie(pair.recorded, pair.now);
  return welch(Effect::Of::slopes, std::log(b.slope_spread / a.slope_spread), a.slope_spread_error / a.slope_spread,
               b.slope_spread_error / b.slope_spread, pair);
}

Effect exponent(Pair const& pair) {
  return welch(Effect::Of::exponent, pair.now.exponent - pair.recorded.exponent, pair.recorded.exponent_error,
               pair.now.exponent_error, pair);
}

constexpr Effect (*all[])(Pair const&) = {drift, diffusion, slopes, exponent};

double p_of(Effect const& effect) {
  if (effect.error == 0) return effect.change == 0 ? 1 : 0;  // all members changed by the same amount
  return student_two_sided(effect.change / effect.error, effect.dof);
}

}  // namespace

std::vector<Effect> effects(BaselineRow const& recorded, BaselineRow const& now, bool paired) {
  std::vector<Effect> asked;
  if (recorded.members < 2 || now.members < 2) return asked;
  for (auto* const of : all) {
    Effect effect = of({recorded, now, paired});
    effect.p = p_of(effect);
    if (std::isfinite(effect.p) && std::isfinite(effect.change)) asked.push_back(effect);
  }
  return asked;
}

}  // namespace brouwer
