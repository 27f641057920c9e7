// Error rates of the decision between walk and drift, and the proof that a drift is small: simulated, and at the edges.
#include "analysis/expectations/decision.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/distributions.hpp"
#include "analysis/growth/inference.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

constexpr double sigma = 2e-16, duration = 1e4;

/// Standard error of β̂ as the law has it.
double true_error(int members) { return sigma / std::sqrt(duration * members); }

/// Estimates of an ensemble whose standard error is just what the law has.
Estimates typical(int members, Levels const& levels = {}) {
  auto e = estimate(simulated({.diffusion = sigma}, members, log_spaced(8, duration), 1ul), levels);
  e.smallest_visible_drift *= true_error(members) / standard_error(e);
  return e;
}

void expect_binomial(int count, int trials, double probability) {
  EXPECT_NEAR(count, trials * probability, 4 * std::sqrt(trials * probability * (1 - probability))) << "of " << trials;
}

TEST(StandardError, IsThatOfTheMeanSlope) {
  auto const ensemble = simulated({.persistence = 1e-17, .diffusion = sigma}, 12, log_spaced(8, duration), 3ul);
  auto const e = estimate(ensemble, {});
  EXPECT_NEAR(standard_error(e) * e.drift.t / e.drift.per_step, 1, 1e-12);
}

class Power : public testing::TestWithParam<int> {};

/// |t| of M slopes that are N(drift, σ²/T).
double t_of_slopes(int members, double drift, Normal& normal) {
  double mean = 0, squares = 0;
  for (int i = 0; i < members; ++i) {
    double const slope = drift + sigma / std::sqrt(duration) * normal();
    mean += slope / members;
    squares += slope * slope;
  }
  return std::abs(mean) / std::sqrt((squares - members * mean * mean) / (members - 1) / members);
}

TEST_P(Power, IsHowOftenADriftIsSeen) {
  int const members = GetParam(), trials = 10000;
  auto const e = typical(members, {.confidence = 0.95, .test = 0.01, .power = 0.9});
  double const critical = student_upper_quantile(0.005, members - 1);
  Normal normal(static_cast<unsigned long>(members));
  for (double const multiple : {0.25, 0.5, 1.0, 1.25}) {
    double const drift = multiple * e.smallest_visible_drift;
    int seen = 0;
    for (int k = 0; k < trials; ++k) seen += t_of_slopes(members, drift, normal) > critical;
    expect_binomial(seen, trials, chance_to_see(drift, e));
  }
}
INSTANTIATE_TEST_SUITE_P(Members, Power, testing::Values(4, 8, 64));

TEST(PowerCurve, GoesFromTheLevelToCertainty) {
  auto const curve = power_curve(typical(16));
  EXPECT_EQ(curve.drifts.front(), 0);
  EXPECT_EQ(curve.chances.front(), 0.001);
  for (std::size_t k = 1; k < curve.chances.size(); ++k) EXPECT_GT(curve.chances[k], curve.chances[k - 1]);
  EXPECT_NEAR(curve.chances[4], 0.9, 0.002);  // the smallest visible drift
  EXPECT_GT(curve.chances.back(), 0.999);
}

TEST(PowerCurve, IsTheInverseOfTheDriftSeenWithAChance) {
  for (int const members : {4, 16, 256}) {
    auto const e = typical(members);
    EXPECT_NEAR(drift_seen_with(0.9, e) / e.smallest_visible_drift, 1, 1e-12);
    for (double const chance : {0.5, 0.9, 0.99})
      EXPECT_NEAR(chance_to_see(drift_seen_with(chance, e), e), chance, members < 16 ? 0.03 : 0.006);
  }
}

TEST(PowerCurve, OfLargeAndOfHugeDriftsEnds) {
  auto const e = typical(100'000);
  EXPECT_NEAR(chance_to_see(0.5 * e.smallest_visible_drift, e), 0.158, 0.01);  // Φ(2.286 − 3.291)
  for (double const multiple : {3.0, 10.0, 100.0, 1e10}) {
    EXPECT_NEAR(chance_to_see(multiple * e.smallest_visible_drift, e), 1, 1e-9) << multiple;
    EXPECT_NEAR(chance_to_see(multiple * typical(3).smallest_visible_drift, typical(3)), 1, 1e-2) << multiple;
  }
}

TEST(PowerCurve, OfOneMemberIsNone) {
  auto const e = estimate(simulated({.diffusion = sigma}, 1, log_spaced(8, duration), 1ul), {});
  EXPECT_TRUE(power_curve(e).drifts.empty());
  EXPECT_TRUE(std::isnan(chance_to_see(1e-18, e)));
  EXPECT_TRUE(std::isnan(smallest_provable_drift(e)));
}

// --- equivalence ----------------------------------------------------------------------------------

/// How many of `trials` ensembles of this drift are proven to have |β| < bound.
int proven(int members, double drift, double bound, double level, int trials) {
  Normal normal(static_cast<unsigned long>(1000 * level) + static_cast<unsigned long>(members));
  int count = 0;
  for (int k = 0; k < trials; ++k) {
    auto const ensemble = simulated({.drift = drift, .diffusion = sigma}, members, {duration / 2, duration}, normal);
    count += equivalence(estimate(ensemble, {}), bound, level).p < level;
  }
  return count;
}

class Equivalent : public testing::TestWithParam<int> {};

/// At the bound itself, where it does not hold any more, smallness is "proven" with the chance of the level. The other
/// bound is 12 standard errors away.
TEST_P(Equivalent, IsFalselyProvenAtTheBoundAsOftenAsTheLevelSays) {
  int const members = GetParam();
  double const bound = 6 * true_error(members);
  expect_binomial(proven(members, bound, bound, 0.05, 3000), 3000, 0.05);
  expect_binomial(proven(members, -bound, bound, 0.05, 3000), 3000, 0.05);
  expect_binomial(proven(members, bound, bound, 0.01, 3000), 3000, 0.01);
}
INSTANTIATE_TEST_SUITE_P(Members, Equivalent, testing::Values(8, 64));

TEST(Equivalent, IsProvenOfAWalkWhereTheEnsembleIsLargeEnough) {
  // |β̂| + 1.67 s < δ for δ = 4 s: P(|t| < 2.33) = 0.977 of 64 members
  expect_binomial(proven(64, 0, 4 * true_error(64), 0.05, 1000), 1000, 0.976);
  EXPECT_EQ(proven(64, 0, true_error(64), 0.05, 300), 0);  // nobody can prove less than 1.67 s
}

TEST(Equivalent, IsProvenWhereTheIntervalLiesInside) {
  Normal normal(4);
  for (int k = 0; k < 200; ++k) {
    auto const e = estimate(simulated({.drift = 1e-18, .diffusion = sigma}, 16, log_spaced(8, duration), normal), {});
    for (double const bound : {1e-18, 2e-18, 4e-18}) {
      auto const found = equivalence(e, bound, 0.05);
      bool const inside = -bound < found.interval.low && found.interval.high < bound;
      EXPECT_EQ(found.p < 0.05, inside);
      EXPECT_EQ(found.provable < bound, inside);
      EXPECT_DOUBLE_EQ(found.provable, std::max(-found.interval.low, found.interval.high));
    }
  }
}

TEST(Equivalent, OfMembersThatDoNotDifferIsCertain) {
  Ensemble ensemble;
  ensemble.times = {50, 100};
  ensemble.errors = ErrorMatrix::Constant(8, 2, 1e-16);
  auto const e = estimate(ensemble, {});  // β̂ = 1e-18, and no spread
  EXPECT_EQ(equivalence(e, 2e-18, 0.001).p, 0);
  EXPECT_EQ(equivalence(e, 0.5e-18, 0.001).p, 1);
  EXPECT_TRUE(std::isnan(equivalence(e, e.drift.per_step, 0.001).p));
  EXPECT_EQ(smallest_provable_drift(e), e.drift.per_step);
}

}  // namespace
}  // namespace brouwer
