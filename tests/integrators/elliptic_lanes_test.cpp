// The momentum steps of the elliptic integrators in packs: every lane has the bits of its member's scalar run.
#include <brouwer/integrators/elliptic_naive.hpp>
#include <brouwer/integrators/elliptic_three_constants.hpp>

#include <gtest/gtest.h>

#include "tests/bodies.hpp"
#include "tests/lanes.hpp"

namespace brouwer {

namespace {

using testing_support::BodyCase;

using T = Pack<double, 8>;

template <class F>
Vector3<T> vector_of_lanes(F component) {
  auto const along = [&](int j) { return from_lanes<T>([&](int i) { return component(i, j); }); };
  return {along(0), along(1), along(2)};
}

/// Generic bodies of both branches, and rest on an axis, the separatrix with either sign, a ball and a symmetric body.
std::vector<BodyCase> mixture() {
  auto cases = testing_support::generic_bodies();
  for (auto const& c : testing_support::special_bodies()) cases.push_back(c);
  cases.push_back({"near the separatrix", {2, 3, 6}, {1, 0.5, 1 - 1e-14}, {1, 0, 0, 0}});
  return cases;
}

template <template <class> class Stepper>
void expect_lanes_equal_scalar_runs(double h) {
  auto const cases = mixture();
  for (std::size_t first = 0; first < cases.size(); ++first) {
    auto const in_lane = [&](int i) -> BodyCase const& {
      return cases[(first + 3 * static_cast<std::size_t>(i)) % cases.size()];
    };
    RigidBody<T> const body(
        vector_of_lanes([&](int i, int j) { return in_lane(i).inertia[static_cast<std::size_t>(j)]; }));
    RigidBodyState<T> y{vector_of_lanes([&](int i, int j) { return in_lane(i).momentum[static_cast<std::size_t>(j)]; }),
                        {T(1), T(0), T(0), T(0)}};
    advance(Stepper<T>(Setup<RigidBody<T>>{body, T(h), y, false}), y, 200);

    for (int i = 0; i < lanes<T>; ++i) {
      BodyCase const& c = in_lane(i);
      auto alone = c.start<double>();
      advance(Stepper<double>(Setup<RigidBody<double>>{c.body<double>(), h, alone, false}), alone, 200);
      for (int j = 0; j < 3; ++j) {
        EXPECT_TRUE(testing_support::same_bits(y.momentum[j][i], alone.momentum[j])) << c.name << ", lane " << i;
        EXPECT_TRUE(std::isfinite(alone.momentum[j])) << c.name;
      }
    }
  }
}

template <class S>
using Naive = EllipticNaive<S, OwnElliptic>;
template <class S>
using ThreeConstants = EllipticThreeConstants<S, OwnElliptic>;
template <class S>
using Addition = EllipticAddition<S, OwnElliptic>;

TEST(EllipticLanes, OfTheNaiveStepEqualScalarRuns) {
  expect_lanes_equal_scalar_runs<Naive>(0.01);
  expect_lanes_equal_scalar_runs<Naive>(3);
}
TEST(EllipticLanes, OfTheThreeConstantsStepEqualScalarRuns) {
  expect_lanes_equal_scalar_runs<ThreeConstants>(0.01);
  expect_lanes_equal_scalar_runs<ThreeConstants>(3);
}
TEST(EllipticLanes, OfTheAdditionStepEqualScalarRuns) {
  expect_lanes_equal_scalar_runs<Addition>(0.01);
  expect_lanes_equal_scalar_runs<Addition>(3);
}

}  // namespace
}  // namespace brouwer
