// The closed-form inference against the same formulas in 113 bits with another library's distributions, and its edges.
#include "analysis/growth/inference.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <brouwer/error.hpp>
#include <cmath>

#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
constexpr double digits12 = 1e-12;

Ensemble random_walks(int members = 16) {
  return simulated({.drift = 1e-18, .diffusion = 2e-16}, members, log_spaced(12, 1e4), 1937);
}

/// Every formula written down once more, member by member, in 113 bits.
struct Textbook {
  Quad M, J, T, beta, variance, sigma2;

  explicit Textbook(Ensemble const& e) : M(e.errors.rows()), J(e.errors.cols()), T(e.times.back()) {
    for (auto const& row : e.errors.rowwise()) beta += row[row.size() - 1] / T / M;
    for (auto const& row : e.errors.rowwise()) {
      Quad const slope = row[row.size() - 1] / T;
      variance += (slope - beta) * (slope - beta) / (M - 1);
      for (Eigen::Index j = 0; j < row.size(); ++j) {
        Quad const before = j ? Quad(row[j - 1]) : Quad(0), t0 = j ? Quad(e.times[std::size_t(j) - 1]) : Quad(0);
        Quad const delta = e.times[std::size_t(j)] - t0, rest = row[j] - before - delta * slope;
        sigma2 += rest * rest / delta / (M * (J - 1));
      }
    }
  }
  Quad t() const { return beta / sqrt(variance / M); }
  Quad F() const { return T * variance / sigma2; }
};

void expect_relative(double found, Quad expected, double tolerance = digits12) {
  EXPECT_LE(abs(found - expected), tolerance * abs(expected)) << found << " instead of " << expected;
}

TEST(Inference, IsTheTextbooksDrift) {
  auto const ensemble = random_walks();
  auto const e = estimate(ensemble, {});
  Textbook const book(ensemble);
  boost::math::students_t_distribution<Quad> const student(book.M - 1);
  Quad const half = quantile(complement(student, Quad(0.025))) * sqrt(book.variance / book.M);
  expect_relative(e.drift.per_step, book.beta);
  expect_relative(e.drift.t, book.t());
  expect_relative(e.drift.p, 2 * cdf(complement(student, abs(book.t()))));
  expect_relative(e.drift.interval.low, book.beta - half);
  expect_relative(e.drift.interval.high, book.beta + half);
}

TEST(Inference, IsTheTextbooksPersistence) {
  auto const ensemble = simulated({.persistence = 3e-18, .diffusion = 2e-16}, 16, log_spaced(12, 1e4), 7);
  auto const e = estimate(ensemble, {});
  Textbook const book(ensemble);
  boost::math::fisher_f_distribution<Quad> const fisher(book.M - 1, book.M * (book.J - 1));
  expect_relative(e.persistence.F, book.F());
  expect_relative(e.persistence.p, cdf(complement(fisher, book.F())));
  expect_relative(e.persistence.p_low, cdf(fisher, book.F()));
  expect_relative(e.persistence.per_step, sqrt(book.variance - book.sigma2 / book.T));
}

TEST(Inference, IsTheTextbooksDiffusion) {
  auto const ensemble = random_walks();
  auto const e = estimate(ensemble, {});
  Textbook const book(ensemble);
  Quad const degrees = book.M * (book.J - 1);
  boost::math::chi_squared_distribution<Quad> const chi(degrees);
  expect_relative(e.diffusion.per_sqrt_step, sqrt(book.sigma2));
  expect_relative(e.diffusion.interval.low, sqrt(book.sigma2 * degrees / quantile(complement(chi, Quad(0.025)))));
  expect_relative(e.diffusion.interval.high, sqrt(book.sigma2 * degrees / quantile(chi, Quad(0.025))));
}

TEST(Inference, SmallestVisibleDriftIsSeenWithTheStatedChance) {
  for (int const members : {2, 4, 16, 64}) {
    auto const e = estimate(random_walks(members), {});
    double const noncentrality = e.smallest_visible_drift / (e.drift.per_step / e.drift.t);
    boost::math::non_central_t const t(members - 1, std::abs(noncentrality));
    boost::math::students_t const null(members - 1);
    EXPECT_NEAR(cdf(complement(t, quantile(complement(null, 0.0005)))), 0.9, 0.003) << members;
  }
}

TEST(Inference, DescribesTheCourseOfMeanAndRms) {
  Ensemble ensemble;
  ensemble.times = {1, 2};
  ensemble.errors.resize(3, 2);
  ensemble.errors << 1, 2, 2, 4, 6, -3;
  auto const e = estimate(ensemble, {});
  EXPECT_DOUBLE_EQ(e.mean[0], 3);
  EXPECT_DOUBLE_EQ(e.mean[1], 1);
  EXPECT_DOUBLE_EQ(e.mean_error[0], std::sqrt(7.0 / 3));  // variance ((−2)² + (−1)² + 3²)/2 = 7
  EXPECT_DOUBLE_EQ(e.rms[0], std::sqrt(41.0 / 3));
  EXPECT_DOUBLE_EQ(e.rms_final, std::sqrt(29.0 / 3));
  EXPECT_DOUBLE_EQ(e.drift.share, 1 / std::sqrt(29.0 / 3));
}

class UnitOfErrors : public testing::TestWithParam<int> {};

TEST_P(UnitOfErrors, ScalesEstimatesExactlyAndLeavesTestsAlone) {
  auto ensemble = random_walks();
  ensemble.errors *= std::ldexp(1, 52);  // to about 1: the units below then reach both ends of double
  auto const one = estimate(ensemble, {});
  double const unit = std::ldexp(1, GetParam());
  ensemble.errors *= unit;
  auto const e = estimate(ensemble, {});
  EXPECT_EQ(e.drift.t, one.drift.t);
  EXPECT_EQ(e.drift.p, one.drift.p);
  EXPECT_EQ(e.persistence.F, one.persistence.F);
  EXPECT_EQ(e.growth.exponent, one.growth.exponent);
  EXPECT_EQ(e.growth.interval.low, one.growth.interval.low);
  EXPECT_EQ(e.drift.per_step, unit * one.drift.per_step);
  EXPECT_EQ(e.diffusion.interval.high, unit * one.diffusion.interval.high);
  EXPECT_EQ(e.smallest_visible_drift, unit * one.smallest_visible_drift);
  EXPECT_EQ(e.rms_final, unit * one.rms_final);
  EXPECT_EQ(e.verdict, one.verdict);
}
INSTANTIATE_TEST_SUITE_P(FromTheTiniestToTheLargest, UnitOfErrors, testing::Values(-980, -600, -50, 50, 600, 1000));

TEST(Inference, DriftIsPerUnitOfTimeAndDiffusionPerItsRoot) {
  auto ensemble = random_walks();
  auto const one = estimate(ensemble, {});
  double const unit = std::ldexp(1, 301);
  for (double& t : ensemble.times) t *= unit * unit;
  auto const e = estimate(ensemble, {});
  EXPECT_EQ(e.drift.t, one.drift.t);
  EXPECT_EQ(e.persistence.F, one.persistence.F);
  EXPECT_EQ(e.drift.per_step, one.drift.per_step / unit / unit);
  EXPECT_EQ(e.diffusion.per_sqrt_step, one.diffusion.per_sqrt_step / unit);
  EXPECT_NEAR(e.growth.exponent, one.growth.exponent, 1e-10);
}

TEST(Inference, OneMemberLeavesSpreadUndefinedAndDiffusionDefined) {
  auto const e = estimate(random_walks(1), {});
  for (double const x : {e.drift.t, e.drift.p, e.drift.interval.low, e.persistence.F, e.persistence.p, e.mean_error[0],
                         e.growth.interval.high, e.smallest_visible_drift})
    EXPECT_TRUE(std::isnan(x));
  EXPECT_GT(e.diffusion.per_sqrt_step, e.diffusion.interval.low);
  EXPECT_LT(e.diffusion.per_sqrt_step, e.diffusion.interval.high);
  EXPECT_EQ(e.verdict, Verdict::not_resolved);
}

TEST(Inference, OneSampleTimeStillTestsTheDrift) {
  auto const still = estimate(simulated({.diffusion = 1e-16}, 64, {1e4}, 3), {});
  EXPECT_TRUE(std::isnan(still.diffusion.per_sqrt_step) && std::isnan(still.persistence.p) &&
              std::isnan(still.growth.exponent));
  EXPECT_EQ(still.verdict, Verdict::not_resolved);
  EXPECT_EQ(estimate(simulated({.drift = 1e-17, .diffusion = 1e-16}, 64, {1e4}, 3), {}).verdict, Verdict::drift);
}

TEST(Inference, ErrorsThatAreAllZeroAreExact) {
  auto ensemble = random_walks();
  ensemble.errors.setZero();
  auto const e = estimate(ensemble, {});
  EXPECT_EQ(e.verdict, Verdict::exact);
  EXPECT_EQ(e.drift.per_step, 0);
  EXPECT_EQ(e.rms_final, 0);
}

TEST(Inference, EqualMembersHaveAnInfiniteT) {
  auto ensemble = random_walks();
  for (auto row : ensemble.errors.rowwise())
    row = 1e-19 * Eigen::Map<Eigen::RowVectorXd const>(ensemble.times.data(), row.size());
  auto const e = estimate(ensemble, {});
  EXPECT_EQ(e.drift.t, std::numeric_limits<double>::infinity());
  EXPECT_EQ(e.drift.p, 0);
  EXPECT_EQ(e.verdict, Verdict::drift);
  EXPECT_NE(e.sentence.find("t is infinite"), std::string::npos) << e.sentence;
}

TEST(Inference, ConstantErrorsAreBoundedAndNoDrift) {
  auto ensemble = random_walks();
  ensemble.errors.setConstant(3e-17);
  EXPECT_EQ(estimate(ensemble, {}).verdict, Verdict::bounded);
  Normal normal(5);
  for (auto row : ensemble.errors.rowwise()) row.setConstant(1 + 0.1 * normal());  // each member its own offset
  EXPECT_EQ(estimate(ensemble, {}).verdict, Verdict::bounded);
}

TEST(Inference, RefusesAnEnsembleWithoutMembers) {
  Ensemble ensemble;
  ensemble.times = {1, 2};
  ensemble.errors.resize(0, 2);
  EXPECT_THROW(estimate(ensemble, {}), InputError);
}

/// Of one error that is not 0 no law of growth is told.
TEST(Inference, OfOneErrorThatIsNotZeroResolvesNothing) {
  auto ensemble = simulated({.diffusion = 1}, 8, log_spaced(16, 1000), 3);
  ensemble.errors.setZero();
  ensemble.errors(5, 15) = 1e-16;
  auto const e = estimate(ensemble, {});
  EXPECT_EQ(e.verdict, Verdict::not_resolved);
  EXPECT_EQ(e.sentence.find("nan"), std::string::npos) << e.sentence;
}

}  // namespace
}  // namespace brouwer
