// Main effects and interactions of a factorial: planted ones are found, absent ones as seldom as they should be.
#include "analysis/causes/factorial.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/causes/cell_shares.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;

/// A cell whose members have this drift beside a walk that all cells share, and one of their own.
MemberStatistics cell(double drift, double walk, Eigen::ArrayXd const& shared, Normal& normal) {
  MemberStatistics s{shared, shared, shared, shared};
  for (Eigen::Index i = 0; i < shared.size(); ++i) {
    s.slope[i] = drift + shared[i] + normal();
    s.disturbance[i] = 0;
    s.walk[i] = walk * walk * (1 + 0.3 * normal());
    s.square[i] = 1;
  }
  return s;
}

Eigen::ArrayXd shared_part(int members, Normal& normal) {
  Eigen::ArrayXd shared(members);
  for (auto& x : shared) x = 2 * normal();
  return shared;
}

/// Of a 2³ factorial with main effects a, b, of the first two factors and their interaction c on the drift; the third
/// multiplies the walk by `walk`.
std::vector<MemberStatistics> planted(double a, double b, double c, double walk, int members, Normal& normal) {
  auto const shared = shared_part(members, normal);
  std::vector<MemberStatistics> cells;
  for (int bits = 0; bits < 8; ++bits) {
    double const x = bits & 1 ? 0.5 : -0.5, y = bits & 2 ? 0.5 : -0.5;
    cells.push_back(cell(10 + a * x + b * y + 2 * c * x * y, bits & 4 ? walk : 1, shared, normal));
  }
  return cells;
}

bool holds(Interval const& i, double x) { return i.low <= x && x <= i.high; }

TEST(Factorial, ListsMainEffectsFirst) {
  Normal normal(1);
  auto const effects = factorial_effects(planted(1, 2, 3, 1, 8, normal), {"a", "b", "c"}, 0.95);
  ASSERT_EQ(effects.size(), 7U);
  EXPECT_THAT(effects[0].factors, ElementsAre("a"));
  EXPECT_THAT(effects[2].factors, ElementsAre("c"));
  EXPECT_THAT(effects[3].factors, ElementsAre("a", "b"));
  EXPECT_THAT(effects[6].factors, ElementsAre("a", "b", "c"));
}

TEST(Factorial, CoversPlantedEffects) {
  Normal normal(2);
  int a = 0, b = 0, c = 0, none = 0, walk = 0;
  int const trials = 2000;
  for (int trial = 0; trial < trials; ++trial) {
    auto const effects = factorial_effects(planted(1, -2, 0.5, 1.5, 16, normal), {"a", "b", "c"}, 0.95);
    a += holds(effects[0].drift.interval, 1);
    b += holds(effects[1].drift.interval, -2);
    c += holds(effects[3].drift.interval, 0.5);
    none += holds(effects[6].drift.interval, 0);
    walk += holds(effects[2].diffusion.interval, 1.5);
  }
  double const sd = std::sqrt(trials * 0.95 * 0.05);
  for (int const covered : {a, b, c, none}) EXPECT_NEAR(covered, 0.95 * trials, 3.9 * sd);  // exact
  EXPECT_NEAR(walk, 0.95 * trials, 0.015 * trials);                                         // of a logarithm: nearly
}

/// None of seven effects on β is there: Holm keeps the chance of any alarm.
TEST(Factorial, RaisesFewFalseAlarms) {
  Normal normal(3);
  int alarms = 0;
  int const trials = 2000;
  for (int trial = 0; trial < trials; ++trial) {
    auto const effects = factorial_effects(planted(0, 0, 0, 1, 8, normal), {"a", "b", "c"}, 0.95);
    alarms += std::any_of(effects.begin(), effects.end(), [](auto const& e) { return e.drift.p < 0.05; });
  }
  EXPECT_LE(alarms, 0.05 * trials + 3.9 * std::sqrt(trials * 0.05 * 0.95));
  EXPECT_GE(alarms, 0.02 * trials);  // and is not deaf
}

/// In whole numbers and without noise every effect is exact.
TEST(Factorial, IsTheContrastOfTheTextbook) {
  auto const constant = [](double drift, double tau2) {
    Eigen::ArrayXd const one = Eigen::ArrayXd::Ones(2);
    MemberStatistics s{drift * one, 0 * one, one, one};
    s.slope[0] += std::sqrt(tau2 / 2);
    s.slope[1] -= std::sqrt(tau2 / 2);
    return s;
  };
  auto const effects =
      factorial_effects({constant(8, 2), constant(4, 2), constant(6, 8), constant(4, 8)}, {"a", "b"}, 0.95);
  EXPECT_DOUBLE_EQ(effects[0].drift.per_step, -3);  // ((4 − 8) + (4 − 6))/2
  EXPECT_DOUBLE_EQ(effects[1].drift.per_step, -1);
  EXPECT_DOUBLE_EQ(effects[2].drift.per_step, 1);  // ((4 − 6) − (4 − 8))/2
  EXPECT_DOUBLE_EQ(effects[0].drift.share, 3.0 / 8);
  EXPECT_DOUBLE_EQ(effects[1].slopes.value, 3);  // (8 − 2)/2 of 2
  EXPECT_DOUBLE_EQ(effects[0].diffusion.value, 1);
}

}  // namespace
}  // namespace brouwer
