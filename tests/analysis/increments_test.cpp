// What increments say: each statistic against its definition written down once more, p values against all choices of
// signs, and the edges.
#include "analysis/increments.hpp"

#include <gmock/gmock.h>
#include <omp.h>

#include <boost/math/distributions/normal.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "analysis/free_increments.hpp"
#include "analysis/histogram.hpp"
#include "analysis/increments_objection.hpp"
#include "analysis/inference.hpp"
#include "analysis/normality.hpp"
#include "analysis/pearson.hpp"
#include "analysis/random_signs.hpp"
#include "analysis/variance_ratio.hpp"
#include "tests/analysis/simulated.hpp"
#include "tests/analysis/simulated_increments.hpp"

namespace brouwer {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

Eigen::ArrayXd as_array(std::vector<double> const& x) {
  return Eigen::Map<Eigen::ArrayXd const>(x.data(), std::ssize(x));
}

Ensemble walks(int members = 16, int samples = 24) {
  return simulated({.drift = 1e-17, .persistence = 1e-17, .diffusion = 2e-16}, members, log_spaced(samples, 1e5), 7ul);
}

// --- increments without slopes --------------------------------------------------------------------

/// wⱼ as the textbook has recursive residuals: xⱼ = Δⱼ/√δⱼ on uⱼ = √δⱼ by least squares on all before.
Eigen::ArrayXd recursive_residuals(Eigen::RowVectorXd const& errors, Eigen::ArrayXd const& times) {
  Eigen::ArrayXd w(times.size() - 1);
  double before_e = 0, before_t = 0, xu = 0, uu = 0;
  for (Eigen::Index j = 0; j < times.size(); ++j) {
    double const u = std::sqrt(times[j] - before_t), x = (errors[j] - before_e) / u;
    if (j > 0) w[j - 1] = (x - u * xu / uu) / std::sqrt(1 + u * u / uu);
    xu += x * u;
    uu += u * u;
    before_e = errors[j];
    before_t = times[j];
  }
  return w;
}

TEST(FreeIncrements, AreTheRecursiveResidualsOfARegressionOnASlope) {
  auto const ensemble = walks();
  auto const times = as_array(ensemble.times);
  FreeIncrements const free(times);
  for (Eigen::Index i = 0; i < ensemble.errors.rows(); ++i) {
    auto const w = free(ensemble.errors.row(i), 1);
    auto const expected = recursive_residuals(ensemble.errors.row(i), times);
    EXPECT_LT((w - expected).abs().maxCoeff(), 1e-11 * expected.abs().maxCoeff());
  }
}

TEST(FreeIncrements, HaveTheSquaresThatSigmaIsMadeOf) {
  auto const ensemble = walks();
  FreeIncrements const free(as_array(ensemble.times));
  double squares = 0;
  for (Eigen::Index i = 0; i < ensemble.errors.rows(); ++i) squares += free(ensemble.errors.row(i), 1).square().sum();
  double const sigma = estimate(ensemble, {}).diffusion.per_sqrt_step;
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(16 * 23)) / sigma, 1, 1e-12);
}

TEST(FreeIncrements, DoNotSeeASlope) {
  auto const times = as_array(log_spaced(24, 1e5));
  Eigen::RowVectorXd const ramp = 3 * times.matrix().transpose();
  EXPECT_LT(FreeIncrements(times)(ramp, 1).abs().maxCoeff(), 1e-11);
}

// --- random signs ---------------------------------------------------------------------------------

/// The share of all choices of signs of `a` for which the statistic is at least x, and at most x.
template <class Statistic>
Tails over_all_signs(Eigen::ArrayXd const& a, double x, Statistic statistic) {
  auto const choices = 1u << static_cast<unsigned>(a.size());
  Tails count{0, 0};
  for (unsigned choice = 0; choice < choices; ++choice) {
    Eigen::ArrayXd signed_a = a;
    for (Eigen::Index k = 0; k < a.size(); ++k)
      if ((choice >> static_cast<unsigned>(k)) & 1u) signed_a[k] = -a[k];
    double const value = statistic(signed_a);
    count.lower += value <= x + 1e-9 ? 1. / choices : 0;
    count.upper += value >= x - 1e-9 ? 1. / choices : 0;
  }
  return count;
}

double p_of(Tails const& tails) { return std::min(1.0, 2 * std::min(tails.lower, tails.upper)); }

Eigen::ArrayXd sizes(int count, unsigned seed) {
  std::mt19937 generator(seed);
  Eigen::ArrayXd a(count);
  for (auto& x : a) x = static_cast<double>(generator() % 2000 + 1) / 1000;
  return a;
}

TEST(RandomSigns, AreCountedWhereTheyAreFew) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    auto const a = sizes(7, seed);
    for (double const x : {0.0, 1.3, -2.2, a.sum()}) {
      RandomSigns sum(7);
      sum.add_sum(a);
      auto const expected = p_of(over_all_signs(a, x, [](auto const& s) { return s.sum(); }));
      EXPECT_NEAR(sum.two_sided(x), std::max(expected, std::exp2(-6)), 1e-12) << seed << " " << x;
    }
  }
}

TEST(RandomSigns, OfASquareAreCountedToo) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    auto const a = sizes(6, seed);
    auto const square = [](auto const& s) { return s.sum() * s.sum() - s.square().sum(); };
    RandomSigns signs(5);
    signs.add_square(a);
    EXPECT_NEAR(signs.two_sided(square(a)), p_of(over_all_signs(a, square(a), square)), 1e-12);
  }
}

/// Where a part of 20 signs is fitted, the tail is that of all million choices to 4 % of itself, from 0.3 to 0.001.
TEST(RandomSigns, AreFittedWhereTheyAreMany) {
  auto const a = sizes(20, 3);
  RandomSigns sum(20);
  sum.add_sum(a);
  double const deviation = std::sqrt(a.square().sum());
  for (double const z : {1.0, 1.5, 2.0, 2.5, 3.0, 3.3}) {
    auto const expected = p_of(over_all_signs(a, z * deviation, [](auto const& s) { return s.sum(); }));
    EXPECT_NEAR(sum.two_sided(z * deviation) / expected, 1, 0.04) << z;
  }
}

TEST(RandomSigns, OfSquaresAreFittedWhereTheyAreMany) {
  auto const a = sizes(20, 4);
  auto const statistic = [](auto const& s) {
    double sum = 0;
    for (int block = 0; block < 5; ++block) {
      double const total = s.segment(4 * block, 4).sum();
      sum += total * total - s.segment(4 * block, 4).square().sum();
    }
    return sum;
  };
  RandomSigns signs(15);
  for (int block = 0; block < 5; ++block) signs.add_square(a.segment(4 * block, 4));
  for (double const x : {8.0, 15.0, 25.0, -12.0, 35.0}) {
    double const expected = p_of(over_all_signs(a, x, statistic));
    ASSERT_GT(expected, 1e-3) << x;
    EXPECT_NEAR(signs.two_sided(x) / expected, 1, 0.1) << x;
  }
}

TEST(RandomSigns, OfNothingGiveNoTest) {
  RandomSigns sum(2);
  sum.add_sum(Eigen::ArrayXd::Zero(2));
  EXPECT_TRUE(std::isnan(sum.two_sided(0)));
}

TEST(Pearson, HoldsTheLawsThatItIsMadeOf) {
  EXPECT_NEAR(pearson_tails(1.959963984540054, 0, 0).upper, 0.025, 1e-12);
  // χ²(4): skewness √2, excess 3; 9.487729 is exceeded with 0.05
  EXPECT_NEAR(pearson_tails((9.487729036781154 - 4) / std::sqrt(8.), std::sqrt(2.), 3).upper, 0.05, 1e-12);
  EXPECT_NEAR(pearson_tails(-(9.487729036781154 - 4) / std::sqrt(8.), -std::sqrt(2.), 3).lower, 0.05, 1e-12);
  // uniform on ±√3: excess −6/5
  EXPECT_NEAR(pearson_tails(0.9 * std::sqrt(3.), 0, -1.2).upper, 0.05, 1e-12);
  EXPECT_EQ(pearson_tails(1.01 * std::sqrt(3.), 0, -1.2).upper, 0);
}

// --- statistics -----------------------------------------------------------------------------------

TEST(Autocorrelation, IsItsDefinition) {
  auto const ensemble = walks();
  auto const tests = increment_tests(ensemble, {});
  FreeIncrements const free(as_array(ensemble.times));
  ASSERT_EQ(tests->autocorrelations.size(), 5u);
  for (auto const& found : tests->autocorrelations) {
    double products = 0, squares = 0;
    for (Eigen::Index i = 0; i < 16; ++i) {
      auto const w = free(ensemble.errors.row(i), 1e16);
      for (Eigen::Index j = 0; j + found.lag < w.size(); ++j) products += w[j] * w[j + found.lag];
      squares += w.square().sum();
    }
    EXPECT_NEAR(found.rho, 23. / static_cast<double>(23 - found.lag) * products / squares, 1e-10);
  }
}

/// The variance of increments over blocks, each less the slope so far, over that of the single ones by weight.
TEST(VarianceRatio, IsItsDefinition) {
  auto const ensemble = simulated({.diffusion = 2e-16}, 8, linearly_spaced(33, 3300), 5ul);
  auto const times = as_array(ensemble.times);
  auto const tests = increment_tests(ensemble, {});
  FreeIncrements const free(times);
  auto const& found = tests->variance_ratios[1];  // blocks of four
  EXPECT_NEAR(found.scale, 400, 1e-9);
  double blocks = 0, singles = 0, count = 0;
  for (Eigen::Index i = 0; i < 8; ++i) {
    auto const e = ensemble.errors.row(i);
    auto const w = free(e, 1);
    // a block from the second sample on ends within 4 times its beginning; they follow one another
    for (Eigen::Index a = 1; a + 4 < times.size(); a += 4) {
      double const d = times[a + 4] - times[a];
      double const W = (e[a + 4] - e[a] - d * e[a] / times[a]) * std::sqrt(times[a] / (d * times[a + 4]));
      blocks += W * W;
      count += 1;
      for (Eigen::Index k = a; k < a + 4; ++k)
        singles += w[k] * w[k] * (1 / times[k] - 1 / times[k + 1]) / (1 / times[a] - 1 / times[a + 4]);
    }
  }
  EXPECT_NEAR(found.ratio, blocks / singles, 1e-9);
  EXPECT_NEAR(found.sigma / std::sqrt(blocks / count), 1, 1e-9);
}

TEST(VarianceRatio, BlocksAreDisjointAndOfTheirScale) {
  auto const times = as_array(log_spaced(64, 1e5));
  auto const scales = aggregations(times, 16);
  ASSERT_GT(scales.size(), 8u);
  double d = 2;  // the shortest interval is 1
  for (auto const& scale : scales) {
    while (scale.scale >= 2 * d) d *= 2;
    Eigen::Index end = 0;
    for (auto const& [first, length] : scale.blocks) {
      double const duration = times[first + length] - times[first];
      EXPECT_GE(first, end);
      EXPECT_GE(length, 2);
      EXPECT_TRUE(duration >= d && duration < 2 * d) << duration << " at " << d;
      EXPECT_LE(times[first + length], longest_reach * times[first]);
      EXPECT_NEAR(scale.coefficients.segment(first, length).square().sum(), 1, 1e-12);
      end = first + length;
    }
    EXPECT_GE(16 * std::ssize(scale.blocks), fewest_blocks);
  }
}

/// A walk seen through noise has the variance σ² + 2ν²/d per unit of time at the scale d.
TEST(VarianceRatio, ToldFromAWalkGivesSigmaWhereItHolds) {
  double const sigma = 2e-16, noise = 1e-15;
  auto const e = simulated({.diffusion = sigma, .noise = noise}, 256, linearly_spaced(64, 6400), 11ul);
  auto const tests = increment_tests(e, {});
  for (auto const& scale : tests->variance_ratios) {
    double const expected = std::sqrt(sigma * sigma + 2 * noise * noise / scale.scale);
    EXPECT_NEAR(scale.sigma / expected, 1, 0.06) << scale.scale;
  }
}

// --- normality ------------------------------------------------------------------------------------

/// The definition in 50 digits with another library's normal law.
double anderson_darling_in_50_digits(std::vector<double> x) {
  using Real = boost::multiprecision::cpp_bin_float_50;
  std::sort(x.begin(), x.end());
  Real const n = x.size();
  Real mean = 0, squares = 0, sum = 0;
  for (double const value : x) mean += value / n;
  for (double const value : x) squares += (value - mean) * (value - mean);
  boost::math::normal_distribution<Real> const law(mean, sqrt(squares / (n - 1)));
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += (2 * Real(i) + 1) * (log(cdf(law, Real(x[i]))) + log(cdf(complement(law, Real(x[x.size() - 1 - i])))));
  return static_cast<double>((-n - sum / n) * (1 + 0.75 / n + 2.25 / (n * n)));
}

TEST(Normality, IsAndersonAndDarlings) {
  Increments next(3);
  std::vector<double> x;
  for (int k = 0; k < 40; ++k) x.push_back(next.skewed());
  EXPECT_NEAR(normality(x, {}).anderson_darling, anderson_darling_in_50_digits(x), 1e-11);
}

/// Critical values of A*² as they are tabulated for both parameters estimated [D'Agostino & Stephens 1986, table 4.7].
TEST(Normality, HasTheTabulatedCriticalValues) {
  struct Row {
    double level, critical;
  };
  Normal normal(5);
  std::vector<double> found;
  for (int k = 0; k < 20000; ++k) {
    std::vector<double> x(50);
    for (auto& value : x) value = normal();
    found.push_back(normality(x, {}).p);
  }
  std::sort(found.begin(), found.end());
  for (double const level : {0.15, 0.1, 0.05, 0.025, 0.01, 0.005}) {
    auto const below = std::lower_bound(found.begin(), found.end(), level) - found.begin();
    EXPECT_NEAR(static_cast<double>(below) / 20000, level, 4 * std::sqrt(level / 20000)) << level;
  }
}

TEST(Normality, MeasuresTheShape) {
  PowerSums sums;
  for (double const x : {1., 2., 2., 3., 7.}) sums += {1, x, x * x, x * x * x, x * x * x * x};
  EXPECT_NEAR(sums.skewness(), 10.8 / std::pow(4.4, 1.5), 1e-12);  // about 3: −2, −1, −1, 0, 4
  EXPECT_NEAR(sums.excess_kurtosis(), 54.8 / (4.4 * 4.4) - 3, 1e-12);
}

TEST(Normality, OfFewOrEqualValuesIsNotTested) {
  EXPECT_TRUE(std::isnan(normality({1, 2, 3, 4, 5, 6, 7}, {}).p));
  EXPECT_TRUE(std::isnan(normality(std::vector<double>(9, 1.), {}).p));
}

TEST(Histogram, CountsEverythingOnce) {
  Histogram histogram(1000);
  for (int k = 0; k < 1000; ++k) histogram.add(-6 + 0.012 * k);
  histogram.add(std::nan(""));
  double area = 0;
  for (double const height : histogram.density()) area += height * histogram.width();
  EXPECT_NEAR(area, 1, 1e-12);
  EXPECT_EQ(histogram.bins() % 2, 1u);
  EXPECT_NEAR(histogram.centre(histogram.bins() / 2), 0, 1e-12);
  EXPECT_EQ(Histogram(5).density(), std::vector<double>(9, 0.0));
}

// --- all together ---------------------------------------------------------------------------------

TEST(Increments, AreTheSameInAnyUnit) {
  auto const ensemble = walks();
  auto other = ensemble;
  other.errors *= std::ldexp(1, -900);
  for (auto& t : other.times) t *= std::ldexp(1, 41);
  auto const here = *increment_tests(ensemble, {}), there = *increment_tests(other, {});
  EXPECT_EQ(here.autocorrelations[0].rho, there.autocorrelations[0].rho);
  EXPECT_EQ(here.variance_ratios[0].p, there.variance_ratios[0].p);
  EXPECT_EQ(here.variance_ratios[0].scale * std::ldexp(1, 41), there.variance_ratios[0].scale);
  EXPECT_NEAR(here.variance_ratios[0].sigma / there.variance_ratios[0].sigma / std::ldexp(std::sqrt(2.), 920), 1,
              1e-14);
  EXPECT_EQ(here.normality.anderson_darling, there.normality.anderson_darling);
}

TEST(Increments, AreTheSameOnAnyNumberOfThreads) {
  auto const ensemble = walks(500);
  int const threads = omp_get_max_threads();
  omp_set_num_threads(1);
  auto const one = *increment_tests(ensemble, {});
  omp_set_num_threads(3);
  auto const three = *increment_tests(ensemble, {});
  omp_set_num_threads(threads);
  EXPECT_EQ(one.autocorrelations[1].rho, three.autocorrelations[1].rho);
  EXPECT_EQ(one.variance_ratio_p, three.variance_ratio_p);
  EXPECT_EQ(one.normality.p, three.normality.p);
  EXPECT_EQ(one.histogram_density, three.histogram_density);
}

TEST(Increments, OfLargeEnsemblesAreSampledForNormalityAlone) {
  auto const ensemble = simulated({.diffusion = 2e-16}, 9000, log_spaced(31, 1e5), 3ul);
  auto const tests = *increment_tests(ensemble, {});
  EXPECT_EQ(tests.count, 270'000);
  EXPECT_GT(tests.normality.tested, 30'000);
  EXPECT_LE(tests.normality.tested, 100'000);
  EXPECT_GT(tests.normality.p, 1e-3);
}

TEST(Increments, ThatThereAreNoneOfAreNotTested) {
  EXPECT_FALSE(increment_tests(simulated({.diffusion = 1}, 8, {100}, 1ul), {}));
  EXPECT_FALSE(increment_tests(simulated({}, 8, log_spaced(8, 1e4), 1ul), {}));
  auto const two_times = increment_tests(simulated({.diffusion = 1}, 16, {100, 200}, 1ul), {});
  ASSERT_TRUE(two_times);
  EXPECT_THAT(two_times->autocorrelations, IsEmpty());
  EXPECT_THAT(two_times->variance_ratios, IsEmpty());
  EXPECT_TRUE(std::isnan(two_times->variance_ratio_p));
  EXPECT_EQ(two_times->count, 16);
}

TEST(Increments, OfOneMemberAreTestedWithoutIntervals) {
  auto const tests = *increment_tests(simulated({.diffusion = 1}, 1, linearly_spaced(64, 64), 1ul), {});
  EXPECT_TRUE(std::isfinite(tests.autocorrelations[0].p));
  EXPECT_TRUE(std::isnan(tests.autocorrelations[0].interval.low));
}

// --- what they object -----------------------------------------------------------------------------

std::string objection(std::function<double(double)> const& next, int members = 64) {
  return increments_objection(estimate(ensemble_of(next, members, linearly_spaced(64, 6400)), {}));
}

TEST(Objection, ToCorrelatedIncrementsSaysWhereSigmaHolds) {
  Increments next(1);
  // an autoregression of ρ = 0.3 is at long scales a walk of √(1.3/0.7) = 1.36 times the size; at 4 increments 1.25, at
  // 8 increments 1.30 times
  auto const said = objection([&](double x) { return next.autoregressive(0.3, x); }, 512);
  EXPECT_THAT(said, AllOf(HasSubstr("Its increments are correlated (ρ₁ = 0.2"),
                          testing::ContainsRegex("from scales of (400|800|1600) steps on σ is 2.[67]e-16 per √step, "
                                                 "1.[34] times what is said")));
}

TEST(Objection, ToHeavyTailsSaysWhatSigmaIsWorth) {
  Increments next(2);
  auto const said = objection([&](double) { return next.heavy_tailed(); });
  EXPECT_THAT(said, AllOf(HasSubstr("Its increments are not normal"), HasSubstr("times fewer normal ones")));
}

TEST(Objection, IsNotMadeToAWalk) {
  Increments next(3);
  int made = 0;
  for (int k = 0; k < 200; ++k) made += !objection([&](double) { return next.normal(); }, 16).empty();
  EXPECT_LE(made, 3);  // three tests at 0.001, most of which also ask for an effect
}

TEST(Objection, IsNotMadeToASmallEffectInALargeEnsemble) {
  Increments next(4);
  auto const ensemble =
      ensemble_of([&](double x) { return next.autoregressive(0.02, x); }, 2000, linearly_spaced(64, 6400));
  auto const e = estimate(ensemble, {});
  EXPECT_LT(e.increments->autocorrelations[0].p, 1e-6);
  EXPECT_THAT(increments_objection(e), IsEmpty());
}

TEST(Objection, IsNotMadeToWhatTheVerdictSaysItself) {
  auto const bounded = estimate(simulated({.noise = 1e-16}, 64, log_spaced(32, 1e5), 5ul), {});
  EXPECT_EQ(bounded.verdict, Verdict::bounded);
  EXPECT_LT(bounded.increments->autocorrelations[0].rho, -0.3);
  EXPECT_THAT(increments_objection(bounded), IsEmpty());
}

}  // namespace
}  // namespace brouwer
