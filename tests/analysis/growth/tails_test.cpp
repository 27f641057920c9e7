// What holds of sigma and F whatever the law of the increments is: coverage, false alarms, and where it is not needed.
#include "analysis/growth/tails.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/growth/inference.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

constexpr Levels five_percent{.confidence = 0.95, .test = 0.05, .power = 0.9};

struct Count {
  int sigma = 0, slopes = 0, normal = 0;
};

Count count(Law const& law, int members, int trials) {
  Normal normal(static_cast<unsigned long>(members));
  Count c;
  for (int k = 0; k < trials; ++k) {
    auto const e = estimate(simulated(law, members, log_spaced(16, 1e5), normal), five_percent);
    c.sigma += e.diffusion.interval.low <= law.diffusion && law.diffusion <= e.diffusion.interval.high;
    c.slopes += e.persistence.p < five_percent.test;
    c.normal += e.tails.normal;
  }
  return c;
}

class HeavyTails : public testing::TestWithParam<int> {};

TEST_P(HeavyTails, LeaveSigmaNearItsLevelAndRaiseNoFalseAlarmOfSlopes) {
  constexpr int trials = 400;
  auto const c = count({.diffusion = 1, .shape = student_5}, GetParam(), trials);
  EXPECT_GT(c.sigma, 0.86 * trials) << "the χ² interval covers 72 to 80 %";
  EXPECT_LE(c.slopes, 0.05 * trials + 4 * std::sqrt(trials * 0.05 * 0.95));
}
INSTANTIATE_TEST_SUITE_P(Members, HeavyTails, testing::Values(8, 16, 64, 256));

TEST(NormalIncrements, AreMostlyTakenForNormalAndCoverAsBefore) {
  constexpr int trials = 400;
  auto const c = count({.diffusion = 1}, 32, trials);
  EXPECT_GT(c.normal, 0.85 * trials);
  EXPECT_NEAR(c.sigma, 0.95 * trials, 4 * std::sqrt(trials * 0.95 * 0.05));
}

TEST(Tails, SlopesAreStillSeenThroughHeavyTails) {
  auto const e = estimate(
      simulated({.persistence = 2e-18, .diffusion = 2e-16, .shape = student_5}, 64, log_spaced(32, 1e5), 3ul), {});
  EXPECT_FALSE(e.tails.normal);
  EXPECT_EQ(e.verdict, Verdict::persistent_slopes);
}

TEST(Tails, MembersWithASigmaOfTheirOwnShowAsDispersion) {
  auto ensemble = simulated({.diffusion = 1}, 64, log_spaced(16, 1e4), 5ul);
  EXPECT_NEAR(estimate(ensemble, {}).tails.dispersion, 1, 4 * std::sqrt(2.0 / 63));
  Normal normal(6);
  for (auto row : ensemble.errors.rowwise()) row *= std::exp(0.5 * normal());
  auto const e = estimate(ensemble, {});
  EXPECT_GT(e.tails.dispersion, 5);
  EXPECT_FALSE(e.tails.normal);
}

TEST(Tails, OfAFewMembersSayNothing) {
  EXPECT_TRUE(estimate(simulated({.diffusion = 1}, 3, {1, 2, 3}, 1ul), {}).tails.normal);
}

TEST(Tails, SignsAtDoublingTimesSeeSlopesBehindNoise) {
  Law law{.persistence = 1, .noise = 10};
  std::vector<double> times;
  for (int j = 1; j <= 200; ++j) times.push_back(j);
  auto const with = simulated(law, 64, times, 4ul);
  EXPECT_LT(doubling_signs_p(with, units_of(with)), 1e-6);
  law.persistence = 0;
  auto const without = simulated(law, 64, times, 4ul);
  EXPECT_GT(doubling_signs_p(without, units_of(without)), 0.05);
}

}  // namespace
}  // namespace brouwer
