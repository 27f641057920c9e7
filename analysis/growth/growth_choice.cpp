#include "analysis/growth/growth_choice.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/distributions.hpp"
#include "analysis/growth/tails.hpp"

namespace brouwer {
namespace {

constexpr LawTerms walk_and_noise = {true, false, true}, all_three = {true, true, true};
constexpr LawTerms only_noise = {false, false, true}, noise_and_slopes = {false, true, true};

/// The p of the smaller one of two laws.
double p_between(GrowthFits const& fits, LawTerms const& smaller, LawTerms const& larger, Yardstick const& yardstick) {
  return yardstick.p(fits[place_of(smaller)].deviance - fits[place_of(larger)].deviance);
}

/// Var(s²) of the errors at the end over that of normal ones, 1 + κ/2 with κ their own excess kurtosis, at least 1.
double end_inflation(Ensemble const& ensemble, Units const& units) {
  Eigen::ArrayXd const ends = units.error * ensemble.errors.rightCols<1>().array();
  Eigen::ArrayXd const squares = (ends - ends.mean()).square();
  auto const M = static_cast<double>(ends.size());
  double const excess = squares.square().mean() / std::pow(squares.mean(), 2) - 3 * (M - 1) / (M + 1);
  return 1 + std::max(0.0, excess) / 2;
}

/// Beside noise a few late samples of a walk look like slopes, and either may do without the other: slopes are called
/// so where they are needed beside a walk; what grows otherwise is a walk. Needed they are where the signs agree, or,
/// as noise blurs these, where walk and noise do not reach the spread at the end. Where that is so for normal errors
/// alone, they are in the law, which nothing smaller is, and not called seen: model.p_slopes is not below the level.
LawChoice choose_beside_noise(GrowthFits const& fits, GrowthStatistics const& statistics, ChoiceGrounds const& grounds,
                              FullModel& model) {
  double const level = grounds.levels.test;
  auto const& smaller = fits[place_of(walk_and_noise)];
  double const p_slopes = p_between(fits, walk_and_noise, all_three, grounds.yardstick);
  LawTerms terms = all_three;
  model.p_slopes = p_slopes;
  model.p_walk = p_between(fits, noise_and_slopes, all_three, grounds.yardstick);
  bool const both = model.p_walk < level;
  if (both && end_p(statistics, smaller, grounds.end_inflation) >= level)
    model.p_slopes = std::max(model.p_slopes, grounds.p_signs);
  terms.slopes = model.p_slopes < level || (both && end_p(statistics, smaller) < level);
  if (!terms.slopes) model.p_walk = p_between(fits, only_noise, walk_and_noise, grounds.yardstick);
  terms.walk = model.p_walk < level;
  return {terms, terms.walk && !terms.slopes && p_slopes < 1 - grounds.levels.confidence};
}

}  // namespace

std::size_t place_of(LawTerms const& terms) {
  return static_cast<std::size_t>(std::find(growth_laws.begin(), growth_laws.end(), terms) - growth_laws.begin());
}

double Yardstick::p(double twice_ratio) const {
  double const x = twice_ratio / inflation;
  if (dof == 0 || !(x > 0)) return boundary_p(x);
  return student_two_sided(std::sqrt(x), dof) / 2;
}

Yardstick yardstick(Tails const& tails, double members) {
  if (tails.normal) return {};
  return {std::max({1.0, tails.dispersion, 1 + tails.kurtosis / 2}), members - 1};
}

ChoiceGrounds grounds_of(Ensemble const& ensemble, Units const& units, Levels const& levels, Tails const& tails) {
  auto const measure = yardstick(tails, static_cast<double>(ensemble.errors.rows()));
  return {levels, measure, doubling_signs_p(ensemble, units),
          std::max(measure.inflation, end_inflation(ensemble, units))};
}

LawChoice choose_law(GrowthFits const& fits, GrowthStatistics const& statistics, ChoiceGrounds const& grounds,
                     FullModel& model) {
  model.p_noise = p_between(fits, {true, true, false}, all_three, grounds.yardstick);
  if (model.p_noise < grounds.levels.test) return choose_beside_noise(fits, statistics, grounds, model);
  model.p_walk = 0;
  return {{true, model.p_slopes < grounds.levels.test, false}};
}

double end_p(GrowthStatistics const& statistics, GrowthFit const& fit, double inflation) {
  double const time = statistics.duration(), dof = (statistics.members() - 1) / inflation;
  double const expected = fit.tau2 + fit.sigma2() / time + fit.nu2() / (time * time);
  double const chi2 = statistics.slope_spread() / expected / inflation;
  return std::min(1.0, 2 * std::min(chi_squared_upper(chi2, dof), chi_squared_lower(chi2, dof)));
}

double boundary_p(double twice_ratio) {
  if (!(twice_ratio > 0)) return 1;
  return std::erfc(std::sqrt(twice_ratio / 2)) / 2;  // half of P(χ²(1) ≥ x)
}

}  // namespace brouwer
