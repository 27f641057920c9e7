// The full model: its likelihood against dense matrices in 50 digits, what it recovers, and how often it errs.
#include "analysis/growth/growth_model.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "analysis/growth/growth_choice.hpp"
#include "analysis/growth/growth_likelihood.hpp"
#include "analysis/growth/inference.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

using Digits50 = boost::multiprecision::cpp_bin_float_50;
using Column = std::vector<Digits50>;

/// V = LLᵀ, row by row.
class Cholesky {
 public:
  explicit Cholesky(std::vector<Column> V) : L_(std::move(V)) {
    for (std::size_t i = 0; i < L_.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        for (std::size_t k = 0; k < j; ++k) L_[i][j] -= L_[i][k] * L_[j][k];
        L_[i][j] = i == j ? Digits50(sqrt(L_[i][i])) : Digits50(L_[i][j] / L_[j][j]);
      }
  }
  /// L⁻¹x
  Column operator()(Column x) const {
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) x[i] -= L_[i][k] * x[k];
      x[i] /= L_[i][i];
    }
    return x;
  }
  Digits50 log_determinant() const {
    Digits50 sum = 0;
    for (std::size_t i = 0; i < L_.size(); ++i) sum += 2 * log(L_[i][i]);
    return sum;
  }

 private:
  std::vector<Column> L_;
};

Digits50 product(Column const& a, Column const& b) {
  Digits50 sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// −2 log of the restricted likelihood, of the errors themselves: V = σ² min(t, t') + τ²tt' + ν²δ, mean βt.
Digits50 dense_deviance(Ensemble const& ensemble, double sigma, double tau, double nu) {
  std::size_t const J = ensemble.times.size();
  Column const times(ensemble.times.begin(), ensemble.times.end());
  std::vector<Column> V(J, Column(J));
  for (std::size_t i = 0; i < J; ++i)
    for (std::size_t j = 0; j < J; ++j)
      V[i][j] = Digits50(sigma) * sigma * times[std::min(i, j)] + Digits50(tau) * tau * times[i] * times[j] +
                (i == j ? Digits50(nu) * nu : Digits50(0));
  Cholesky const whitened(V);
  auto const line = whitened(times);
  auto const M = ensemble.errors.rows();
  Digits50 along = 0, squares = 0;
  for (auto const& row : ensemble.errors.rowwise()) {
    auto const x = whitened(Column(row.begin(), row.end()));
    along += product(line, x);
    squares += product(x, x);
  }
  Digits50 const precision = M * product(line, line);
  return M * whitened.log_determinant() + log(precision) + squares - along * along / precision;
}

double deviance(GrowthLikelihood const& likelihood, double sigma, double tau, double nu) {
  bool const walks = sigma > 0;
  double const rho = walks ? nu * nu / (sigma * sigma) : INFINITY, scale = walks ? sigma * sigma : nu * nu;
  auto const reduced = likelihood.statistics().at(rho);
  return likelihood.deviance(reduced, scale, tau * tau + scale / reduced.precision);
}

TEST(GrowthLikelihood, IsThatOfDenseMatricesIn50Digits) {
  auto const ensemble = simulated({.drift = 0.3, .persistence = 0.02, .diffusion = 0.5, .noise = 0.7}, 5,
                                  {0.5, 1, 1.25, 4, 9, 9.5, 30, 64}, 11);
  GrowthStatistics const statistics(ensemble, {});
  GrowthLikelihood const likelihood(statistics);
  double const here = deviance(likelihood, 0.5, 0.02, 0.7);
  Digits50 const there = dense_deviance(ensemble, 0.5, 0.02, 0.7);
  for (auto const& [sigma, tau, nu] : {std::tuple{0.5, 0.0, 0.0},
                                       {0.4, 0.1, 0.0},
                                       {0.3, 0.0, 0.9},
                                       {1.1, 0.3, 2.0},
                                       {0.0, 0.0, 0.8},
                                       {0.0, 0.05, 1.2}}) {
    auto const expected = static_cast<double>(dense_deviance(ensemble, sigma, tau, nu) - there);
    EXPECT_NEAR(deviance(likelihood, sigma, tau, nu) - here, expected, 1e-11 * (1 + std::abs(expected)))
        << sigma << ' ' << tau << ' ' << nu;
  }
}

TEST(GrowthLikelihood, LosesNoDigitsToAnOverwhelmingDrift) {
  auto const plain = simulated({.diffusion = 1, .noise = 2}, 6, {1, 2, 4, 8, 16}, 3);
  auto drifting = plain;
  for (Eigen::Index j = 0; j < 5; ++j) drifting.errors.col(j).array() += std::ldexp(plain.times[std::size_t(j)], 20);
  GrowthStatistics const a(plain, {}), b(drifting, {});
  EXPECT_NEAR(b.at(2).residual / a.at(2).residual, 1, 1e-9);  // 10⁶ times the walk costs its six digits, not twelve
  EXPECT_NEAR(b.at(2).slope - std::ldexp(1, 20), a.at(2).slope, 1e-8);
}

TEST(GrowthLikelihood, IsTheClosedFormWhereThereIsNoNoise) {
  auto const ensemble = simulated({.persistence = 3e-18, .diffusion = 2e-16}, 16, log_spaced(12, 1e4), 7);
  auto const e = estimate(ensemble, {});
  ASSERT_TRUE(e.model.has_value());
  auto const& fitted = e.model->candidates[1];
  EXPECT_NEAR(fitted.drift / e.drift.per_step, 1, 1e-12);
  EXPECT_NEAR(fitted.diffusion / e.diffusion.per_sqrt_step, 1, 1e-12);
  EXPECT_NEAR(fitted.slopes / e.persistence.per_step, 1, 1e-12);
  EXPECT_NEAR(e.model->t / e.drift.t, 1, 1e-12);
  EXPECT_NEAR(e.model->drift.low / e.drift.interval.low, 1, 1e-12);
}

TEST(GrowthLikelihood, ItsBestIsAMinimumAmongItsNeighbours) {
  auto const ensemble = simulated({.persistence = 0.1, .diffusion = 1, .noise = 3}, 12, log_spaced(10, 100), 5);
  GrowthStatistics const statistics(ensemble, {});
  GrowthLikelihood const likelihood(statistics);
  auto const best = likelihood.best(true);
  double const sigma = std::sqrt(best.sigma2()), tau = std::sqrt(best.tau2), nu = std::sqrt(best.nu2());
  for (double const factor : {0.99, 1.01}) {
    EXPECT_GT(deviance(likelihood, factor * sigma, tau, nu), best.deviance);
    EXPECT_GT(deviance(likelihood, sigma, factor * tau, nu), best.deviance);
    EXPECT_GT(deviance(likelihood, sigma, tau, factor * nu), best.deviance);
  }
}

TEST(GrowthModel, RecoversEveryPartFromUnevenTimes) {
  Law const law{.drift = 1e-18, .persistence = 2e-18, .diffusion = 2e-16, .noise = 3e-15};
  auto const e = estimate(simulated(law, 4000, log_spaced(24, 1e5), 17ul), {});
  ASSERT_TRUE(e.model.has_value());
  EXPECT_EQ(e.model->law().terms, (LawTerms{true, true, true}));
  EXPECT_NEAR(e.drift.per_step / law.drift, 1, 0.15);  // four standard errors are 4·2.1e-18/√4000
  EXPECT_NEAR(e.persistence.per_step / law.persistence, 1, 0.06);
  EXPECT_NEAR(e.diffusion.per_sqrt_step / law.diffusion, 1, 0.03);
  EXPECT_NEAR(e.noise.size / law.noise, 1, 0.03);
}

struct Supported {
  char const* name;
  Law law;
  LawTerms terms;
};
void PrintTo(Supported const& s, std::ostream* out) { *out << s.name; }

class ChoiceOfLaw : public testing::TestWithParam<Supported> {};

TEST_P(ChoiceOfLaw, IsTheOneTheDataCameFromNineteenTimesInTwenty) {
  Normal normal(1959);
  int right = 0;
  for (int k = 0; k < 60; ++k) {
    auto const e = estimate(simulated(GetParam().law, 64, log_spaced(32, 1e5), normal), {});
    right += e.model && e.model->law().terms == GetParam().terms;
  }
  EXPECT_GE(right, 57);
}
INSTANTIATE_TEST_SUITE_P(
    Laws, ChoiceOfLaw,
    testing::Values(Supported{"walk", {.diffusion = 2e-16}, {true, false, false}},
                    Supported{"slopes", {.persistence = 2e-18, .diffusion = 2e-16}, {true, true, false}},
                    Supported{"walk_and_noise", {.diffusion = 2e-16, .noise = 3e-15}, {true, false, true}},
                    Supported{"all", {.persistence = 2e-18, .diffusion = 2e-16, .noise = 3e-15}, {true, true, true}},
                    Supported{"noise", {.noise = 1e-16}, {false, false, true}},
                    Supported{"noise_and_slopes", {.persistence = 1e-20, .noise = 1e-16}, {false, true, true}}),
    [](auto const& test) { return test.param.name; });

/// Not more often than the level says: four standard errors of the binomial law above it.
void expect_at_most(int count, int trials, double level) {
  EXPECT_LE(count, trials * level + 4 * std::sqrt(trials * level * (1 - level))) << "of " << trials;
}

class FalseNoise : public testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(FalseNoise, IsNotSeenInAWalkMoreOftenThanTheLevelSays) {
  auto const [members, heavy] = GetParam();
  Levels const levels{.confidence = 0.95, .test = 0.05, .power = 0.9};
  Normal normal(77);
  int seen = 0;
  for (int k = 0; k < 400; ++k) {
    auto const e = estimate(
        simulated({.diffusion = 1, .shape = heavy ? student_5 : normal_shape}, members, log_spaced(16, 1e4), normal),
        levels);
    seen += e.model->law().terms.noise;
  }
  expect_at_most(seen, 400, 0.05);
}
INSTANTIATE_TEST_SUITE_P(NormalAndHeavy, FalseNoise, testing::Combine(testing::Values(8, 64), testing::Bool()));

bool holds(Interval i, double truth) { return i.low <= truth && truth <= i.high; }

TEST(GrowthModel, IntervalsCoverAsOftenAsTheySay) {
  Law const law{.drift = 1e-18, .persistence = 2e-18, .diffusion = 2e-16, .noise = 3e-15};
  Normal normal(3);
  constexpr int trials = 400;
  int beta = 0, tau = 0, sigma = 0, nu = 0;
  for (int k = 0; k < trials; ++k) {
    auto const e = estimate(simulated(law, 32, log_spaced(24, 1e5), normal), {});
    ASSERT_TRUE(e.model.has_value());
    beta += holds(e.model->drift, law.drift);
    tau += holds(e.model->slopes, law.persistence);
    sigma += holds(e.model->diffusion, law.diffusion);
    nu += holds(e.model->noise, law.noise);
  }
  double const four_errors = 4 * std::sqrt(trials * 0.95 * 0.05);
  for (int const covered : {beta, tau, sigma, nu}) EXPECT_NEAR(covered, 0.95 * trials, four_errors);
}

TEST(GrowthModel, SlopesThatAreNotThereHaveAnIntervalFromZero) {
  auto const e = estimate(simulated({.diffusion = 2e-16}, 64, log_spaced(16, 1e4), 21ul), {});
  EXPECT_EQ(e.persistence.interval.low, 0);
  EXPECT_GT(e.persistence.interval.high, 0);
  EXPECT_LT(e.persistence.interval.high, 2e-16 / 100);  // σ/√t_J, the spread of a walk's slopes
}

class UnitOfTheModel : public testing::TestWithParam<int> {};

TEST_P(UnitOfTheModel, ScalesItExactly) {
  auto ensemble = simulated({.persistence = 2, .diffusion = 200, .noise = 3000}, 16, log_spaced(16, 1e4), 9ul);
  auto const one = estimate(ensemble, {});
  double const unit = std::ldexp(1, GetParam());
  ensemble.errors *= unit;
  auto const e = estimate(ensemble, {});
  EXPECT_EQ(e.noise.size, unit * one.noise.size);
  EXPECT_EQ(e.model->slopes.high, unit * one.model->slopes.high);
  EXPECT_EQ(e.model->p_noise, one.model->p_noise);
}
INSTANTIATE_TEST_SUITE_P(FromTheTiniestToTheLargest, UnitOfTheModel, testing::Values(-900, -50, 50, 900));

TEST(GrowthModel, SaysNothingWhereThereIsNothingToChooseFrom) {
  auto const model = [](int members, std::vector<double> const& times) {
    return estimate(simulated({.diffusion = 1}, members, times, 1ul), {}).model.has_value();
  };
  EXPECT_FALSE(model(1, {1, 2, 3, 4}));
  EXPECT_FALSE(model(8, {5}));
  EXPECT_FALSE(model(8, {5, 6})) << "two times do not tell noise from walk";
  EXPECT_TRUE(model(2, {5, 6, 7}));
  auto equal = simulated({.diffusion = 1}, 1, {1, 2, 3}, 1ul);
  equal.errors = ErrorMatrix(equal.errors.replicate(6, 1));
  EXPECT_FALSE(estimate(equal, {}).model.has_value()) << "members that are equal have no spread";
}

TEST(GrowthModel, ThinsMoreTimesThanItUses) {
  std::vector<double> times;
  for (int j = 1; j <= 1000; ++j) times.push_back(j);
  auto const e = estimate(simulated({.diffusion = 1, .noise = 5}, 64, times, 4ul), {});
  EXPECT_EQ(e.model->law().terms, (LawTerms{true, false, true}));
  EXPECT_TRUE(holds(e.model->noise, 5) && holds(e.model->diffusion, 1));
}

TEST(BoundaryP, IsHalfOfAChiSquareOfOneDegree) {
  EXPECT_EQ(boundary_p(0), 1);
  EXPECT_NEAR(boundary_p(2.705543454095404), 0.05, 1e-12);
}

TEST(Verdict, IsAWalkBesideBoundedNoiseWhereTheExponentCannotTell) {
  auto const e = estimate(simulated({.diffusion = 2e-16, .noise = 3e-14}, 64, log_spaced(32, 1e5), 8ul), {});
  EXPECT_EQ(e.verdict, Verdict::random_walk);
  EXPECT_TRUE(holds(e.diffusion.interval, 2e-16));
  EXPECT_NE(e.sentence.find("told apart from bounded noise of"), std::string::npos) << e.sentence;
}

/// Members that share an oscillation beside their own walks.
TEST(Verdict, SaysThatAnOscillationIsSharedWhereTheMeanMoves) {
  auto ensemble = simulated({.diffusion = 0.01}, 32, log_spaced(32, 1e4), 8ul);
  for (Eigen::Index j = 0; j < 32; ++j) ensemble.errors.col(j).array() += 3 * std::sin(1.7 * double(j * j));
  auto const e = estimate(ensemble, {});
  ASSERT_TRUE(e.model.has_value());
  EXPECT_LT(e.model->p_course, 1e-6);
  EXPECT_EQ(e.verdict, Verdict::not_resolved) << e.sentence;
  EXPECT_NE(e.sentence.find("the mean of all members is no straight line"), std::string::npos) << e.sentence;
}

}  // namespace
}  // namespace brouwer
