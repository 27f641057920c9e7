// Slopes beside walk and noise: in the law where nothing smaller reaches the spread at the end, and called seen no more
// often than the level says, whatever the tails are.
#include "analysis/growth/growth_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/distributions.hpp"
#include "analysis/growth/inference.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

constexpr int trials = 300;

/// In units of the run, as in the models `all`, `noise`, `t(3) + noise` and `unequal + noise` of tests/calibration.
constexpr double root_time = 100;  // √10⁴
Law const full = {.drift = 0.5e-4, .persistence = 1e-4, .diffusion = 1 / root_time, .noise = 0.1};

double student_3(gsl_rng* rng) { return gsl_ran_tdist(rng, 3) * std::sqrt(1.0 / 3); }

template <class Count>
int counted(Law const& law, Count const& count) {
  Normal normal(2024);
  int hits = 0;
  for (int k = 0; k < trials; ++k) hits += count(estimate(simulated(law, 64, log_spaced(64, 1e4), normal), {}));
  return hits;
}

double four_errors(double rate) { return 4 * std::sqrt(trials * rate * (1 - rate)); }

TEST(SlopesBesideNoise, AreInTheLawWhereTheyAreAsLargeAsTheWalk) {
  int const chosen = counted(full, [](Estimates const& e) {
    return e.model->law().terms == LawTerms{true, true, true};
  });
  EXPECT_GE(chosen, trials / 2) << "the signs of increments alone, which noise blurs, agree in 3 %";
}

TEST(SlopesBesideNoise, DoNotWidenNorShiftSigmaBeyondItsInterval) {
  auto const covers = [](Estimates const& e) {
    return e.diffusion.interval.low <= 1 / root_time && 1 / root_time <= e.diffusion.interval.high;
  };
  EXPECT_NEAR(counted(full, covers), 0.95 * trials, four_errors(0.95));
}

struct Without {
  char const* name;
  Law law;
};
void PrintTo(Without const& w, std::ostream* out) { *out << w.name; }

class NoSlopes : public testing::TestWithParam<Without> {};

TEST_P(NoSlopes, AreNotSeenMoreOftenThanTheLevelSays) {
  auto const seen = [](Estimates const& e) {
    return e.model->law().terms.noise && e.model->law().terms.slopes && e.model->p_slopes < e.levels.test;
  };
  EXPECT_LE(counted(GetParam().law, seen), trials * 0.001 + four_errors(0.001));
}

TEST_P(NoSlopes, MakeNoVerdictOfPersistentSlopes) {
  auto const called = [](Estimates const& e) { return e.verdict == Verdict::persistent_slopes; };
  EXPECT_LE(counted(GetParam().law, called), trials * 0.001 + four_errors(0.001));
}

INSTANTIATE_TEST_SUITE_P(
    Laws, NoSlopes,
    testing::Values(Without{"normal", {.diffusion = 1 / root_time, .noise = 0.1}},
                    Without{"heavy_tails", {.diffusion = 1 / root_time, .noise = 0.1, .shape = student_3}},
                    Without{"unequal", {.diffusion = 1 / root_time, .noise = 0.1, .inequality = 0.5}}),
    [](auto const& test) { return test.param.name; });

TEST(EndP, IsTwoSidedAndWiderWhereVariancesAreMoreUncertain) {
  auto const ensemble = simulated({.diffusion = 1}, 32, {1, 2, 4, 8}, 3ul);
  GrowthStatistics const statistics(ensemble, {});
  double const own = statistics.slope_spread() / 31;  // variance of the slopes
  GrowthFit fit;
  fit.scale = own * 8;  // σ²/T is what is seen
  EXPECT_NEAR(end_p(statistics, fit), 2 * std::min(chi_squared_upper(31, 31), chi_squared_lower(31, 31)), 1e-12);
  fit.scale /= 3;
  double const p = end_p(statistics, fit);
  EXPECT_NEAR(p, 2 * chi_squared_upper(93, 31), 1e-12 * p);
  EXPECT_NEAR(end_p(statistics, fit, 2), 2 * chi_squared_upper(46.5, 15.5), 1e-12);
  fit.scale *= 9;
  EXPECT_NEAR(end_p(statistics, fit), 2 * chi_squared_lower(31.0 / 3, 31), 1e-12);
}

}  // namespace
}  // namespace brouwer
