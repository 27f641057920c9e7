// Simulated local errors with known bias, correlation and slopes: intervals cover as often as they say, tests cry wolf as
// rarely. Seeds are fixed; bounds are four standard errors of the binomial law.
#include "analysis/probe/local_errors.hpp"

#include <brouwer/error.hpp>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

constexpr double size = 2e-16;

/// β + bᵢ + an autoregressive sequence x' = ρx + √(1 − ρ²) size N.
struct Steps {
  double bias = 0, persistence = 0, correlation = 0;
  double diffusion() const { return size * std::sqrt((1 + correlation) / (1 - correlation)); }
};

LocalErrors simulated_steps(Steps const& law, int members, int windows, int length, Normal& normal) {
  LocalErrors errors;
  errors.quantity = errors.family = "energy";
  errors.windows = windows;
  errors.length = errors.judged = length;
  errors.covered = 16 * windows * length;
  errors.rounding.resize(members, windows * length);
  for (auto row : errors.rounding.rowwise()) {
    double const bias = law.bias + law.persistence * normal();
    for (Eigen::Index k = 0; k < row.size(); ++k) {
      double const fresh = size * normal();
      double const last = k % length == 0 ? fresh : row[k - 1] - bias;
      row[k] = k % length == 0
                   ? bias + fresh
                   : bias + law.correlation * last + std::sqrt(1 - law.correlation * law.correlation) * fresh;
    }
  }
  return errors;
}

LocalErrors simulated_steps(Steps const& law, int members, int windows, int length, unsigned long seed) {
  Normal normal(seed);
  return simulated_steps(law, members, windows, length, normal);
}

void expect_binomial(int count, int trials, double probability) {
  double const error = std::sqrt(trials * probability * (1 - probability));
  EXPECT_NEAR(count, trials * probability, 4 * error) << "of " << trials;
}

bool covers(Interval interval, double truth) { return interval.low <= truth && truth <= interval.high; }

struct Tally {
  int trials = 400, beta = 0, sigma = 0, tau = 0, bias_seen = 0, slopes_seen = 0, changing = 0;
};

Tally tally(Steps const& law, int members, Levels const& levels, double sigma) {
  Tally count;
  Normal normal(11);
  for (int k = 0; k < count.trials; ++k) {
    auto const found = estimate(simulated_steps(law, members, 8, 32, normal), levels).rounding;
    count.beta += covers(found.bias.interval, law.bias);
    count.sigma += covers(found.diffusion.interval, sigma);
    count.tau += covers(found.persistence.interval, law.persistence);
    count.bias_seen += found.bias.p < levels.test;
    count.slopes_seen += found.persistence.p < levels.test;
    count.changing += found.still_changing;
  }
  return count;
}

TEST(LocalErrors, IntervalsCoverAndTestsKeepTheirLevelWhereStepsAreIndependent) {
  Levels const levels{.confidence = 0.9, .test = 0.05, .power = 0.9};
  Steps const law;
  auto const count = tally(law, 24, levels, law.diffusion());
  expect_binomial(count.beta, count.trials, 0.9);
  expect_binomial(count.sigma, count.trials, 0.9);
  expect_binomial(count.bias_seen, count.trials, 0.05);
  expect_binomial(count.slopes_seen, count.trials, 0.05);
  EXPECT_LT(count.changing, 0.05 * count.trials + 4 * std::sqrt(0.05 * count.trials));
}

TEST(LocalErrors, SigmaCoversWhereStepsAreCorrelatedOverAFewSteps) {
  Levels const levels{.confidence = 0.9, .test = 0.05, .power = 0.9};
  for (double const correlation : {-0.4, 0.6}) {
    Steps const law{.bias = 3e-17, .persistence = 0, .correlation = correlation};
    auto const count = tally(law, 24, levels, law.diffusion());
    expect_binomial(count.sigma, count.trials, 0.9);
    expect_binomial(count.beta, count.trials, 0.9);
  }
}

TEST(LocalErrors, PersistentSlopesAreCoveredAndSeen) {
  Levels const levels{.confidence = 0.9, .test = 0.001, .power = 0.9};
  Steps const law{.bias = 0, .persistence = 5e-17, .correlation = 0};
  auto const count = tally(law, 24, levels, law.diffusion());
  expect_binomial(count.beta, count.trials, 0.9);
  expect_binomial(count.tau, count.trials, 0.9);
  EXPECT_EQ(count.slopes_seen, count.trials);
}

TEST(LocalErrors, HalvedWindowsTakeTheBiasOfFirstOrderAway) {
  Steps const law{.bias = 0, .persistence = 0, .correlation = 0.8};
  auto const found = estimate(simulated_steps(law, 4000, 8, 64, 3), {}).rounding;
  double const whole = found.scales.back() / law.diffusion();
  EXPECT_NEAR(found.diffusion.per_sqrt_step / law.diffusion(), 1, 0.02);
  EXPECT_NEAR(whole * whole, 1 - 2 * (0.8 / 0.04) / 9 / 64, 0.02) << "windows alone fall short by 2 Σkρᵏ/L";
  EXPECT_NEAR(found.autocorrelation[0], 0.8, 0.01);
  EXPECT_NEAR(found.autocorrelation[7], std::pow(0.8, 8), 0.01);
  EXPECT_NEAR(found.scales.front() / size, 1, 0.01);
  EXPECT_FALSE(found.still_changing);
}

/// A wave of many windows' length, as constants make that are rounded once and act according to the phase of the motion.
TEST(LocalErrors, ThatWaveAreOfNoWalk) {
  auto errors = simulated_steps({}, 64, 8, 64, 10ul);
  for (Eigen::Index i = 0; i < 64; ++i)
    for (Eigen::Index k = 0; k < 512; ++k)
      errors.rounding(i, k) += 4 * size * std::sin(2 * M_PI * double(k % 64) / 64 + double(i));
  auto const found = estimate(errors, {}).rounding;
  EXPECT_TRUE(found.still_changing);
  EXPECT_NEAR(found.diffusion.per_sqrt_step / size, 1, 0.15) << "a whole wave is no diffusion";
}

TEST(LocalErrors, CorrelationLongerThanAWindowIsSaid) {
  Steps const law{.bias = 0, .persistence = 0, .correlation = 0.99};
  EXPECT_TRUE(estimate(simulated_steps(law, 64, 8, 64, 4), {}).rounding.still_changing);
}

TEST(LocalErrors, PredictTheLongRun) {
  Steps const law{.bias = 4e-17, .persistence = 2e-17, .correlation = 0.3};
  auto const local = estimate(simulated_steps(law, 4000, 8, 64, 5), {});
  auto const p = predict(local, 100'000);
  ASSERT_TRUE(p);
  EXPECT_NEAR(p->drift.per_step / law.bias, 1, 0.03);
  EXPECT_NEAR(p->persistence.per_step / law.persistence, 1, 0.05);
  EXPECT_NEAR(p->diffusion.per_sqrt_step / law.diffusion(), 1, 0.03);
  EXPECT_NEAR(p->persistence.F / (1 + 1e5 * std::pow(law.persistence / law.diffusion(), 2)), 1, 0.1);
  EXPECT_NEAR(p->rms_final / std::hypot(4e-12, 2e-12, law.diffusion() * std::sqrt(1e5)), 1, 0.03);
}

TEST(LocalErrors, OfAMethodThatErrsPredictItsDriftAndNoWalk) {
  auto errors = simulated_steps({}, 64, 8, 64, 6ul);
  errors.truncation = ErrorMatrix::Constant(64, 512, -1e-10);
  errors.truncation.leftCols(256).array() += 1e-11;
  auto const local = estimate(errors, {});
  ASSERT_TRUE(local.both && local.truncation);
  EXPECT_NEAR(local.truncation->bias.per_step, -9.5e-11, 1e-20);
  EXPECT_GT(local.rounding.bias.p, 0.001) << "rounding is told apart";
  auto const p = predict(local, 1000);
  EXPECT_NEAR(p->drift.per_step, -9.5e-11, 1e-15);
  EXPECT_TRUE(std::isnan(p->diffusion.per_sqrt_step));
}

TEST(LocalErrors, OfAStatePredictNothing) {
  auto errors = simulated_steps({}, 8, 8, 8, 7ul);
  errors.of_state = true;
  auto const local = estimate(errors, {});
  EXPECT_FALSE(predict(local, 1000));
  EXPECT_NEAR(local.rounding.size / size, 1, 0.1);
}

TEST(LocalErrors, OfAQuantityThatNeverErrsAreZero) {
  auto errors = simulated_steps({}, 8, 8, 8, 8ul);
  errors.rounding.setZero();
  auto const local = estimate(errors, {});
  EXPECT_EQ(local.rounding.bias.per_step, 0);
  EXPECT_EQ(local.rounding.diffusion.per_sqrt_step, 0);
  EXPECT_FALSE(local.rounding.still_changing);
}

TEST(LocalErrors, OfOneMemberAreRefused) { EXPECT_THROW(estimate(simulated_steps({}, 1, 8, 8, 9ul), {}), InputError); }

}  // namespace
}  // namespace brouwer
