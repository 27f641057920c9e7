// What all members share beside a drift: β allows for it, σ, τ and ν do not see it, and it is called neither drift nor
// walk.
#include "analysis/growth/shared_course.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/distributions.hpp"
#include "analysis/expectations/decision.hpp"
#include "analysis/growth/inference.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;

constexpr double duration = 1e4;

std::vector<double> even(int count) {
  std::vector<double> times;
  for (int j = 1; j <= count; ++j) times.push_back(duration * j / count);
  return times;
}

/// Adds x(t) − x(0) of a wave of so many periods in the run.
Ensemble with_wave(Ensemble ensemble, double size, double periods, double phase = 1) {
  for (std::size_t j = 0; j < ensemble.times.size(); ++j) {
    double const angle = 2 * std::numbers::pi * periods * ensemble.times[j] / duration;
    ensemble.errors.col(static_cast<Eigen::Index>(j)).array() += size * (std::sin(angle + phase) - std::sin(phase));
  }
  return ensemble;
}

Ensemble walks(std::vector<double> const& times, double drift = 0, unsigned long seed = 11) {
  return simulated({.drift = drift, .diffusion = 2e-16}, 64, times, seed);
}

bool holds(Interval i, double truth) { return i.low <= truth && truth <= i.high; }

TEST(CourseOfMean, IsTheFormulaWrittenDownByHand) {
  Ensemble ensemble;
  ensemble.times = {1, 2, 4};
  ensemble.errors.resize(2, 3);
  ensemble.errors << 3, -1, 2, 5, -3, 6;  // mean 4, −2, 4: 3 above and 4 below its line t
  auto const found = course_of_mean(ensemble, {}, -1);
  // d of the members: 2.5, 3.5 and −2, −6; variance of their mean 0.25 and 4
  double const squares = 0.25 * (9 - 0.25) + 0.5 * (16 - 4), expected = 0.25 * (1 + 1.0 / 16 + 9.0 / 16) + 0.5 * 1.5;
  double const shared = 2 * squares / expected / 16, own = 0.25;  // slopes ½ and 3/2: variance of their mean ¼
  double const degrees = 2 * 0.75 * 0.75 / (0.25 * 0.25 + 0.5 * 0.5);
  EXPECT_DOUBLE_EQ(found.size, std::sqrt(squares / expected));
  EXPECT_DOUBLE_EQ(found.reach, 4);
  EXPECT_DOUBLE_EQ(found.slope, 1);
  EXPECT_DOUBLE_EQ(found.error, std::sqrt(own + shared));
  EXPECT_DOUBLE_EQ(found.degrees, (own + shared) * (own + shared) / (own * own + shared * shared / degrees));
}

TEST(CourseOfMean, OfASampleThatAllIsCountedFromIsThatOfWhatFollows) {
  auto const ensemble = with_wave(walks(even(16), 1e-17), 1e-14, 3.3);
  Ensemble later = ensemble;
  later.times.erase(later.times.begin(), later.times.begin() + 3);
  for (double& time : later.times) time -= ensemble.times[2];
  later.errors = ensemble.errors.rightCols(13).colwise() - ensemble.errors.col(2);
  auto const units = units_of(ensemble);
  auto const a = course_of_mean(ensemble, units, 2), b = course_of_mean(later, units, -1);
  EXPECT_NEAR(a.size / b.size, 1, 1e-12);
  EXPECT_NEAR(a.error / b.error, 1, 1e-12);
  EXPECT_NEAR(a.degrees / b.degrees, 1, 1e-12);
}

TEST(CourseOfMean, HasNoDeviationWithoutASampleBetween) {
  auto const found = course_of_mean(walks(even(4)), {}, 2);
  EXPECT_EQ(found.size, 0);
  EXPECT_EQ(found.degrees, 63);
}

struct Planted {
  char const* name;
  std::vector<double> times;
  double periods;
};
void PrintTo(Planted const& p, std::ostream* out) { *out << p.name; }

class SharedWave : public testing::TestWithParam<Planted> {};

/// Half of what the walks spread to.
constexpr double wave = 1e-14;

TEST_P(SharedWave, IsNoDriftAndNoSuccess) {
  auto const e = estimate(with_wave(walks(GetParam().times), wave, GetParam().periods), {});
  EXPECT_EQ(e.verdict, Verdict::not_resolved) << e.sentence;
  EXPECT_GT(e.drift.p, e.levels.test);
  EXPECT_TRUE(holds(e.drift.interval, 0));
  EXPECT_THAT(e.sentence, HasSubstr("the mean of all members is no straight line"));
  EXPECT_THAT(e.sentence, HasSubstr("compare with the same method in higher precision"));
}

TEST_P(SharedWave, LeavesADriftThatIsMuchLargerADrift) {
  double const beta = 30 * wave / duration;
  auto const e = estimate(with_wave(walks(GetParam().times, beta), wave, GetParam().periods), {});
  EXPECT_EQ(e.verdict, Verdict::drift) << e.sentence;
  EXPECT_TRUE(holds(e.drift.interval, beta));
  EXPECT_THAT(e.sentence, HasSubstr("the mean of all members is no straight line"));
}

TEST_P(SharedWave, IsNotSeenByWhatMembersDoNotShare) {
  auto const one = estimate(with_wave(walks(GetParam().times), wave, GetParam().periods), {});
  auto const ten = estimate(with_wave(walks(GetParam().times), 10 * wave, GetParam().periods), {});
  ASSERT_TRUE(one.course && ten.course);
  EXPECT_TRUE(holds(one.diffusion.interval, 2e-16));
  EXPECT_NEAR(ten.diffusion.per_sqrt_step / one.diffusion.per_sqrt_step, 1, 1e-9);
  EXPECT_NEAR(ten.persistence.interval.high / one.persistence.interval.high, 1, 1e-6);
  EXPECT_NEAR(ten.model->p_noise / one.model->p_noise, 1, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Waves, SharedWave,
                         testing::Values(Planted{"two_periods_at_even_times", even(64), 2.3},
                                         Planted{"many_periods_at_even_times", even(64), 397.4},
                                         Planted{"two_periods_at_log_times", log_spaced(64, duration), 2.3},
                                         Planted{"many_periods_at_log_times", log_spaced(64, duration), 397.4},
                                         Planted{"many_periods_at_few_times", log_spaced(16, duration), 37.3}),
                         [](auto const& test) { return test.param.name; });

TEST(SharedCourse, IsNoneWhereTheMeanIsALine) {
  for (double const drift : {0.0, 1e-17}) EXPECT_FALSE(estimate(walks(even(32), drift), {}).course.has_value());
}

TEST(SharedCourse, MakesTheSmallestVisibleAndProvableDriftAsLargeAsItHides) {
  auto const plain = estimate(walks(even(64)), {}), e = estimate(with_wave(walks(even(64)), 10 * wave, 37.3), {});
  EXPECT_GT(e.smallest_visible_drift, 10 * wave / duration);
  EXPECT_GT(e.smallest_visible_drift, 5 * plain.smallest_visible_drift);
  EXPECT_GT(smallest_provable_drift(e), 10 * wave / duration);
  double const t = student_upper_quantile(0.025, e.course->degrees);
  EXPECT_NEAR((e.drift.interval.high - e.drift.per_step) / (t * standard_error(e)), 1, 1e-12);
}

TEST(SharedCourse, LeavesNoiseOfTheMembersToBeTold) {
  auto const ensemble = simulated({.diffusion = 2e-16, .noise = 3e-15}, 64, log_spaced(48, duration), 5ul);
  auto const e = estimate(with_wave(ensemble, 1e-13, 37.3), {});
  EXPECT_EQ(e.model->law().terms, (LawTerms{true, false, true}));
  EXPECT_TRUE(holds(e.noise.interval, 3e-15));
  EXPECT_TRUE(holds(e.diffusion.interval, 2e-16));
}

/// F and the exponent are of errors with the wave; the members' own differences walk.
TEST(SharedCourse, DoesNotMakeAWalkBounded) {
  Normal normal(41);
  int bounded = 0;
  for (int trial = 0; trial < 200; ++trial) {
    auto const walk = simulated({.diffusion = 1e-16}, 8, log_spaced(16, 1e4), normal);
    double const size = 1e-16 * std::sqrt(walk.times.back());
    bounded += estimate(with_wave(walk, size, 10 + 900.0 * trial / 200), {}).verdict == Verdict::bounded;
  }
  EXPECT_EQ(bounded, 0);
}

TEST(SharedCourse, OfABoundedErrorIsSaid) {
  auto const e = estimate(with_wave(simulated({.noise = 1e-16}, 64, even(64), 5ul), 1e-14, 37.3), {});
  EXPECT_LT(e.persistence.F, 0.01);
  EXPECT_TRUE(e.verdict == Verdict::bounded || e.verdict == Verdict::not_resolved);
  EXPECT_THAT(e.sentence, HasSubstr("a truncation error"));
}

/// A mean that leaves its line by little beside the spread is told, and leaves a walk a walk.
TEST(SharedCourse, HidesTheLawOnlyWhereItPrevails) {
  for (double const size : {0.1, 1.0}) {
    auto walk = simulated({.diffusion = 1e-16}, 256, even(64), 12ul);
    auto const e = estimate(with_wave(walk, size * 1e-16 * std::sqrt(walk.times.back()), 37.3), {});
    ASSERT_TRUE(e.course) << size;
    EXPECT_EQ(e.verdict, size < 0.25 ? Verdict::random_walk : Verdict::not_resolved) << e.sentence;
    EXPECT_NE(e.sentence.find("the mean of all members is no straight line"), std::string::npos);
  }
}

}  // namespace
}  // namespace brouwer
