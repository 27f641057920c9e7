// The discrete Moser–Veselov algorithm keeps what its publication says.
#include <brouwer/integrators/dmv.hpp>
#include <brouwer/systems/rigid_body_flow.hpp>

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/bodies.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::BodyCase;
using testing_support::generic_bodies;
using testing_support::Judge;

/// Errors of momentum and attitude at t = 1 with n steps, at 77 digits.
std::pair<double, double> errors_with(BodyCase const& c, int n) {
  Judge const h = Judge(1) / n;
  auto const body = c.body<Judge>();
  auto y = c.start<Judge>();
  advance(Dmv2<Judge>({body, h, y}), y, n);
  auto const e = body.state_errors(y, RigidBodyFlow<Judge>(body, c.start<Judge>())(Judge(1)));
  auto const length = [&](std::size_t i) {
    return static_cast<double>(Judge(sqrt(Judge(squared(e[i]) + squared(e[i + 1]) + squared(e[i + 2])))));
  };
  return {length(0), length(3)};
}

TEST(Dmv2, ConvergesAtOrderTwoInMomentumAndAttitude) {
  for (auto const& c : generic_bodies()) {
    auto const coarse = errors_with(c, 100), fine = errors_with(c, 200);
    EXPECT_NEAR(std::log2(coarse.first / fine.first), Dmv2<Judge>::order, 0.01) << c.name;
    EXPECT_NEAR(std::log2(coarse.second / fine.second), Dmv2<Judge>::order, 0.01) << c.name;
  }
}

TEST(Dmv2, ConservesEverythingTo70Digits) {
  for (auto const& c : generic_bodies()) {
    auto const body = c.body<Judge>();
    auto y = c.start<Judge>();
    auto const before = body.first_integrals(y);
    advance(Dmv2<Judge>({body, Judge("0.1"), y}), y, 50);
    auto const after = body.first_integrals(y);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_LT(abs(Judge(after[i] - before[i])), Judge("1e-72")) << i;
  }
}

TEST(Dmv2, SolvesTheMatrixEquationOfMoserAndVeselov) {
  // ωᵀD − Dω = h ŷ with ω orthogonal, ŷ' = ω ŷ ωᵀ, Q' = Qωᵀ; D from d₁+d₂ = I₃ and cyclic
  using Matrix = Eigen::Matrix<Judge, 3, 3>;
  auto const c = generic_bodies()[0];
  auto const body = c.body<Judge>();
  auto const& I = body.inertia();
  Judge const h("0.1");
  auto const before = c.start<Judge>();
  auto after = before;
  advance(Dmv2<Judge>({body, h, before}), after, 1);

  auto const columns = [](Quaternion<Judge> const& q) {
    Matrix m;
    for (int j = 0; j < 3; ++j) {
      Vector3<Judge> axis{0, 0, 0};
      axis[j] = 1;
      m.col(j) = rotated(q, axis);
    }
    return m;
  };
  auto const hat = [](Vector3<Judge> const& a) {
    Matrix m;
    m << Judge(0), Judge(-a[2]), a[1], a[2], Judge(0), Judge(-a[0]), Judge(-a[1]), a[0], Judge(0);
    return m;
  };
  Matrix const omega_transposed = columns(before.attitude).transpose() * columns(after.attitude);
  Matrix const omega = omega_transposed.transpose();
  Vector3<Judge> const d{(I[1] + I[2] - I[0]) / 2, (I[0] + I[2] - I[1]) / 2, (I[0] + I[1] - I[2]) / 2};
  Matrix const D = d.asDiagonal();
  EXPECT_LT((omega_transposed * D - D * omega - h * hat(before.momentum)).norm(), Judge("1e-74"));
  EXPECT_LT((omega * hat(before.momentum) * omega_transposed - hat(after.momentum)).norm(), Judge("1e-74"));
}

TEST(Dmv2, SettlesInAFewIterations) {
  auto const c = generic_bodies()[0];
  auto const y = c.start<double>();
  EXPECT_LE(Dmv2<double>({c.body<double>(), 0.01, y}).iterations(y.momentum), 7);
  EXPECT_LE(Dmv2<double>({c.body<double>(), 0.1, y}).iterations(y.momentum), 13);
}

TEST(Dmv2, FailsWithNaNWhereTheStepIsTooLarge) {
  auto const c = generic_bodies()[0];
  auto y = c.start<double>();
  advance(Dmv2<double>({c.body<double>(), 50.0, y}), y, 3);
  EXPECT_TRUE(std::isnan(y.momentum[0]));
}

}  // namespace
}  // namespace brouwer
