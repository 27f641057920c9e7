// Simulated ensembles: every test of increments cries wolf as rarely as it says, under the model and for walks whose size
// changes, and sees what it is to see. Seeds are fixed; bounds are four standard errors of the binomial law.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

#include "analysis/increments/increments.hpp"
#include "tests/analysis/simulated.hpp"
#include "tests/analysis/simulated_increments.hpp"

namespace brouwer {
namespace {

constexpr double sigma = 2e-16;

void expect_binomial(int count, int trials, double probability, std::string const& of) {
  double const error = std::sqrt(trials * probability * (1 - probability));
  EXPECT_NEAR(count, trials * probability, 4 * error) << of << " of " << trials << " at " << probability;
}

/// No more often than said; a discrete test, or Holm's, may be less often.
void expect_at_most(int count, int trials, double probability, std::string const& of) {
  double const error = std::sqrt(trials * probability * (1 - probability));
  EXPECT_LE(count, trials * probability + 4 * error) << of << " of " << trials << " at " << probability;
}

std::map<std::string, double> p_values(IncrementTests const& tests) {
  std::map<std::string, double> p;
  for (auto const& lag : tests.autocorrelations) p["lag " + std::to_string(lag.lag)] = lag.p;
  for (std::size_t k = 0; k < tests.variance_ratios.size(); ++k)
    p["scale " + std::to_string(k)] = tests.variance_ratios[k].p;
  if (!tests.variance_ratios.empty()) p["all scales"] = tests.variance_ratio_p;
  p["normality"] = tests.normality.p;
  return p;
}

/// How often the p value of each test was below each level.
struct Alarms {
  std::map<std::string, std::map<double, int>> below;
  int trials = 0;

  void add(IncrementTests const& tests) {
    for (auto const& [name, p] : p_values(tests))
      for (double const level : {0.05, 0.001}) below[name][level] += p < level;
    ++trials;
  }
};

/// The number of members and of samples, and how these are spaced.
class Model : public testing::TestWithParam<std::tuple<int, int, bool>> {};

TEST_P(Model, EveryTestKeepsItsLevel) {
  auto const [members, samples, logarithmic] = GetParam();
  auto const times = logarithmic ? log_spaced(samples, 1e5) : linearly_spaced(samples, 6400);
  Law const law{.drift = 1e-18, .persistence = 1e-18, .diffusion = sigma};
  Normal normal(static_cast<unsigned long>(members * samples));
  Alarms alarms;
  for (int k = 0; k < 2500; ++k) alarms.add(*increment_tests(simulated(law, members, times, normal), {}));
  for (auto const& [name, counts] : alarms.below)
    for (auto const& [level, count] : counts)
      if (name == "all scales" || level < 0.01)
        expect_at_most(count, alarms.trials, level, name);
      else
        expect_binomial(count, alarms.trials, level, name);
}
INSTANTIATE_TEST_SUITE_P(Ensembles, Model,
                         testing::Combine(testing::Values(4, 8, 64), testing::Values(8, 64), testing::Bool()),
                         [](auto const& test) {
                           return std::to_string(std::get<0>(test.param)) + "_members_" +
                                  std::to_string(std::get<1>(test.param)) +
                                  (std::get<2>(test.param) ? "_log_samples" : "_samples");
                         });

/// Correlation is not seen where there is none, although no two increments are of one size.
TEST(IncrementsCalibration, SizesThatChangeDoNoHarm) {
  Increments next(5);
  Alarms alarms;
  for (int k = 0; k < 2500; ++k) {
    auto ensemble = ensemble_of([&](double) { return next.normal(); }, 8, linearly_spaced(32, 3200));
    for (Eigen::Index i = 0; i < 8; ++i) ensemble.errors.row(i) *= std::exp2(static_cast<double>(i));
    alarms.add(*increment_tests(ensemble, {}));
  }
  for (auto const* name : {"lag 1", "lag 2", "scale 0", "scale 2"})
    for (double const level : {0.05, 0.001}) expect_at_most(alarms.below[name][level], alarms.trials, level, name);
  EXPECT_GT(alarms.below["normality"][0.001], alarms.trials * 9 / 10);  // a mixture of sizes is not normal
}

/// Of increments with heavy tails the slopes so far share what one large increment has put into them: correlations do not
/// mind, and variance ratios are called false up to five times as often (0.36 % measured at 0.001, 6.5 % at 0.05).
TEST(IncrementsCalibration, HeavyTailsDoLittleHarmToTestsOfCorrelation) {
  Increments next(6);
  Alarms alarms;
  for (int k = 0; k < 2500; ++k)
    alarms.add(
        *increment_tests(ensemble_of([&](double) { return next.heavy_tailed(); }, 8, linearly_spaced(32, 3200)), {}));
  for (auto const* name : {"lag 1", "lag 2", "scale 0"})
    for (double const level : {0.05, 0.001}) expect_at_most(alarms.below[name][level], alarms.trials, level, name);
  expect_at_most(alarms.below["all scales"][0.05], alarms.trials, 0.08, "all scales");
  expect_at_most(alarms.below["all scales"][0.001], alarms.trials, 0.005, "all scales");
}

TEST(IncrementsCalibration, IntervalsOverMembersCover) {
  Increments next(7);
  int rho = 0, ratio = 0, sized = 0;
  constexpr int trials = 1500;
  auto const covers = [](Interval const& i, double truth) { return i.low <= truth && truth <= i.high; };
  for (int k = 0; k < trials; ++k) {
    auto const tests =
        *increment_tests(ensemble_of([&](double) { return next.normal(); }, 64, linearly_spaced(32, 3200), sigma), {});
    rho += covers(tests.autocorrelations[0].interval, 0);
    ratio += covers(tests.variance_ratios[1].interval, 1);
    sized += covers(tests.variance_ratios[1].sigma_interval, sigma);
  }
  expect_binomial(rho, trials, 0.95, "ρ₁");
  expect_binomial(ratio, trials, 0.95, "V");
  expect_binomial(sized, trials, 0.95, "σ");
}

/// Of 200 ensembles of 16 members and 64 samples, how many are told from a walk by this test at 0.001.
int seen(std::string const& name, std::function<double(double)> const& next, bool logarithmic = false) {
  auto const times = logarithmic ? log_spaced(64, 1e5) : linearly_spaced(64, 6400);
  Alarms alarms;
  for (int k = 0; k < 200; ++k) alarms.add(*increment_tests(ensemble_of(next, 16, times), {}));
  return alarms.below[name][0.001];
}

// 1008 increments know ρ₁ to 0.031: 0.2 is 6.3 of these, the critical value at 0.001 is 3.3.
TEST(IncrementsPower, AutoregressionIsSeenByItsCorrelation) {
  Increments next(8);
  EXPECT_GE(seen("lag 1", [&](double x) { return next.autoregressive(0.2, x); }), 190);
  EXPECT_GE(seen("lag 1", [&](double x) { return next.autoregressive(-0.2, x); }), 190);
  EXPECT_GE(seen(
                "lag 1", [&](double x) { return next.autoregressive(0.3, x); }, true),
            190);
}

TEST(IncrementsPower, AutoregressionIsSeenByItsVarianceRatios) {
  Increments next(9);
  EXPECT_GE(seen("all scales", [&](double x) { return next.autoregressive(0.25, x); }), 190);
  EXPECT_GE(seen("all scales", [&](double x) { return next.autoregressive(-0.25, x); }), 190);
}

/// A correlation too small for its neighbours alone adds up over scales.
TEST(IncrementsPower, SlowCorrelationIsSeenAtLongScales) {
  Increments next(10);
  double slow = 0;
  auto const weakly = [&](double) {
    slow = next.autoregressive(0.95, slow);
    return std::sqrt(0.9) * next.normal() + std::sqrt(0.1) * slow;
  };
  int const by_scale = seen("all scales", weakly), by_lag = seen("lag 1", weakly);
  EXPECT_GT(by_scale, by_lag + 20);
}

TEST(IncrementsPower, HeavyTailsAndSkewnessAreSeenByNormality) {
  Increments next(11);
  EXPECT_GE(seen("normality", [&](double) { return next.heavy_tailed(); }), 185);
  EXPECT_GE(seen("normality", [&](double) { return next.skewed(); }), 200);
  EXPECT_GE(seen(
                "normality", [&](double) { return next.skewed(); }, true),
            200);
}

}  // namespace
}  // namespace brouwer
