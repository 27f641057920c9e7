// Increments freed of slopes, against the recursive residuals of a regression.
#include "analysis/increments/free_increments.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "analysis/growth/inference.hpp"
#include "tests/analysis/walks.hpp"

namespace brouwer {
namespace {

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

}  // namespace
}  // namespace brouwer
