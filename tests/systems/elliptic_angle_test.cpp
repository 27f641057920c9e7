// The elliptic attitude's angle in closed form against its quadrature, at 77 digits: each is the other's oracle.
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

/// The largest difference of the two flows' attitudes; NaN counts as infinite.
double difference(RigidBody<Judge> const& body, RigidBodyState<Judge> const& start, std::vector<Judge> const& times) {
  RigidBodyFlow<Judge> const quadrature(body, start), closed(body, start, AngleBy::carlson);
  double worst = 0;
  for (auto const& t : times) {
    auto const a = quadrature(t), b = closed(t);
    for_components(
        [&](Judge const& v, Judge const& w) {
          double const d = std::abs(static_cast<double>(Judge(v - w)));
          worst = d <= worst ? worst : std::isnan(d) ? INFINITY : d;
        },
        a, b);
  }
  return worst;
}

std::vector<Judge> forward_and_back() {
  return {Judge(0),      Judge("1e-9"), Judge("0.3"), Judge(2),     Judge("7.5"),
          Judge("31.4"), Judge(200),    Judge("-1"),  Judge("-13"), Judge("-150.5")};
}

struct AngleOfABody : testing::TestWithParam<BodyCase> {};
INSTANTIATE_TEST_SUITE_P(Generic, AngleOfABody, testing::ValuesIn(generic_bodies()),
                         [](auto const& one) { return "Case" + std::to_string(one.index); });
INSTANTIATE_TEST_SUITE_P(Special, AngleOfABody, testing::ValuesIn(special_bodies()),
                         [](auto const& one) { return "Case" + std::to_string(one.index); });

TEST_P(AngleOfABody, InClosedFormIsTheQuadratureTo70DigitsOverManyPeriods) {
  auto const& c = GetParam();
  EXPECT_LT(difference(c.body<Judge>(), c.start<Judge>(), forward_and_back()), 1e-70) << c.name;
}

/// Real bodies of any shape; some nearly symmetric, some close to an axis: both branches, all signs.
BodyCase random_body(Uniform& uniform, int i) {
  double const I1 = uniform(0.1, 1), I2 = i % 5 == 0 ? I1 * (1 + uniform(0, 1e-8)) : I1 * uniform(1, 4);
  double const I3 = i % 5 == 1 ? I2 * (1 + uniform(0, 1e-8)) : uniform(I2, I1 + I2);
  BodyCase c{"random", {I1, I2, I3}, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}, {0.5, 0.5, -0.5, 0.5}};
  auto const axis = static_cast<std::size_t>(i % 3);
  if (i % 7 == 0) c.momentum[axis] *= 1e-8;
  if (i % 11 == 0) c.momentum[(axis + 1) % 3] *= 1e-10;
  return c;
}

TEST(EllipticAngle, IsTheQuadratureTo70DigitsForRandomBodiesAndTimes) {
  Uniform uniform(12);
  for (int i = 0; i < 40; ++i) {
    auto const c = random_body(uniform, i);
    std::vector<Judge> const times{Judge(uniform(-100, 100)), Judge(uniform(-1, 1)), Judge(uniform(0, 10))};
    EXPECT_LT(difference(c.body<Judge>(), c.start<Judge>(), times), 1e-70) << "body " << i;
  }
}

TEST(EllipticAngle, MakesTheFlowAGroup) {
  for (auto const& c : generic_bodies()) {
    auto const body = c.body<Judge>();
    RigidBodyFlow<Judge> const flow(body, c.start<Judge>(), AngleBy::carlson);
    Judge const s("17.25"), t("4.5");
    auto const direct = flow(Judge(s + t)), onward = RigidBodyFlow<Judge>(body, flow(s), AngleBy::carlson)(t);
    for_components([&](Judge const& a, Judge const& b) { EXPECT_LT(abs(Judge(a - b)), Judge("1e-71")) << c.name; },
                   direct, onward);
  }
}

TEST(EllipticAngle, ErrsByRoundingInDoubleAndFloat128) {
  auto const worst = [](auto zero, double t) {
    using T = decltype(zero);
    double ulps = 0;
    for (auto const& c : generic_bodies()) {
      auto const start = c.start<T>();
      RigidBodyState<Judge> wide;
      for_components([](Judge& w, T const& v) { w = Judge(v); }, wide, start);
      auto const exact = RigidBodyFlow<Judge>(c.body<T>().template in<Judge>(), wide)(Judge(t));
      auto const reached = RigidBodyFlow<T>(c.body<T>(), start, AngleBy::carlson)(T(t));
      for_components([&](T const& a, Judge const& b) { ulps = std::max(ulps, testing_support::absolute_ulps(a, b)); },
                     reached, exact);
    }
    return ulps;
  };
  EXPECT_LT(worst(0.0, 3), 40);
  EXPECT_LT(worst(Float128(0), 3), 40);
}

}  // namespace
}  // namespace brouwer
