// The rigid body: its vector field, first integrals, errors, and the exact flow that judges everything else.
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

Judge distance(RigidBodyState<Judge> const& a, RigidBodyState<Judge> const& b) {
  Judge worst = 0;
  for_components([&worst](Judge const& x, Judge const& y) { worst = larger(worst, Judge(abs(Judge(x - y)))); }, a, b);
  return worst;
}

struct ExactFlowOfABody : testing::TestWithParam<BodyCase> {
  RigidBody<Judge> const body = GetParam().body<Judge>();
  RigidBodyState<Judge> const start = GetParam().start<Judge>();
  RigidBodyFlow<Judge> const flow{body, start};
};
INSTANTIATE_TEST_SUITE_P(Generic, ExactFlowOfABody, testing::ValuesIn(generic_bodies()),
                         [](auto const& one) { return "Case" + std::to_string(one.index); });

TEST_P(ExactFlowOfABody, SatisfiesTheEquationsOfMotion) {
  // central difference at 77 digits, step 10⁻²⁵: error 10⁻⁵⁰
  Judge const h("1e-25");
  for (char const* at : {"0", "0.7", "13.3"}) {
    Judge const t(at);
    auto const now = flow(t), before = flow(Judge(t - h)), after = flow(Judge(t + h));
    auto const rate = body.momentum_rate(now.momentum), omega = body.angular_velocity(now.momentum);
    for (int i = 0; i < 3; ++i)
      EXPECT_LT(abs(Judge((after.momentum[i] - before.momentum[i]) / (2 * h) - rate[i])), Judge("1e-46"));
    // q̇ = ½ q ⊗ (0, I⁻¹y)
    auto const turn = hamilton_product(now.attitude, Quaternion<Judge>(0, omega[0] / 2, omega[1] / 2, omega[2] / 2));
    EXPECT_LT(abs(Judge((after.attitude.w() - before.attitude.w()) / (2 * h) - turn.w())), Judge("1e-46"));
    EXPECT_LT(abs(Judge((after.attitude.x() - before.attitude.x()) / (2 * h) - turn.x())), Judge("1e-46"));
    EXPECT_LT(abs(Judge((after.attitude.y() - before.attitude.y()) / (2 * h) - turn.y())), Judge("1e-46"));
    EXPECT_LT(abs(Judge((after.attitude.z() - before.attitude.z()) / (2 * h) - turn.z())), Judge("1e-46"));
  }
}

TEST_P(ExactFlowOfABody, IsAGroup) {
  // several periods forward, onward from there, and back
  Judge const s("17.25"), t("4.5");
  auto const direct = flow(Judge(s + t));
  auto const onward = RigidBodyFlow<Judge>(body, flow(s))(t);
  EXPECT_LT(distance(direct, onward), Judge("1e-72"));
  EXPECT_LT(distance(RigidBodyFlow<Judge>(body, direct)(Judge(-s - t)), start), Judge("1e-72"));
}

TEST_P(ExactFlowOfABody, ConservesTheFirstIntegrals) {
  auto const at_start = body.first_integrals(start), later = body.first_integrals(flow(Judge("1000.5")));
  for (std::size_t i = 0; i < at_start.size(); ++i) EXPECT_LT(abs(Judge(later[i] - at_start[i])), Judge("1e-70")) << i;
}

struct ExactFlowInASpecialCase : ExactFlowOfABody {};
INSTANTIATE_TEST_SUITE_P(Special, ExactFlowInASpecialCase, testing::ValuesIn(special_bodies()),
                         [](auto const& one) { return "Case" + std::to_string(one.index); });

TEST_P(ExactFlowInASpecialCase, SatisfiesTheEquationsOfMotion) {
  Judge const h("1e-20"), t("2.5");
  auto const now = flow(t), before = flow(Judge(t - h)), after = flow(Judge(t + h));
  auto const rate = body.momentum_rate(now.momentum), omega = body.angular_velocity(now.momentum);
  auto const turn = hamilton_product(now.attitude, Quaternion<Judge>(0, omega[0] / 2, omega[1] / 2, omega[2] / 2));
  for (int i = 0; i < 3; ++i)
    EXPECT_LT(abs(Judge((after.momentum[i] - before.momentum[i]) / (2 * h) - rate[i])), Judge("1e-35"))
        << GetParam().name;
  EXPECT_LT(abs(Judge((after.attitude.w() - before.attitude.w()) / (2 * h) - turn.w())), Judge("1e-35"));
  EXPECT_LT(abs(Judge((after.attitude.x() - before.attitude.x()) / (2 * h) - turn.x())), Judge("1e-35"));
}

TEST(RigidBodyRotation, HasTheRightSenseAndIgnoresTheLengthOfTheQuaternion) {
  // a quarter turn about axis 3 takes axis 1 to axis 2
  Quaternion<double> const quarter(2, 0, 0, 2);
  auto const image = rotated(quarter, {1, 0, 0});
  EXPECT_NEAR(image[0], 0, 1e-16);
  EXPECT_NEAR(image[1], 1, 1e-16);
  auto const vector = rotation_vector(Quaternion<double>(-0.6, 0, 0, -0.8));  // −q is the same rotation as q
  EXPECT_NEAR(vector[2], 2 * std::atan2(0.8, 0.6), 1e-15);
  EXPECT_EQ(rotation_vector(Quaternion<double>(1, 0, 0, 0))[1], 0);
}

TEST(RigidBodyErrors, ArePhaseAndRotationOfAKnownDisplacement) {
  auto const c = generic_bodies()[0];
  auto const body = c.body<Judge>();
  auto const start = c.start<Judge>();
  RigidBodyFlow<Judge> const flow(body, start);
  // a state that is ahead by 10⁻¹² in time has that phase, and is turned by the angular velocity times that
  Judge const ahead("1e-12");
  auto const errors = body.state_errors(flow(Judge(3 + ahead)), flow(Judge(3)));
  auto const omega = body.angular_velocity(flow(Judge(3)).momentum);
  EXPECT_NEAR(static_cast<double>(errors[6]) * 1e12, 1, 1e-10);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(static_cast<double>(errors[3 + i]) * 1e12, static_cast<double>(omega[static_cast<int>(i)]), 1e-10);
}

TEST(RigidBodyInertia, IsRefusedWhereNoBodyHasIt) {
  EXPECT_FALSE(inertia_complaint({0.6, 0.8, 1.0}));
  EXPECT_FALSE(inertia_complaint({0.1, 0.2, 0.1 + 0.2})) << "a flat body in decimals";
  for (std::vector<double> const& bad :
       {std::vector<double>{0, 1, 1}, {-1, 1, 1}, {1, 0.5, 1.2}, {0.3, 0.4, 0.8}, {NAN, 1, 1}, {1, 1, INFINITY}})
    EXPECT_TRUE(inertia_complaint(bad)) << bad[0] << ' ' << bad[1] << ' ' << bad[2];
}

}  // namespace
}  // namespace brouwer
