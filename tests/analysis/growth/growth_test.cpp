// The growth exponent is the least-squares slope of log RMS, and its interval comes from resampled members.
#include "analysis/growth/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

constexpr double confidence = 0.95;

double width(Growth const& g) { return g.interval.high - g.interval.low; }

/// e = factor · t^exponent, one factor a member.
Ensemble power_law(std::vector<double> const& factors, double exponent, std::vector<double> const& times) {
  Ensemble ensemble;
  ensemble.times = times;
  ensemble.errors.resize(std::ssize(factors), std::ssize(times));
  for (Eigen::Index i = 0; i < ensemble.errors.rows(); ++i)
    for (Eigen::Index j = 0; j < ensemble.errors.cols(); ++j)
      ensemble.errors(i, j) =
          factors[static_cast<std::size_t>(i)] * std::pow(times[static_cast<std::size_t>(j)], exponent);
  return ensemble;
}

class PowerLawOfTime : public testing::TestWithParam<double> {};

TEST_P(PowerLawOfTime, IsRecoveredWithoutUncertainty) {
  auto const growth = growth_of(power_law({1e-17, -3e-17, 2e-17}, GetParam(), log_spaced(10, 1e6)), confidence);
  EXPECT_NEAR(growth.exponent, GetParam(), 1e-13);
  EXPECT_NEAR(growth.interval.low, GetParam(), 1e-12);
  EXPECT_NEAR(growth.interval.high, GetParam(), 1e-12);
}
INSTANTIATE_TEST_SUITE_P(Exponents, PowerLawOfTime, testing::Values(0, 0.5, 1, 1.5, 2));

TEST(Growth, IsTheTextbooksSlope) {
  Ensemble ensemble;
  ensemble.times = {1, std::exp(1), std::exp(2)};
  ensemble.errors.resize(2, 3);
  ensemble.errors << 1, 2, 3, 1, 2, 5;  // mean squares 1, 4, 17: the slope is (log 17 − log 1)/4 of log RMS
  EXPECT_NEAR(growth_of(ensemble, confidence).exponent, std::log(17) / 4, 1e-14);
}

TEST(Growth, LeavesOutSamplesAtWhichEveryErrorIsZero) {
  auto const times = log_spaced(20, 1e5);
  auto ensemble = simulated({.diffusion = 1e-16}, 32, times, 11);
  ensemble.errors.leftCols(5).setZero();
  Ensemble rest;
  rest.times.assign(times.begin() + 5, times.end());
  rest.errors = ensemble.errors.rightCols(15);
  EXPECT_EQ(growth_of(ensemble, confidence).exponent, growth_of(rest, confidence).exponent);
  EXPECT_EQ(growth_of(ensemble, confidence).interval.low, growth_of(rest, confidence).interval.low);
}

TEST(Growth, ResamplesOfMembersThatAreZeroEarlyAreFittedWithoutThoseSamples) {
  auto ensemble = simulated({.diffusion = 1e-16}, 12, log_spaced(20, 1e5), 12);
  ensemble.errors.block(1, 0, 11, 5).setZero();  // only member 0 has errors at first
  auto const growth = growth_of(ensemble, confidence);
  EXPECT_TRUE(std::isfinite(growth.interval.low) && std::isfinite(growth.interval.high));
  EXPECT_GT(width(growth), 0);
}

TEST(Growth, NeedsTwoTimesWithErrors) {
  auto ensemble = simulated({.diffusion = 1e-16}, 12, log_spaced(20, 1e5), 13);
  ensemble.errors.leftCols(19).setZero();
  EXPECT_TRUE(std::isnan(growth_of(ensemble, confidence).exponent));
  ensemble.errors.setZero();
  EXPECT_TRUE(std::isnan(growth_of(ensemble, confidence).exponent));
}

TEST(Growth, OfOneMemberHasNoInterval) {
  auto const growth = growth_of(simulated({.diffusion = 1e-16}, 1, log_spaced(20, 1e5), 14), confidence);
  EXPECT_TRUE(std::isfinite(growth.exponent));
  EXPECT_TRUE(std::isnan(growth.interval.low) && std::isnan(growth.interval.high));
}

TEST(Growth, IsTheSameBitsEveryTime) {
  auto const ensemble = simulated({.diffusion = 1e-16}, 100, log_spaced(20, 1e5), 15);
  EXPECT_EQ(growth_of(ensemble, confidence).interval.low, growth_of(ensemble, confidence).interval.low);
}

TEST(Growth, IntervalWidensWithConfidence) {
  auto const ensemble = simulated({.diffusion = 1e-16}, 1000, log_spaced(20, 1e5), 16);
  // Normal quantiles 2.576 and 1.645
  EXPECT_NEAR(width(growth_of(ensemble, 0.99)) / width(growth_of(ensemble, 0.9)), 1.566, 0.01);
}

TEST(Growth, GroupsOfMembersTellTheirUncertaintyAsMembersDo) {
  auto const times = log_spaced(20, 1e5);
  auto const few = growth_of(simulated({.diffusion = 1}, 1000, times, 17), confidence);
  auto const many = growth_of(simulated({.diffusion = 1}, 9000, times, 18), confidence);  // 1000 groups of 9
  EXPECT_NEAR(width(few) / width(many), 3, 0.3);
  EXPECT_NEAR(many.exponent, 0.5, 2 * width(many));
}

}  // namespace
}  // namespace brouwer
