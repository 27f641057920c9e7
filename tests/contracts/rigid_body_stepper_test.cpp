// Promises that every stepper of the rigid body keeps.
#include <brouwer/systems/rigid_body_flow.hpp>

#include <gtest/gtest.h>

#include "tests/bodies.hpp"
#include "tests/contracts/steppers.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::BodyCase;
using testing_support::generic_bodies;
using testing_support::Judge;
using testing_support::special_bodies;

template <class S>
typename S::State advanced(BodyCase const& c, typename S::Scalar const& h, int steps) {
  using T = typename S::Scalar;
  auto y = c.start<T>();
  advance(S(Setup<RigidBody<T>>{c.body<T>(), h, y}), y, steps);
  return y;
}

/// The largest error of a component against the exact flow from the same numbers.
template <class T>
double error_of(BodyCase const& c, RigidBodyState<T> const& y, T const& h, int steps) {
  using E = std::conditional_t<(significand_bits<T> > 128), Mpfr<512>, Judge>;
  auto const widened = [](RigidBodyState<T> const& s) {
    RigidBodyState<E> wide;
    for_components([](E& w, T const& v) { w = E(v); }, wide, s);
    return wide;
  };
  auto const exact = RigidBodyFlow<E>(c.body<T>().template in<E>(), widened(c.start<T>()))(E(E(h) * steps));
  auto const reached = widened(y);
  E worst = 0;
  for_components([&](E const& a, E const& b) { worst = larger(worst, E(abs(E(a - b)))); }, reached, exact);
  return static_cast<double>(worst);
}

double size_of(BodyCase const& c) { return std::max(1.0, std::hypot(c.momentum[0], c.momentum[1], c.momentum[2])); }

template <class Family>
struct ExactRigidBodyStepper : testing::Test {};
TYPED_TEST_SUITE(ExactRigidBodyStepper, testing_support::ExactRigidBodySteppers);

TYPED_TEST(ExactRigidBodyStepper, IsTheFlowTo70DigitsInMomentumAndAttitudeForEveryStepSize) {
  using S = typename TypeParam::template In<Judge>;
  for (auto const& c : generic_bodies())
    for (char const* h : {"0.01", "0.7", "-0.3", "12"})
      EXPECT_LT(error_of(c, advanced<S>(c, Judge(h), 3), Judge(h), 3), 1e-70 * size_of(c)) << c.name << ", h = " << h;
}

TYPED_TEST(ExactRigidBodyStepper, IsTheFlowToRoundingInEveryArithmetic) {
  auto const check = [](auto zero, double ulps) {
    using T = decltype(zero);
    for (auto const& c : generic_bodies()) {
      double const error = error_of(c, advanced<typename TypeParam::template In<T>>(c, T(0.1), 10), T(0.1), 10);
      EXPECT_LT(error, ulps * static_cast<double>(epsilon<T>()) * size_of(c)) << c.name;
    }
  };
  check(0.0F, 60);
  check(0.0, 60);
  check(0.0L, 60);
  check(Float128(0), 60);
}

TYPED_TEST(ExactRigidBodyStepper, SurvivesEverySpecialCase) {
  // naive differences of H and C have no digits left where a₁ or a₂ vanishes: √ε of the momentum
  bool const naive = std::is_same_v<TypeParam, testing_support::Family<testing_support::Naive>>;
  for (auto const& c : special_bodies())
    for (double h : {0.01, 1.0}) {
      auto const y = advanced<typename TypeParam::template In<double>>(c, h, 20);
      for_components([&](double v) { EXPECT_TRUE(std::isfinite(v)) << c.name; }, y);
      EXPECT_LT(error_of(c, y, h, 20), naive ? 1e-6 : 2e-12) << c.name << ", h = " << h;
    }
}

template <class Family>
struct RigidBodyStepper : testing::Test {};
TYPED_TEST_SUITE(RigidBodyStepper, testing_support::RigidBodySteppers);

TYPED_TEST(RigidBodyStepper, ConservesTheFirstIntegralsToRounding) {
  using S = typename TypeParam::template In<double>;
  for (auto const& c : generic_bodies()) {
    auto const body = c.body<Float128>();
    auto const integrals = [&](RigidBodyState<double> const& y) {
      RigidBodyState<Float128> wide;
      for_components([](Float128& w, double v) { w = v; }, wide, y);
      return body.first_integrals(wide);
    };
    auto const before = integrals(c.start<double>()), after = integrals(advanced<S>(c, 0.05, 400));
    for (std::size_t i = testing_support::conserves_energy<TypeParam> ? 0 : 1; i < before.size(); ++i)
      EXPECT_LT(static_cast<double>(abs(after[i] - before[i])), 2e-13 * size_of(c) * size_of(c)) << c.name << ' ' << i;
  }
}

TYPED_TEST(RigidBodyStepper, RetracesItsStepsWhenTimeIsReversed) {
  using S = typename TypeParam::template In<Judge>;
  for (auto const& c : generic_bodies()) {
    auto y = c.start<Judge>();
    advance(S({c.body<Judge>(), Judge("0.05"), y}), y, 10);
    advance(S({c.body<Judge>(), Judge("-0.05"), y}), y, 10);
    auto const start = c.start<Judge>();
    for_components([&](Judge const& a, Judge const& b) { EXPECT_LT(abs(Judge(a - b)), Judge("1e-72")) << c.name; }, y,
                   start);
  }
}

TYPED_TEST(RigidBodyStepper, LeavesTheAttitudeAloneWhenNothingAsksForIt) {
  using S = typename TypeParam::template In<double>;
  auto const c = generic_bodies()[0];
  auto with = c.start<double>(), without = with;
  advance(S({c.body<double>(), 0.01, with, true}), with, 100);
  advance(S({c.body<double>(), 0.01, without, false}), without, 100);
  EXPECT_EQ(with.momentum, without.momentum) << "the momentum must not depend on who looks at the attitude";
  EXPECT_EQ(without.attitude.coeffs(), c.start<double>().attitude.coeffs());
  EXPECT_NE(with.attitude.coeffs(), without.attitude.coeffs());
}

TYPED_TEST(RigidBodyStepper, IsAValue) {
  using S = typename TypeParam::template In<double>;
  auto const c = generic_bodies()[1];
  auto a = c.start<double>(), b = a;
  S const original({c.body<double>(), 0.01, a});
  S const copy = original;
  advance(original, a, 50);
  advance(original, b, 20);
  advance(copy, b, 30);
  EXPECT_EQ(a.momentum, b.momentum);
  EXPECT_EQ(a.attitude.coeffs(), b.attitude.coeffs());
}

}  // namespace
}  // namespace brouwer
