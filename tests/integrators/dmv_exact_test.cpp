// The discrete Moser–Veselov algorithm preprocessed to order infinity: the exact flow, or no number.
#include <brouwer/integrators/dmv_exact.hpp>
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
using testing_support::Uniform;

/// Decimals as decimals: I₁ is 0.6, not the double next to it.
RigidBody<Judge> standard_body() { return RigidBody<Judge>(Vector3<Judge>{Judge("0.6"), Judge("0.8"), Judge(1)}); }
Vector3<Judge> standard_momentum() { return {Judge("1.8"), Judge("0.4"), Judge("-0.9")}; }

template <class T>
double length(Vector3<T> const& y) {
  return std::sqrt(static_cast<double>(squared_norm(y)));
}

/// The largest error of a component after some steps; NaN counts as infinite.
template <class T>
double error_of_steps(RigidBody<T> const& body, RigidBodyState<T> const& start, T const& h, int steps) {
  using E = std::conditional_t<std::same_as<T, Judge>, Judge, Float128>;
  auto y = start;
  advance(DmvExact<T>({body, h, start}), y, steps);
  auto const widened = [](RigidBodyState<T> const& s) {
    RigidBodyState<E> wide;
    for_components([](E& w, T const& v) { w = E(v); }, wide, s);
    return wide;
  };
  auto const exact = RigidBodyFlow<E>(body.template in<E>(), widened(start))(E(E(h) * steps));
  double worst = 0;
  for_components(
      [&](E const& a, T const& b) {
        auto const error = std::abs(static_cast<double>(E(a - E(b))));
        worst = error <= worst ? worst : std::isnan(error) ? INFINITY : error;
      },
      exact, y);
  return worst;
}

double error_of_steps(BodyCase const& c, Judge const& h) {
  return error_of_steps(c.body<Judge>(), c.start<Judge>(), h, 3);
}

// --- the exact flow ---------------------------------------------------------------------------------------------------

TEST(DmvExact, IsTheFlowTo72DigitsInMomentumAndAttitudeOnBothBranches) {
  for (auto const& c : generic_bodies())
    for (char const* h : {"0.01", "0.3", "-0.3"}) EXPECT_LT(error_of_steps(c, Judge(h)), 1e-72) << c.name << ", " << h;
}

TEST(DmvExact, IsTheFlowTo72DigitsInEverySpecialCase) {
  for (auto const& c : special_bodies())
    for (char const* h : {"0.05", "-0.4"}) EXPECT_LT(error_of_steps(c, Judge(h)), 1e-72) << c.name << ", " << h;
}

/// A body of any shape, a fifth of them nearly symmetric, some of them near rest on an axis.
struct RandomBody {
  RigidBody<double> body;
  RigidBodyState<double> start;
  double step;  ///< turns by 0.01 … 3 radians at most

  static RandomBody draw(Uniform& uniform, int i) {
    double const I1 = std::pow(10.0, uniform(-1.5, 0));
    double const I2 = i % 5 == 0 ? I1 * (1 + uniform(0, 1e-7)) : I1 * std::pow(10.0, uniform(0, 1));
    double const I3 = i % 5 == 1 ? I2 * (1 + uniform(0, 1e-7)) : uniform(I2, I1 + I2);
    Vector3<double> y{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    if (i % 7 == 0) y[i % 3] *= 1e-6;
    if (i % 11 == 0) y[(i + 1) % 3] *= 1e-9;
    double const h = std::pow(10.0, uniform(-2, 0.5)) * I1 / length(y) * (i % 2 == 0 ? 1 : -1);
    return {RigidBody<double>(Vector3<double>{I1, I2, I3}), {y, {1, 0, 0, 0}}, h};
  }

  bool has_parameters() const {
    auto const& y = start.momentum;
    return dmv_exact_exists(body.in<Float128>(), Vector3<Float128>{y[0], y[1], y[2]}, Float128(step));
  }
};

TEST(DmvExact, IsTheFlowTo72DigitsForRandomBodies) {
  Uniform uniform(1);
  int tried = 0;
  for (int i = 0; i < 60; ++i) {
    auto const c = RandomBody::draw(uniform, i);
    if (!c.has_parameters()) continue;
    auto const& y = c.start.momentum;
    RigidBodyState<Judge> const start{{Judge(y[0]), Judge(y[1]), Judge(y[2])}, {1, 0, 0, 0}};
    EXPECT_LT(error_of_steps(c.body.in<Judge>(), start, Judge(c.step), 2), 1e-72) << "body " << i;
    ++tried;
  }
  EXPECT_GT(tried, 50);
}

TEST(DmvExact, IsTheFlowToRoundingInDouble) {
  for (auto const& c : generic_bodies())
    EXPECT_LT(error_of_steps(c.body<double>(), c.start<double>(), 0.1, 20), 60 * epsilon<double>() * 2) << c.name;
}

// --- where it exists --------------------------------------------------------------------------------------------------

/// The largest angle by which the flow turns the body over h, from the points that 30 steps meet; radians.
double largest_turn(RandomBody const& c) {
  auto const& y = c.start.momentum;
  RigidBodyState<Float128> before{{y[0], y[1], y[2]}, {1, 0, 0, 0}};
  RigidBodyFlow<Float128> const flow(c.body.in<Float128>(), before);
  double largest = 0;
  for (int k = 1; k <= 30; ++k) {
    auto const after = flow(Float128(c.step) * k);
    auto const half_cosine = hamilton_product(conjugate(before.attitude), after.attitude).w();
    largest = std::max(largest, 2 * std::acos(std::min(1.0, static_cast<double>(half_cosine))));
    before = after;
  }
  return largest;
}

TEST(DmvExact, ExistsWhereNoStepTurnsTheBodyByARightAngleAndIsTheFlowOrNaN) {
  Uniform uniform(5);
  double const right_angle = std::acos(0.0);
  int none = 0, unsettled = 0;
  for (int i = 0; i < 300; ++i) {
    auto const c = RandomBody::draw(uniform, i);
    double const turn = largest_turn(c);
    if (!c.has_parameters()) {
      EXPECT_GT(turn, right_angle - 0.02) << "body " << i;  // 30 steps may miss the point where it is largest
      ++none;
      continue;
    }
    EXPECT_LT(turn, right_angle) << "body " << i;
    double const error = error_of_steps(c.body, c.start, c.step, 20);
    if (std::isinf(error)) {
      EXPECT_GT(turn, 1.4) << "body " << i;  // the iteration, close to a right angle
      ++unsettled;
    } else {
      EXPECT_LT(error, 2e-13) << "body " << i;
    }
  }
  RecordProperty("unsettled", unsettled);
  EXPECT_GT(none, 5);
  EXPECT_LE(unsettled, 2);
}

TEST(DmvExact, OfABallExistsUpToARightAngleAndNotAgainBeyond) {
  RigidBody<double> const ball(Vector3<double>{0.5, 0.5, 0.5});
  Vector3<double> const y{0, 0, 1};
  for (double angle : {0.1, 1.5, -1.57}) EXPECT_TRUE(dmv_exact_exists(ball, y, angle / 2)) << angle;
  for (double angle : {1.58, -2.0, 4.0, 6.2, 6.4, 12.5, 12.6, 1e6, 1e300}) {
    EXPECT_FALSE(dmv_exact_exists(ball, y, angle / 2)) << angle;
  }
}

TEST(DmvExact, OfTheStandardTestExistsUpToAStepOf0496) {
  EXPECT_TRUE(dmv_exact_exists(standard_body(), standard_momentum(), Judge("0.4960068038")));
  EXPECT_FALSE(dmv_exact_exists(standard_body(), standard_momentum(), Judge("0.4960068039")));
}

TEST(DmvExact, HasNoNumbersWhereThereIsNoStepAndNoStart) {
  auto const c = generic_bodies()[0];
  auto const fails = [&](RigidBodyState<double> const& start, double h) {
    auto y = start;
    advance(DmvExact<double>({c.body<double>(), h, start}), y, 1);
    return std::isnan(y.momentum[0]) && std::isnan(y.attitude.w());
  };
  auto bad = c.start<double>();
  EXPECT_FALSE(fails(bad, 0.1));
  for (double h : {0.6, 3.0, 50.0, 1e300, double{INFINITY}, double{NAN}}) EXPECT_TRUE(fails(bad, h)) << h;
  for (double v : {double{INFINITY}, double{NAN}, 1e300}) {
    bad.momentum[1] = v;
    EXPECT_TRUE(fails(bad, 0.1)) << v;
  }
}

// --- σ and δ ----------------------------------------------------------------------------------------------------------

TEST(DmvExactParameters, HaveTheValuesOfTheStandardTest) {
  auto const fine = dmv_exact_parameters(standard_body(), standard_momentum(), Judge("0.1"));
  EXPECT_LT(abs(Judge(fine.sigma - Judge("0.97589235914914407898"))), Judge("1e-20"));
  EXPECT_LT(abs(Judge(fine.delta - Judge("0.011917596645724367648"))), Judge("1e-21"));
  auto const coarse = dmv_exact_parameters(standard_body(), standard_momentum(), Judge("0.4"));
  EXPECT_LT(abs(Judge(coarse.sigma - Judge("0.6585248381888993448"))), Judge("1e-19"));
  EXPECT_LT(abs(Judge(coarse.delta - Judge("0.15156320789289605336"))), Judge("1e-20"));
}

TEST(DmvExactParameters, BelongToTheTrajectoryAndToEitherSignOfTheStep) {
  for (auto const& c : generic_bodies()) {
    auto const body = c.body<Judge>();
    auto const start = c.start<Judge>();
    auto const here = dmv_exact_parameters(body, start.momentum, Judge("0.2"));
    auto const there = dmv_exact_parameters(body, RigidBodyFlow<Judge>(body, start).momentum(Judge(1)), Judge("-0.2"));
    EXPECT_LT(abs(Judge(here.sigma - there.sigma)), Judge("1e-74")) << c.name;
    EXPECT_LT(abs(Judge(here.delta - there.delta)), Judge("1e-72")) << c.name;
  }
}

/// σ and δ of the series of an order, from η = (h/2)(σ/I + δ) on two axes.
template <int order>
DmvExactParameters<Judge> of_series(RigidBody<Judge> const& body, Vector3<Judge> const& y, Judge const& h) {
  auto const eta = DmvModifiedInertia<Judge, order>(body, h)(y);
  auto const& I = body.inertia();
  Judge const sigma = 2 / h * (eta[0] - eta[2]) / (1 / I[0] - 1 / I[2]);
  return {sigma, 2 / h * eta[1] - sigma / I[1]};
}

template <int order>
void expect_series_to_miss_by_its_order() {
  for (auto const& c : generic_bodies()) {
    auto const body = c.body<Judge>();
    auto const y = c.start<Judge>().momentum;
    auto const errors = [&](Judge const& h) {
      auto const exact = dmv_exact_parameters(body, y, h), series = of_series<order>(body, y, h);
      return std::array{static_cast<double>(Judge(series.sigma - exact.sigma)),
                        static_cast<double>(Judge(series.delta - exact.delta))};
    };
    auto const coarse = errors(Judge("0.02")), fine = errors(Judge("0.01"));
    for (std::size_t i : {0U, 1U}) EXPECT_NEAR(std::log2(coarse[i] / fine[i]), order, 0.05) << c.name << ' ' << i;
  }
}

TEST(DmvExactParameters, AreTheLimitOfTheSeriesOfEveryOrder) {
  expect_series_to_miss_by_its_order<2>();
  expect_series_to_miss_by_its_order<4>();
  expect_series_to_miss_by_its_order<6>();
  expect_series_to_miss_by_its_order<8>();
  expect_series_to_miss_by_its_order<10>();
}

/// What docs/dmv-exact.md shows.
struct Line {
  char const* h;
  double sigma, delta;
};

template <int order>
void expect_series_to_miss_by(std::array<Line, 3> const& lines) {
  for (auto const& line : lines) {
    Judge const h(line.h);
    auto const exact = dmv_exact_parameters(standard_body(), standard_momentum(), h);
    auto const series = of_series<order>(standard_body(), standard_momentum(), h);
    EXPECT_NEAR(static_cast<double>(Judge(series.sigma - exact.sigma)) / line.sigma, 1, 0.005)
        << order << ' ' << line.h;
    EXPECT_NEAR(static_cast<double>(Judge(series.delta - exact.delta)) / line.delta, 1, 0.005)
        << order << ' ' << line.h;
  }
}

TEST(DmvExactParameters, DifferFromTheSeriesAsDocumented) {
  expect_series_to_miss_by<2>({{{"0.01", 2.43e-4, -1.209e-4}, {"0.1", 0.02411, -0.01192}, {"0.4", 0.3415, -0.1516}}});
  expect_series_to_miss_by<4>(
      {{{"0.01", -1.943e-8, 1.733e-8}, {"0.1", -1.937e-4, 1.727e-4}, {"0.4", -0.04735, 0.04188}}});
  expect_series_to_miss_by<6>(
      {{{"0.01", 6.032e-13, -6.237e-13}, {"0.1", 6.022e-7, -6.227e-7}, {"0.4", 2.407e-3, -2.485e-3}}});
  expect_series_to_miss_by<8>(
      {{{"0.01", -9.945e-18, 1.092e-17}, {"0.1", -9.935e-10, 1.091e-9}, {"0.4", -6.411e-5, 7.037e-5}}});
  expect_series_to_miss_by<10>(
      {{{"0.01", 1.033e-22, -1.17e-22}, {"0.1", 1.032e-12, -1.17e-12}, {"0.4", 1.071e-6, -1.213e-6}}});
}

TEST(DmvExactParameters, OfABallTurnItByTheSineOfItsAngle) {
  // tan(φ/2) = c and α = 1 + c² with c = αη|y|: sin φ = 2η|y| for φ = h|y|/I
  RigidBody<Judge> const ball(Vector3<Judge>{Judge("0.75"), Judge("0.75"), Judge("0.75")});
  Judge const h("0.4"), r = sqrt(squared_norm(standard_momentum()));
  auto const p = dmv_exact_parameters(ball, standard_momentum(), h);
  Judge const eta = h / 2 * (p.sigma / Judge("0.75") + p.delta);
  EXPECT_LT(abs(Judge(2 * eta * r - sin(Judge(h * r / Judge("0.75"))))), Judge("1e-75"));
}

TEST(DmvExactParameters, OnAPrincipalAxisAreThoseOfSmallOscillationsAboutIt) {
  // of frequency ν = r √((1/I₁ − 1/I₃)(1/I₂ − 1/I₃)): α(h/2)σ = tan(νh/2)/ν, and √α = 1/cos(φ/2)
  Judge const h("0.3"), r("1.5"), x1 = 1 / Judge("0.6"), x2 = 1 / Judge("0.8");
  auto const p = dmv_exact_parameters(standard_body(), Vector3<Judge>{0, 0, r}, h);
  Judge const nu = r * sqrt(Judge((x1 - 1) * (x2 - 1))), phi = h * r;
  Judge const sigma = squared(Judge(cos(Judge(phi / 2)))) * tan(Judge(nu * h / 2)) / (nu * h / 2);
  EXPECT_LT(abs(Judge(p.sigma - sigma)), Judge("1e-75"));
  EXPECT_LT(abs(Judge(h * (p.sigma + p.delta) * r - sin(phi))), Judge("1e-75"));
}

TEST(DmvExactParameters, OfNoStepAreThoseOfOrder2) {
  auto const p = dmv_exact_parameters(standard_body(), standard_momentum(), Judge(0));
  EXPECT_EQ(p.sigma, 1);
  EXPECT_EQ(p.delta, 0);
}

/// In units of ε: of σ, and of δ against σ/I₁, beside which it stands.
template <class T>
double worst_ulps(int bodies) {
  Uniform uniform(9);
  double worst = 0;
  for (int i = 0; i < bodies; ++i) {
    auto const c = RandomBody::draw(uniform, i);
    auto const in = [&](auto zero) {
      using W = decltype(zero);
      auto const& y = c.start.momentum;
      return dmv_exact_parameters(c.body.in<W>(), Vector3<W>{W(y[0]), W(y[1]), W(y[2])}, W(c.step));
    };
    auto const exact = in(Judge(0));
    if (!exact.exist() || exact.sigma < 0.3) continue;
    auto const p = in(T(0));
    double const I1 = c.body.inertia()[0];
    worst = std::max({worst, std::abs(static_cast<double>(Judge(Judge(p.sigma) / exact.sigma - 1))),
                      std::abs(static_cast<double>(Judge((Judge(p.delta) - exact.delta) * I1 / exact.sigma)))});
  }
  return worst / static_cast<double>(epsilon<T>());
}

TEST(DmvExactParameters, ErrByLittleInEveryArithmetic) {
  auto const in_double = worst_ulps<double>(60), in_quadruple = worst_ulps<Float128>(60);
  RecordProperty("double", std::to_string(in_double));
  RecordProperty("float128", std::to_string(in_quadruple));
  EXPECT_LT(in_double, 4);
  EXPECT_LT(in_quadruple, 4);
}

}  // namespace
}  // namespace brouwer
