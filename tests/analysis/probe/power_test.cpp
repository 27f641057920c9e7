// What an ensemble sees and excludes: against simulated ensembles, and the answers against one another.
#include "analysis/probe/power.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/growth/inference.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

constexpr double sigma = 2e-16;
constexpr std::int64_t steps = 10'000;

/// How often of 1000 ensembles the interval of β lies inside ±x.
int excluded(double x, double drift, double tau, int members, Levels const& levels) {
  Normal normal(static_cast<unsigned long>(members));
  int count = 0;
  for (int k = 0; k < 1000; ++k) {
    Law const law{.drift = drift, .persistence = tau, .diffusion = sigma};
    auto const e =
        estimate(simulated(law, members, {static_cast<double>(steps) / 2, static_cast<double>(steps)}, normal), levels);
    count += -x < e.drift.interval.low && e.drift.interval.high < x;
  }
  return count;
}

class Exclusion : public testing::TestWithParam<int> {};

TEST_P(Exclusion, SucceedsWithTheStatedChanceAndIsWrongAsRarelyAsItSays) {
  Levels const levels{.confidence = 0.9, .test = 0.001, .power = 0.8};
  int const members = GetParam();
  for (double const tau : {0., 2e-18}) {
    double const x = answerable_drift(Question::exclude, {sigma, tau}, members, steps, levels);
    EXPECT_NEAR(excluded(x, 0, tau, members, levels), 800, 4 * std::sqrt(1000 * 0.8 * 0.2));
    // a drift of exactly x is excluded with a chance of at most (1 − confidence)/2
    EXPECT_LE(excluded(x, x, tau, members, levels), 50 + 4 * std::sqrt(1000 * 0.05 * 0.95));
  }
}
INSTANTIATE_TEST_SUITE_P(Members, Exclusion, testing::Values(2, 4, 16, 64));

TEST(Power, OfManyMembersIsThatOfTheNormalLaw) {
  // z₀.₉₇₅ + z₀.₉₅ where the interval of 95 % is to lie inside with chance 0.9; Student's law is off by z³/(4 M)
  double const see = 3.290527 + 1.281552, exclude = 1.959964 + 1.644854;
  EXPECT_NEAR(needed_noncentrality(Question::see, 1'000'000, {}), see, 2e-5);
  EXPECT_NEAR(needed_noncentrality(Question::exclude, 1'000'000, {}), exclude, 1e-5);
  EXPECT_NEAR(needed_noncentrality(Question::exclude, 1'000'000'000'000, {}), exclude, 2e-6);
}

TEST(Power, AnswersAgreeWithOneAnother) {
  for (auto const question : {Question::see, Question::exclude})
    for (double const tau : {0., 1e-19}) {
      Spread const spread{sigma, tau};
      double const x = answerable_drift(question, spread, 100, steps, {});
      EXPECT_NEAR(*steps_needed(question, x, spread, 100, {}), steps, 1);
      EXPECT_NEAR(static_cast<double>(*members_needed(question, x * (1 + 1e-12), spread, steps, {})), 100, 0);
      EXPECT_EQ(*members_needed(question, -x * (1 - 1e-6), spread, steps, {}), 101) << "one fewer would not do";
    }
}

TEST(Power, OfMoreStepsEndsWherePersistentSlopesBegin) {
  Spread const spread{sigma, 1e-18};
  double const floor = needed_noncentrality(Question::see, 64, {}) * 1e-18 / 8;
  EXPECT_FALSE(steps_needed(Question::see, 0.99 * floor, spread, 64, {}));
  EXPECT_TRUE(steps_needed(Question::see, 1.01 * floor, spread, 64, {}));
  EXPECT_TRUE(members_needed(Question::see, 0.99 * floor, spread, steps, {})) << "more members do";
  EXPECT_NEAR(answerable_drift(Question::see, spread, 64, 1'000'000'000'000, {}) / floor, 1, 1e-4);
}

TEST(Power, OfOneMemberIsNone) { EXPECT_TRUE(std::isnan(answerable_drift(Question::see, {sigma, 0}, 1, steps, {}))); }

TEST(Power, OfNoDriftAtAllNeedsMoreThanCanBeCounted) {
  for (auto const question : {Question::see, Question::exclude})
    EXPECT_FALSE(members_needed(question, 1e-40, {sigma, 0}, steps, {}));
}

}  // namespace
}  // namespace brouwer
