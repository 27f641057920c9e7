// Splitting of the rigid body into three rotations keeps what its publications say, at 77 digits, for every composition.
#include <brouwer/integrators/rigid_body_splitting.hpp>
#include <brouwer/scalar/double_double.hpp>
#include <brouwer/systems/rigid_body_flow.hpp>

#include <gtest/gtest.h>

#include "tests/bodies.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::BodyCase;
using testing_support::generic_bodies;
using testing_support::Judge;
using testing_support::special_bodies;

struct ASplitting : testing::TestWithParam<Composition> {
  template <class T>
  static RigidBodySplitting<T> step(BodyCase const& c, T const& h) {
    return {{c.body<T>(), h, c.start<T>()}, GetParam()};
  }

  struct Errors {
    double momentum, attitude;
  };
  /// At t with n steps.
  static Errors errors(BodyCase const& c, Judge const& t, int n) {
    auto y = c.start<Judge>();
    advance(step(c, Judge(t / n)), y, n);
    auto const body = c.body<Judge>();
    auto const e = body.state_errors(y, RigidBodyFlow<Judge>(body, c.start<Judge>())(t));
    auto const length = [&](std::size_t i) {
      return static_cast<double>(Judge(sqrt(Judge(squared(e[i]) + squared(e[i + 1]) + squared(e[i + 2])))));
    };
    return {length(0), length(3)};
  }
};
INSTANTIATE_TEST_SUITE_P(By, ASplitting, testing::ValuesIn(compositions), [](auto const& one) {
  std::string name(one.param.name);
  std::erase(name, '-');
  return name;
});

TEST_P(ASplitting, ConvergesAtItsStatedOrderInMomentumAndAttitude) {
  for (auto const& c : {generic_bodies()[0], generic_bodies()[1], special_bodies()[3]}) {
    auto const coarse = errors(c, Judge("0.5"), 20), fine = errors(c, Judge("0.5"), 40);
    EXPECT_NEAR(std::log2(coarse.momentum / fine.momentum), GetParam().order, 0.1) << c.name;
    EXPECT_NEAR(std::log2(coarse.attitude / fine.attitude), GetParam().order, 0.1) << c.name;
  }
}

TEST_P(ASplitting, ConservesAllButTheEnergyTo72DigitsOnEveryBody) {
  auto cases = generic_bodies();
  for (auto const& c : special_bodies()) cases.push_back(c);
  for (auto const& c : cases) {
    auto const body = c.body<Judge>();
    auto y = c.start<Judge>();
    auto const before = body.first_integrals(y);
    advance(step(c, Judge("0.1")), y, 3);
    auto const after = body.first_integrals(y);
    for (std::size_t i = 1; i < before.size(); ++i)
      EXPECT_LT(abs(Judge(after[i] - before[i])), Judge("1e-72")) << c.name << ' ' << i;
  }
}

TEST_P(ASplitting, ConservesTheCasimirToRoundingInDouble) {
  for (auto const& c : generic_bodies()) {
    Compensated<RigidBodyState<double>> y(c.start<double>());
    advance(step(c, 0.05), y, 1000);
    auto const casimir = [&](RigidBodyState<double> const& s) {
      return c.body<Float128>().casimir({s.momentum[0], s.momentum[1], s.momentum[2]});
    };
    Float128 const before = casimir(c.start<double>());
    EXPECT_LT(static_cast<double>(Float128(abs(Float128(casimir(y.value) / before - 1)))), 1e-14) << c.name;
  }
}

TEST_P(ASplitting, RetracesItsStepsWhenTimeIsReversed) {
  for (auto const& c : {generic_bodies()[2], generic_bodies()[3]}) {
    auto y = c.start<Judge>();
    advance(step(c, Judge("0.1")), y, 2);
    advance(step(c, Judge("-0.1")), y, 2);
    auto const start = c.start<Judge>();
    for_components([&](Judge const& a, Judge const& b) { EXPECT_LT(abs(Judge(a - b)), Judge("1e-72")) << c.name; }, y,
                   start);
  }
}

template <class T>
RigidBodyState<Judge> widened(RigidBodyState<T> const& s) {
  RigidBodyState<Judge> wide;
  for_components([](Judge& w, T const& v) { w = Judge(v); }, wide, s);
  return wide;
}

/// The largest error of a component after one step over 1/8, in ε, against the same numbers at 77 digits.
template <class T>
double ulps_of_a_step(BodyCase const& c, Composition const& composition) {
  auto y = c.start<T>();
  auto exact = widened(y);
  advance(RigidBodySplitting<T>({c.body<T>(), T(0.125), y}, composition), y, 1);
  auto const body = c.body<T>().template in<Judge>();
  advance(RigidBodySplitting<Judge>({body, Judge("0.125"), exact}, composition), exact, 1);
  double worst = 0;
  auto const reached = widened(y);
  for_components(
      [&](Judge const& a, Judge const& b) { worst = std::max(worst, static_cast<double>(Judge(abs(a - b)))); }, reached,
      exact);
  return worst / static_cast<double>(epsilon<T>());
}

TEST_P(ASplitting, ErrsByLittleInEveryArithmetic) {
  for (auto const& c : generic_bodies()) {
    EXPECT_LT(ulps_of_a_step<float>(c, GetParam()), 4) << c.name;
    EXPECT_LT(ulps_of_a_step<double>(c, GetParam()), 4) << c.name;
    EXPECT_LT(ulps_of_a_step<long double>(c, GetParam()), 4) << c.name;
    EXPECT_LT(ulps_of_a_step<DoubleDouble<double>>(c, GetParam()), 12) << c.name;
    EXPECT_LT(ulps_of_a_step<Float128>(c, GetParam()), 4) << c.name;
    EXPECT_LT(ulps_of_a_step<Mpfr<128>>(c, GetParam()), 4) << c.name;
  }
}

TEST_P(ASplitting, LeavesTheAttitudeAloneWhenNothingAsksForIt) {
  auto const c = generic_bodies()[0];
  auto with = c.start<double>(), without = with;
  advance(step(c, 0.1), with, 10);
  advance(RigidBodySplitting<double>({c.body<double>(), 0.1, without, false}, GetParam()), without, 10);
  EXPECT_EQ(with.momentum, without.momentum);
  EXPECT_EQ(without.attitude.coeffs(), c.start<double>().attitude.coeffs());
  EXPECT_NE(with.attitude.coeffs(), without.attitude.coeffs());
}

/// y by 3×3 matrices, one after another: nothing merged, nothing taken apart.
Vector3<Judge> by_matrices(RigidBody<Judge> const& body, Vector3<Judge> y, Judge const& h) {
  for (auto const& [axis, part] : {std::pair{0, 2}, {1, 2}, {2, 1}, {1, 2}, {0, 2}}) {
    int const j = (axis + 1) % 3, k = (axis + 2) % 3;
    Judge const angle = h / part * y[axis] / body.inertia()[axis], y_j = y[j], y_k = y[k];
    y[j] = cos(angle) * y_j + sin(angle) * y_k;
    y[k] = cos(angle) * y_k - sin(angle) * y_j;
  }
  return y;
}

TEST_P(ASplitting, IsFiveRotationsAStageOneAfterAnother) {
  auto const c = generic_bodies()[1];
  Judge const h("0.3");
  auto y = c.start<Judge>();
  advance(step(c, h), y, 1);
  auto expected = c.start<Judge>().momentum;
  for (auto const& weight : composition_weights<Judge>(GetParam()))
    expected = by_matrices(c.body<Judge>(), expected, Judge(weight * h));
  for (int j = 0; j < 3; ++j) EXPECT_LT(abs(Judge(y.momentum[j] - expected[j])), Judge("1e-74")) << j;
}

TEST(RigidBodySplitting, TurnsByMoreThanHalfARevolutionAtOnce) {
  // about axis 1 alone it is the flow, however large the step
  BodyCase const c{"on axis 1", {0.6, 0.8, 1.0}, {1.5, 0, 0}, {0.5, 0.5, -0.5, 0.5}};
  for (double h : {0.7, 1.5, 2.2, 3.1, -2.0, 6.0}) {
    auto y = c.start<double>();
    advance(RigidBodySplitting<double>({c.body<double>(), h, y}, base_method), y, 1);
    auto const exact = RigidBodyFlow<double>(c.body<double>(), c.start<double>())(h);
    for_components([&](double a, double b) { EXPECT_NEAR(a, b, 4e-15) << h; }, y, exact);
  }
}

}  // namespace
}  // namespace brouwer
