// How the equation of a step is solved: in how many turns, how closely, and what happens where it cannot be.
#include <brouwer/integrators/dmv.hpp>

#include <gtest/gtest.h>

#include "tests/bodies.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::BodyCase;
using testing_support::generic_bodies;
using testing_support::special_bodies;
using testing_support::Uniform;

template <class S>
typename S::Equation solved(S const& step, typename S::State const& y) {
  auto e = step.begin(y);
  for (int i = 0; i < step.blind_turns(); ++i) step.turn(y, e);
  step.settle(y, e, step.blind_turns());
  return e;
}

template <class T, int order>
int turns(double h) {
  auto const c = generic_bodies()[0];
  return Dmv<T, order, PerTrajectory>({c.body<T>(), T(h), c.start<T>()}).blind_turns() + 1;
}

TEST(DmvIteration, TakesAsManyTurnsAsTheArithmeticHasDigits) {
  EXPECT_EQ((std::array{turns<float, 10>(0.01), turns<double, 10>(0.01), turns<Float128, 10>(0.01)}),
            (std::array{2, 3, 6}));
  EXPECT_EQ((std::array{turns<float, 10>(0.1), turns<double, 10>(0.1), turns<Float128, 10>(0.1)}),
            (std::array{3, 7, 13}));
  EXPECT_EQ((std::array{turns<float, 10>(0.4), turns<double, 10>(0.4), turns<Float128, 10>(0.4)}),
            (std::array{36, 63, 120}));
}

/// By how much m and α (times |y|) miss the equation of the rounded constants, in ε|y|.
template <class T, int order>
double residual(RigidBody<T> const& body, T const& h, RigidBodyState<T> const& s) {
  using E = Wider<T>;
  auto const e = solved(Dmv<T, order, PerStep>({body, h, s}), s);
  DmvConstants<T> const k(DmvModifiedInertia<T, order>(body, h)(s.momentum));
  E const alpha = T(1) + k.length2(e.m) * squared(e.alpha),  // as the update takes it
      length = sqrt(squared_norm(Vector3<E>{E(s.momentum[0]), E(s.momentum[1]), E(s.momentum[2])}));
  E rotation2 = 0, worst = 0;
  for (int i = 0; i < 3; ++i) {
    int const j = (i + 1) % 3, l = (i + 2) % 3;
    E const line = E(s.momentum[i]) + alpha * E(k.lambda[i]) * E(e.m[j]) * E(e.m[l]);
    worst = larger(worst, E(abs(E(line - E(e.m[i])))));
    rotation2 += squared(E(alpha * E(k.eta[i]) * E(e.m[i])));
  }
  worst = larger(worst, E(length * abs(E(1 + rotation2 - alpha))));
  return worst == worst ? static_cast<double>(E(worst / length)) / static_cast<double>(epsilon<T>())
                        : std::numeric_limits<double>::infinity();
}

/// Rotations of up to 60 degrees a step. DMV of order 2 turns by arcsin(h|ω|) where the flow turns by h|ω|.
template <class T, int order>
double worst_residual() {
  Uniform uniform(7);
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    double const I1 = uniform(0.2, 2), I2 = uniform(I1, 2 * I1), I3 = uniform(I2, I1 + I2);
    BodyCase const c{"random",
                     {I1, I2, I3},
                     {uniform(-2, 2), uniform(-2, 2), uniform(-2, 2)},
                     {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}};
    auto const body = c.body<T>();
    double const speed = std::sqrt(static_cast<double>(squared_norm(body.angular_velocity(c.start<T>().momentum))));
    double const h = uniform(0, order == 2 ? 0.86 : 1.04) / speed;
    worst = std::max(worst, residual<T, order>(body, T(h), c.start<T>()));
  }
  return worst;
}

TEST(DmvIteration, SettlesToRoundingForRandomBodiesAndSteps) {
  EXPECT_LT((worst_residual<double, 2>()), 4);
  EXPECT_LT((worst_residual<double, 10>()), 4);
  EXPECT_LT((worst_residual<float, 2>()), 4);
  EXPECT_LT((worst_residual<float, 10>()), 4);
}

TEST(DmvIteration, KeepsSettledFarFromItsStart) {  // the turns are counted at the start
  for (auto const& c : generic_bodies()) {
    auto y = c.start<double>();
    Dmv<double, 10, PerTrajectory> const step({c.body<double>(), 0.1, y});
    for (int i = 0; i < 2000; ++i, take_step(step, y)) {
      auto e = solved(step, y);
      auto const before = e;
      for (int j = 0; j < 8; ++j) step.turn(y, e);
      for (int j = 0; j < 3; ++j)
        ASSERT_LE(std::abs(e.m[j] - before.m[j]), 2 * epsilon<double>() * y.momentum.norm()) << c.name;
      ASSERT_LE(std::abs(e.alpha - before.alpha), 4 * epsilon<double>()) << c.name;
    }
  }
}

TEST(DmvIteration, SettlesAtOnceWhereNothingMoves) {
  for (auto const& c : special_bodies())
    if (c.momentum == std::array<double, 3>{0, 0, 0}) {
      Dmv<double, 10, PerStep> const step({c.body<double>(), 0.1, c.start<double>()});
      EXPECT_EQ(step.blind_turns(), 0);
      auto y = c.start<double>();
      advance(step, y, 10);
      EXPECT_EQ(y.momentum, c.start<double>().momentum);
      EXPECT_EQ(y.attitude.coeffs(), c.start<double>().attitude.coeffs());
    }
}

template <class T, int order, class Coefficients>
void expect_special_bodies_to_be_conserved() {
  for (auto const& c : special_bodies())
    for (double h : {0.01, 0.2}) {
      auto y = c.start<T>();
      auto const body = c.body<T>();
      auto const before = body.first_integrals(y);
      Dmv<T, order, Coefficients> const step({body, T(h), y});
      EXPECT_LT(step.blind_turns(), 40) << c.name;
      advance(step, y, 50);
      auto const after = body.first_integrals(y);
      for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_LT(static_cast<double>(abs(after[i] - before[i])), 100 * static_cast<double>(epsilon<T>()))
            << c.name << ", h = " << h << ", " << i;
    }
}

TEST(DmvIteration, SurvivesEverySpecialCase) {
  expect_special_bodies_to_be_conserved<double, 2, PerTrajectory>();
  expect_special_bodies_to_be_conserved<double, 10, PerStep>();
  expect_special_bodies_to_be_conserved<double, 10, PerTrajectory>();
  expect_special_bodies_to_be_conserved<float, 10, PerStep>();
}

TEST(DmvIteration, FailsWithNaNWhereTheStepIsTooLarge) {
  auto cases = generic_bodies();
  for (auto const& c : special_bodies()) cases.push_back(c);
  for (auto const& c : cases) {
    auto const start = c.start<double>();
    if (start.momentum.norm() == 0) continue;
    double const fast = start.momentum.norm() / c.inertia[0];
    for (double turn : {6.0, 20.0, 1e3, 1e100, 1e300}) {  // radians a step, of which DMV can make less than π/2
      auto const increment = Dmv2<double>({c.body<double>(), turn / fast, start}).increment(start);
      for_components([&](double d) { EXPECT_TRUE(std::isnan(d)) << c.name << ", " << turn << " radians"; }, increment);
    }
  }
}

TEST(DmvIteration, NeverTakesMoreThanTheLimitOfTurns) {
  for (auto const& c : generic_bodies())
    for (double h = 0.01; h < 1e4; h *= 1.1) {
      Dmv<double, 10, PerTrajectory> const step({c.body<double>(), h, c.start<double>()});
      EXPECT_LT(step.blind_turns(), DmvTurns<double>::limit) << c.name << ", h = " << h;
    }
}

}  // namespace
}  // namespace brouwer
