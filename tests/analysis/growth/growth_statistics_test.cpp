// The mean of the members is held against how members differ, whatever the shape of their errors in time is.
#include "analysis/growth/growth_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/growth/inference.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

std::vector<double> even(int count, double last) {
  std::vector<double> times;
  for (int j = 1; j <= count; ++j) times.push_back(last * j / count);
  return times;
}

/// Of ensembles that share nothing, how many have a mean that is called bent at 0.05.
int bent(Law const& law, int members, std::vector<double> const& times, int trials) {
  Normal normal(29);
  int found = 0;
  for (int trial = 0; trial < trials; ++trial) {
    auto const e = estimate(simulated(law, members, times, normal), {});
    found += e.model && e.model->p_course < 0.05;
  }
  return found;
}

/// A phase is the integral of a walk: its increments have one shape, and the mean's has it, too.
TEST(MeanCourse, OfSmoothErrorsIsNotBentTooOften) {
  int const trials = 400;
  double const most = 0.05 * trials + 3.9 * std::sqrt(trials * 0.05 * 0.95);
  for (int const members : {8, 64}) {
    EXPECT_LE(bent({.diffusion = 1, .phase = true}, members, log_spaced(16, 1e4), trials), most) << members;
    EXPECT_LE(bent({.diffusion = 1, .phase = true}, members, even(16, 1e4), trials), most) << members;
    EXPECT_LE(bent({.persistence = 1, .diffusion = 1, .phase = true}, members, even(16, 100), trials), most) << members;
  }
}

TEST(MeanCourse, OfAWalkIsTestedAtItsLevel) {
  int const trials = 1000;
  double const sd = std::sqrt(trials * 0.05 * 0.95);
  for (int const members : {8, 64})
    EXPECT_NEAR(bent({.diffusion = 1}, members, even(16, 1e4), trials), 0.05 * trials, 3.9 * sd);
}

TEST(Sphericity, IsOneOfAWalkAndSmallOfOneShape) {
  auto const of = [](Law const& law) {
    auto const ensemble = simulated(law, 4000, even(16, 1e4), 3);
    return GrowthStatistics(ensemble, units_of(ensemble)).sphericity(0);
  };
  EXPECT_NEAR(of({.diffusion = 1}), 1, 0.02);
  double const phase = of({.diffusion = 1, .phase = true});
  EXPECT_LT(phase, 0.3);
  EXPECT_GT(phase, 1.0 / 15);
  auto const two = simulated({.diffusion = 1}, 2, even(16, 1e4), 3);
  EXPECT_EQ(GrowthStatistics(two, units_of(two)).sphericity(0), 1.0 / 15);
}

}  // namespace
}  // namespace brouwer
