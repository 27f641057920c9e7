// A beginning that is unlike the rest is found, dated, and no drift.
#include "analysis/growth/transient.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/growth/inference.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;

/// Every member jumps by about the same in the first step.
Ensemble jumping(double jump) {
  auto ensemble = simulated({.diffusion = 2e-16}, 64, log_spaced(24, 1e4), 7ul);
  ensemble.errors.array() += jump;
  return ensemble;
}

TEST(Transient, OfAJumpInTheFirstStepEndsThere) {
  auto const e = estimate(jumping(1e-14), {});  // half of what the walk spreads to
  ASSERT_TRUE(e.transient.has_value());
  EXPECT_EQ(e.transient->until, 1);
  EXPECT_LT(e.transient->p, 1e-20);
}

TEST(Transient, DoesNotFakeADrift) {
  auto const e = estimate(jumping(1e-13), {});
  ASSERT_TRUE(e.transient.has_value() && e.course.has_value());
  EXPECT_LT(e.course->whole.p, e.levels.test) << "the slope to the end is significant";
  EXPECT_GT(e.drift.p, e.levels.test);
  EXPECT_LT(e.drift.interval.low, 0);
  EXPECT_GT(e.drift.interval.high, 0);
  EXPECT_NE(e.verdict, Verdict::drift) << e.sentence;
  EXPECT_THAT(e.sentence, HasSubstr("is no drift: it comes from the beginning"));
  EXPECT_THAT(e.sentence, HasSubstr("until 1.00 steps the mean moves otherwise than later"));
}

TEST(Transient, LeavesADriftAfterItWhatItIs) {
  auto ensemble = jumping(1e-14);
  for (std::size_t j = 0; j < ensemble.times.size(); ++j)
    ensemble.errors.col(static_cast<Eigen::Index>(j)).array() += 2e-17 * ensemble.times[j];
  auto const e = estimate(ensemble, {});
  EXPECT_EQ(e.verdict, Verdict::drift);
  ASSERT_TRUE(e.transient.has_value());
  EXPECT_LE(e.drift.interval.low, 2e-17);
  EXPECT_GE(e.drift.interval.high, 2e-17);
  EXPECT_EQ(e.transient->after.interval.low, e.drift.interval.low);
}

TEST(Transient, LeavesSigmaWhatItIs) {
  auto const plain = estimate(jumping(0), {}), e = estimate(jumping(1e-13), {});
  EXPECT_NEAR(e.diffusion.per_sqrt_step / plain.diffusion.per_sqrt_step, 1, 0.01);
  EXPECT_LE(e.diffusion.interval.low, 2e-16);
  EXPECT_GE(e.diffusion.interval.high, 2e-16);
}

TEST(Transient, NeedsThreeSamplesAfterIt) {
  auto const found = [](std::vector<double> const& times) {
    auto ensemble = simulated({.diffusion = 2e-16}, 64, times, 7ul);
    ensemble.errors.array() += 1e-13;
    return estimate(ensemble, {}).transient.has_value();
  };
  EXPECT_TRUE(found({1, 2000, 4000, 7000, 10'000}));
  EXPECT_FALSE(found({1, 2000, 6000, 10'000})) << "of two and the last a wave cannot be told from a line";
}

TEST(Transient, OfANonLinearBeginningEndsWhereItEnds) {
  auto ensemble = simulated({.diffusion = 1}, 64, log_spaced(32, 1e4), 9ul);
  for (std::size_t j = 0; j < ensemble.times.size(); ++j)  // grows like t² up to t = 100, then stays
    ensemble.errors.col(static_cast<Eigen::Index>(j)).array() +=
        100 * std::min(1.0, std::pow(ensemble.times[j] / 100, 2));
  auto const e = estimate(ensemble, {});
  ASSERT_TRUE(e.transient.has_value());
  EXPECT_GE(e.transient->until, 50);
  EXPECT_LE(e.transient->until, 200);
}

/// At 16 log-spaced times the last ones of this wave look like a line to 16 members, every other time.
TEST(Transient, IsNoneWhereTheMeanSwings) {
  Normal normal(12);
  for (int k = 0; k < 40; ++k) {
    auto ensemble = simulated({.diffusion = 1}, 16, log_spaced(16, 1e4), normal);
    for (std::size_t j = 0; j < ensemble.times.size(); ++j)
      ensemble.errors.col(static_cast<Eigen::Index>(j)).array() +=
          100 * std::sin(2 * std::numbers::pi * 37.3 * ensemble.times[j] / 1e4);
    EXPECT_FALSE(estimate(ensemble, {}).transient.has_value()) << k;
  }
}

TEST(Transient, IsNoneWhereTheMeanNeverBecomesStraight) {
  auto const e =
      estimate(simulated({.drift = 2e-17, .diffusion = 2e-16, .phase = true}, 64, log_spaced(32, 1e5), 5ul), {});
  EXPECT_FALSE(e.transient.has_value()) << "t² is a law, and no beginning";
}

class StraightMeans : public testing::TestWithParam<int> {};

TEST_P(StraightMeans, RaiseNoMoreFalseAlarmsThanTheLevelSays) {
  Levels const levels{.confidence = 0.95, .test = 0.05, .power = 0.9};
  Normal normal(13);
  int alarms = 0;
  constexpr int trials = 400;
  for (int k = 0; k < trials; ++k) {
    Law const law{.drift = 0.3, .persistence = 0.01, .diffusion = 1, .noise = 2, .shape = student_5};
    auto const ensemble = simulated(law, GetParam(), log_spaced(16, 1e4), normal);
    alarms += transient_of(ensemble, units_of(ensemble), levels).has_value();
  }
  EXPECT_LE(alarms, trials * 0.05 + 4 * std::sqrt(trials * 0.05 * 0.95));
}
INSTANTIATE_TEST_SUITE_P(Members, StraightMeans, testing::Values(8, 64));

}  // namespace
}  // namespace brouwer
