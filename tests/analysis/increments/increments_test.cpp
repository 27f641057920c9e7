// What increments say: each statistic against its definition written down once more, and the edges.
#include "analysis/increments/increments.hpp"

#include <gmock/gmock.h>
#include <omp.h>

#include <cmath>

#include "analysis/increments/free_increments.hpp"
#include "analysis/increments/normality.hpp"
#include "analysis/increments/variance_ratio.hpp"
#include "tests/analysis/simulated_increments.hpp"
#include "tests/analysis/walks.hpp"

namespace brouwer {
namespace {

using testing::IsEmpty;

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

}  // namespace
}  // namespace brouwer
