// Kepler's problem: first integrals of known orbits, collisions, and the exact flow against solutions in closed form.
#include <brouwer/systems/kepler_flow.hpp>

#include <gtest/gtest.h>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Judge;
using State = PhaseState<Judge, 2>;

Kepler<Judge> const system(Judge(0));

Judge distance(State const& a, State const& b) {
  Judge worst = 0;
  for_components([&worst](Judge const& x, Judge const& y) { worst = larger(worst, Judge(abs(Judge(x - y)))); }, a, b);
  return worst;
}

/// The root of an increasing function by bisection: slow, and nothing like what is tested.
template <class F>
Judge root(F f, Judge low, Judge high) {
  for (int i = 0; i < 290; ++i) (f(Judge((low + high) / 2)) > 0 ? high : low) = (low + high) / 2;
  return low;
}

/// Pericentre on the first axis, semi-major axis ±1: q = (1 − e, 0), p = (0, √((1+e)/(1−e))) and its like for e > 1.
State pericentre(Judge const& e) {
  Judge const near = abs(Judge(1 - e));
  return {{near, Judge(0)}, {Judge(0), sqrt(Judge((1 + e) / near))}};
}

/// (cos E − e, √(1−e²) sin E) with E − e sin E = t
State on_ellipse(Judge const& e, Judge const& t) {
  Judge const E = root([&](Judge const& x) { return Judge(x - e * sin(x) - t); }, t - 1, t + 1);
  Judge const b = sqrt(Judge(1 - e * e)), E_rate = 1 / (1 - e * cos(E));
  return {{cos(E) - e, b * sin(E)}, {-sin(E) * E_rate, b * cos(E) * E_rate}};
}

/// (e − cosh F, √(e²−1) sinh F) with e sinh F − F = t
State on_hyperbola(Judge const& e, Judge const& t) {
  Judge const F = root([&](Judge const& x) { return Judge(e * sinh(x) - x - t); }, Judge(-30), Judge(30));
  Judge const b = sqrt(Judge(e * e - 1)), F_rate = 1 / (e * cosh(F) - 1);
  return {{e - cosh(F), b * sinh(F)}, {-sinh(F) * F_rate, b * cosh(F) * F_rate}};
}

TEST(KeplerFlow, IsTheEllipseTo60DigitsForEveryEccentricityAndOverThousandsOfPeriods) {
  for (char const* e : {"0", "1e-30", "0.1", "0.6", "0.99", "0.999999"})
    for (char const* t : {"1e-20", "0.3", "3.1415", "-2.5", "6.25", "-40", "31415.9"}) {
      Judge const nearness = 1 - Judge(e);  // a body at the pericentre is as fast as 1/√(1 − e), and faster to turn
      auto const reached = KeplerFlow<Judge>(system, pericentre(Judge(e)))(Judge(t));
      EXPECT_LT(Judge(distance(reached, on_ellipse(Judge(e), Judge(t))) * nearness * nearness), Judge("1e-68"))
          << "e = " << e << ", t = " << t;
    }
}

TEST(KeplerFlow, IsTheHyperbolaTo60Digits) {
  for (char const* e : {"1.000001", "1.5", "40"})
    for (char const* t : {"1e-20", "0.3", "-3", "1000", "-1e7"}) {
      auto const reached = KeplerFlow<Judge>(system, pericentre(Judge(e)))(Judge(t));
      EXPECT_LT(distance(reached, on_hyperbola(Judge(e), Judge(t))), Judge("1e-60")) << "e = " << e << ", t = " << t;
    }
}

TEST(KeplerFlow, IsTheParabola) {
  // from the pericentre 1/2 with |p|² = 2/r: q = (½(1 − τ²), τ), t = ½(τ + τ³/3), r = ½(1 + τ²)
  for (char const* tau : {"1e-15", "0.5", "-3", "100"}) {
    Judge const x(tau), r = (1 + x * x) / 2;
    State const expected{{(1 - x * x) / 2, x}, {-x / r, 1 / r}};
    auto const reached =
        KeplerFlow<Judge>(system, {{Judge(1) / 2, Judge(0)}, {Judge(0), Judge(2)}})((x + x * x * x / 3) / 2);
    EXPECT_LT(distance(reached, expected), Judge("1e-66")) << tau;
  }
}

struct KeplerOrbit : testing::TestWithParam<std::array<char const*, 4>> {
  State const start{{Judge(GetParam()[0]), Judge(GetParam()[1])}, {Judge(GetParam()[2]), Judge(GetParam()[3])}};
  KeplerFlow<Judge> const flow{system, start};
};
INSTANTIATE_TEST_SUITE_P(FromAnywhere, KeplerOrbit,
                         testing::Values(std::array{"0.4", "0", "0", "2"}, std::array{"0.7", "-1.2", "0.3", "0.8"},
                                         std::array{"-2", "1", "-0.1", "-0.9"}, std::array{"1", "0.5", "-0.05", "0.01"},
                                         std::array{"0.3", "0.4", "-2", "1.5"}),
                         [](auto const& one) { return "Orbit" + std::to_string(one.index); });

TEST_P(KeplerOrbit, SatisfiesTheEquationsOfMotion) {
  Judge const h("1e-25");
  for (char const* at : {"0", "0.7", "-3.3", "20"}) {
    auto const before = flow(Judge(Judge(at) - h)), after = flow(Judge(Judge(at) + h));
    auto const rate = system.rate(flow(Judge(at)));
    for_components([&](Judge const& a, Judge const& b,
                       Judge const& r) { EXPECT_LT(abs(Judge((a - b) / (2 * h) - r)), Judge("1e-42") * (1 + abs(r))); },
                   after, before, rate);
  }
}

TEST_P(KeplerOrbit, IsAGroup) {
  Judge const s("7.25"), t("-18.5");
  auto const direct = flow(Judge(s + t));
  EXPECT_LT(distance(KeplerFlow<Judge>(system, flow(s))(t), direct), Judge("1e-68"));
  EXPECT_LT(distance(KeplerFlow<Judge>(system, direct)(Judge(-s - t)), start), Judge("1e-68"));
}

TEST_P(KeplerOrbit, ConservesTheFirstIntegrals) {
  auto const at_start = system.first_integrals(start), later = system.first_integrals(flow(Judge("1234.5")));
  for (std::size_t i = 0; i < at_start.size(); ++i) EXPECT_LT(abs(Judge(later[i] - at_start[i])), Judge("1e-65")) << i;
}

TEST(KeplerFlow, ComesBackFromACollisionTheWayItWentIn) {
  // released at rest at r = 2, of period 2π; it falls for π, and is at rest again at 2π
  KeplerFlow<Judge> const flow(system, {{Judge(2), Judge(0)}, {Judge(0), Judge(0)}});
  auto const period = 2 * pi<Judge>();
  for (char const* t : {"0.5", "3", "3.14"})
    EXPECT_LT(abs(Judge(flow(Judge(t)).q[0] - flow(Judge(period - Judge(t))).q[0])), Judge("1e-66"));
  EXPECT_LT(abs(Judge(flow(period).q[0] - 2)), Judge("1e-70"));
}

TEST(KeplerFlow, InFloat128IsRightForDoubleAfterThousandsOfPeriods) {
  using W = Float128;
  KeplerFlow<W> const flow(Kepler<W>(W(0)), {{W(0.4), W(0)}, {W(0), W(2)}});
  KeplerFlow<Judge> const exact(system, {{Judge(0.4), Judge(0)}, {Judge(0), Judge(2)}});
  auto const reached = flow(W(12345.678));
  auto const expected = exact(Judge(12345.678));
  EXPECT_LT(abs(Judge(Judge(reached.q[0]) - expected.q[0])), Judge("2e-29"));
  EXPECT_LT(abs(Judge(Judge(reached.p[1]) - expected.p[1])), Judge("2e-29"));
}

TEST(Kepler, KnowsTheOrbitOfTheStandardStart) {
  auto const e = Judge("0.6");
  auto const integrals = system.first_integrals(pericentre(e));
  EXPECT_LT(abs(Judge(integrals[0] + Judge("0.5"))), Judge("1e-75"));
  EXPECT_LT(abs(Judge(integrals[1] - Judge("0.8"))), Judge("1e-75"));
  EXPECT_LT(abs(Judge(integrals[2] - e)), Judge("1e-75"));
  EXPECT_EQ(integrals[3], 0);
}

TEST(Kepler, HasNoForceAndNamesACollisionNearTheCentre) {
  Kepler<double> const near_sighted(1e-3);
  PhaseState<double, 2> const collided{{6e-4, -7e-4}, {1, 2}}, passing{{6e-4, -9e-4}, {1, 2}};
  EXPECT_TRUE(std::isnan(near_sighted.force(collided.q)[0]));
  EXPECT_TRUE(std::isnan(near_sighted.rate(collided).p[1]));
  EXPECT_EQ(near_sighted.failure(collided, 0), Failure::collision);
  EXPECT_TRUE(std::isfinite(near_sighted.force(passing.q)[0]));
  EXPECT_EQ(near_sighted.failure(passing, 0), Failure::none);
}

TEST(Kepler, PhaseIsTheTimeByWhichABodyIsAheadOnItsOrbit) {
  KeplerFlow<Judge> const flow(system, pericentre(Judge("0.6")));
  auto const errors = system.state_errors(flow(Judge("5.00001")), flow(Judge(5)));
  EXPECT_NEAR(static_cast<double>(errors[4]), 1e-5, 1e-9);
}

}  // namespace
}  // namespace brouwer
