// The matrix form of the discrete Moser–Veselov algorithm and its quaternion form are oracles of one another.
#include <brouwer/integrators/dmv.hpp>
#include <brouwer/integrators/dmv_matrix.hpp>
#include <brouwer/scalar/double_double.hpp>

#include <gtest/gtest.h>

#include "tests/bodies.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::BodyCase;
using testing_support::generic_bodies;
using testing_support::Judge;
using testing_support::special_bodies;
using testing_support::Uniform;

template <class S>
RigidBodyState<typename S::Scalar> advanced(BodyCase const& c, double h, int steps) {
  using T = typename S::Scalar;
  auto y = c.start<T>();
  advance(S({c.body<T>(), T(h), y}), y, steps);
  return y;
}

bool is_number(double a) { return !std::isnan(a); }

/// How far the two forms are apart after some steps, in ε and |y| (of the attitude: 1); NaN where one has no numbers.
template <class T>
double difference(BodyCase const& c, double h, int steps) {
  auto const a = advanced<DmvMatrix<T>>(c, h, steps), b = advanced<Dmv2<T>>(c, h, steps);
  double worst = 0;
  for_components(
      [&](T const& v, T const& w) {
        double const d = std::abs(static_cast<double>(T(v - w)));
        worst = d <= worst ? worst : d;  // NaN stays
        if (std::isnan(d)) worst = d;
      },
      a, b);
  double const length = std::hypot(c.momentum[0], c.momentum[1], c.momentum[2]);
  return worst / static_cast<double>(epsilon<T>()) / std::max(1.0, length);
}

std::vector<BodyCase> all_bodies() {
  auto cases = generic_bodies();
  for (auto const& c : special_bodies()) cases.push_back(c);
  return cases;
}

/// Real bodies of any shape, every fourth one nearly flat and every fifth one nearly a ball.
BodyCase random_body(Uniform& uniform, int i) {
  double const I1 = uniform(0.2, 1), I2 = i % 5 == 0 ? I1 * (1 + uniform(0, 1e-6)) : I1 * uniform(1, 4);
  double const I3 = i % 5 == 0   ? I2 * (1 + uniform(0, 1e-6))
                    : i % 4 == 0 ? I1 + I2 * (1 - uniform(0, 1e-6))
                                 : uniform(I2, I1 + I2);
  return {"random", {I1, I2, I3}, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}, {0.5, 0.5, -0.5, 0.5}};
}

TEST(DmvMatrix, IsTheQuaternionFormTo75DigitsInMomentumAndAttitude) {
  for (auto const& c : all_bodies())
    for (double h : {0.05, -0.125}) EXPECT_LT(difference<Judge>(c, h, 2), 60) << c.name << ", h = " << h;
}

TEST(DmvMatrix, IsTheQuaternionFormTo75DigitsForRandomBodies) {
  Uniform uniform(3);
  for (int i = 0; i < 20; ++i) {
    auto const c = random_body(uniform, i);
    EXPECT_LT(difference<Judge>(c, uniform(-0.2, 0.2) * c.inertia[0], 1), 60) << "body " << i;
  }
}

TEST(DmvMatrix, IsTheQuaternionFormToRoundingInEveryArithmetic) {
  for (auto const& c : all_bodies()) {
    EXPECT_LT(difference<float>(c, 0.125, 1), 20) << c.name;
    EXPECT_LT(difference<double>(c, 0.125, 1), 20) << c.name;
    EXPECT_LT(difference<long double>(c, 0.125, 1), 20) << c.name;
    EXPECT_LT(difference<DoubleDouble<double>>(c, 0.125, 1), 60) << c.name;
    EXPECT_LT(difference<Float128>(c, 0.125, 1), 20) << c.name;
  }
}

TEST(DmvMatrix, IsTheQuaternionFormToRoundingForRandomBodiesOrBothHaveNoNumbers) {
  Uniform uniform(4);
  int numbers = 0, neither = 0, matrix_alone = 0, quaternion_alone = 0;
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    auto const c = random_body(uniform, i);
    double const h = uniform(-1.5, 1.5) * c.inertia[0];
    double const apart = difference<double>(c, h, 1);
    bool const of_matrix = is_number(advanced<DmvMatrix<double>>(c, h, 1).momentum[0]);
    bool const of_quaternion = is_number(advanced<Dmv2<double>>(c, h, 1).momentum[0]);
    numbers += of_matrix && of_quaternion;
    neither += !of_matrix && !of_quaternion;
    matrix_alone += of_matrix && !of_quaternion;  // the iteration is slow close to a right angle
    quaternion_alone += !of_matrix && of_quaternion;
    if (of_matrix && of_quaternion) worst = std::max(worst, apart);
  }
  RecordProperty("worst", std::to_string(worst));
  RecordProperty("numbers", numbers);
  RecordProperty("neither", neither);
  RecordProperty("matrix_alone", matrix_alone);
  RecordProperty("quaternion_alone", quaternion_alone);
  EXPECT_LT(worst, 400);
  EXPECT_GT(numbers, 1500);
  EXPECT_GT(neither, 100);
  EXPECT_LT(matrix_alone, 5);
  EXPECT_EQ(quaternion_alone, 0);
}

TEST(DmvMatrix, SolvesItsEquation) {
  // ωᵀD − Dω = h ŷ, from the attitude that it gives: off the diagonal, with D's elements added in pairs to I
  for (auto const& c : all_bodies()) {
    auto const before = c.start<Judge>(), after = advanced<DmvMatrix<Judge>>(c, 0.125, 1);
    auto const turn = hamilton_product(conjugate(before.attitude), after.attitude);
    Vector3<Judge> const I = c.body<Judge>().inertia();
    Eigen::Matrix<Judge, 3, 3> X;
    for (int j = 0; j < 3; ++j) X.col(j) = rotated<Judge>(turn, Vector3<Judge>::Unit(j));
    for (int j = 0; j < 3; ++j) {
      int const k = (j + 1) % 3, l = (j + 2) % 3;
      Judge const d_k = (I[l] + I[j] - I[k]) / 2, d_l = (I[j] + I[k] - I[l]) / 2;
      Judge const left = X(l, k) * d_k - d_l * X(k, l);  // component (l, k) of hat(y) is y_j
      EXPECT_LT(abs(Judge(left - before.momentum[j] / 8)), Judge("1e-73")) << c.name << ' ' << j;
    }
  }
}

TEST(DmvMatrix, OfABallHasASolutionUpToARightAngle) {
  // sin φ = h|y|/I
  BodyCase const c{"ball", {0.5, 0.5, 0.5}, {0, 0, 1}, {1, 0, 0, 0}};
  for (double sine : {0.1, 0.9, 0.999, -0.999}) {
    auto const after = advanced<DmvMatrix<double>>(c, sine / 2, 1);
    EXPECT_NEAR(after.attitude.z(), std::sin(std::asin(sine) / 2), 1e-13) << sine;
  }
  for (double sine : {1.001, -1.2, 10.0, 1e10, 1e200, double{INFINITY}, double{NAN}}) {
    auto const after = advanced<DmvMatrix<double>>(c, sine / 2, 1);
    for_components([&](double v) { EXPECT_TRUE(std::isnan(v)) << sine; }, after);
  }
}

TEST(DmvMatrix, WithoutAttitudeMakesTheSameMomentum) {
  auto const c = generic_bodies()[0];
  auto without = c.start<double>();
  advance(DmvMatrix<double>({c.body<double>(), 0.1, without, false}), without, 10);
  EXPECT_EQ(without.momentum, advanced<DmvMatrix<double>>(c, 0.1, 10).momentum);
  EXPECT_EQ(without.attitude.coeffs(), c.start<double>().attitude.coeffs());
}

}  // namespace
}  // namespace brouwer
