// Members of one pack that need different numbers of terms, halvings and pieces: each lane is its scalar run.
#include <brouwer/integrators/elliptic_branch_free.hpp>
#include <brouwer/integrators/stepper.hpp>
#include <brouwer/scalar/pack.hpp>
#include <brouwer/systems/rigid_body_flow.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "tests/bodies.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::BodyCase;
using testing_support::generic_bodies;
using testing_support::Judge;
using testing_support::special_bodies;

constexpr int steps = 200;

/// Special bodies next to generic ones, so that neighbours differ in everything.
std::vector<BodyCase> mixed_bodies() {
  std::vector<BodyCase> mixed;
  auto const generic = generic_bodies(), special = special_bodies();
  for (std::size_t i = 0; i < special.size(); ++i) {
    mixed.push_back(generic[i % generic.size()]);
    mixed.push_back(special[i]);
  }
  return mixed;
}

/// What is integrated: members `first` … of the mixed bodies, with a step of their own.
template <class T>
Setup<RigidBody<T>> setup_of_lanes(std::size_t first, bool attitude) {
  auto const bodies = mixed_bodies();
  auto const member = [&](int i) { return bodies[(first + static_cast<std::size_t>(i)) % bodies.size()]; };
  using E = Element<T>;
  Vector3<T> inertia;
  RigidBodyState<T> start;
  for (int j = 0; j < 3; ++j) {
    inertia[j] = from_lanes<T>([&](int i) { return member(i).template body<E>().inertia()[j]; });
    start.momentum[j] = from_lanes<T>([&](int i) { return member(i).template start<E>().momentum[j]; });
  }
  for (int j = 0; j < 4; ++j)
    start.attitude.coeffs()[j] =
        from_lanes<T>([&](int i) { return member(i).template start<E>().attitude.coeffs()[j]; });
  std::array<double, 3> const step_sizes{0.01, 0.7, 12};
  T const h = from_lanes<T>([&](int i) { return E(step_sizes[(first + static_cast<std::size_t>(i)) % 3]); });
  return {RigidBody<T>(inertia), h, start, attitude};
}

template <class T>
Setup<RigidBody<Element<T>>> setup_of_lane(Setup<RigidBody<T>> const& s, int i) {
  auto const vector = [&](Vector3<T> const& v) {
    return Vector3<Element<T>>{lane(v[0], i), lane(v[1], i), lane(v[2], i)};
  };
  RigidBodyState<Element<T>> start;
  for_components([&](auto& a, auto const& pack) { a = lane(pack, i); }, start, s.start);
  return {RigidBody<Element<T>>(vector(s.system.inertia())), lane(s.step, i), start, s.whole_state};
}

template <class Y>
auto components(Y const& y) {
  std::vector<typename Y::Scalar> all;
  if constexpr (requires { y.residue; }) {
    for (auto const* part : {&y.value, &y.residue}) for_components([&](auto const& a) { all.push_back(a); }, *part);
  } else {
    for_components([&](auto const& a) { all.push_back(a); }, y);
  }
  return all;
}

/// Runs of a pack, step by step and in stages, and of each of its lanes from the same start, summed as Y does.
template <template <class> class S, template <class> class Y, class T>
void expect_lanes_equal_scalar_runs() {
  using E = Element<T>;
  for (bool attitude : {false, true})
    for (std::size_t first = 0; first < mixed_bodies().size(); first += lanes<T>) {
      auto const setup = setup_of_lanes<T>(first, attitude);
      Y<RigidBodyState<T>> pack(setup.start);
      S<T> const stepper(setup);
      advance(stepper, pack, steps / 2);
      advance_block(std::span<S<T> const>(&stepper, 1), std::span<Y<RigidBodyState<T>>>(&pack, 1), steps / 2);
      for (int i = 0; i < lanes<T>; ++i) {
        auto const alone = setup_of_lane(setup, i);
        Y<RigidBodyState<E>> scalar(alone.start);
        advance(S<E>(alone), scalar, steps);
        auto const a = components(pack);
        auto const b = components(scalar);
        for (std::size_t j = 0; j < a.size(); ++j) {
          E const of_pack = lane(a[j], i);
          EXPECT_TRUE(std::isfinite(b[j])) << "member " << first << " + " << i << ", component " << j;
          EXPECT_EQ(std::memcmp(&of_pack, &b[j], sizeof(E)), 0)
              << "member " << first << " + " << i << ", component " << j << ": " << of_pack << " and " << b[j];
        }
      }
    }
}

template <class S>
using Plain = S;

template <class T>
struct AdditionStepInLanes : testing::Test {};
using Packs = testing::Types<Pack<double, 2>, Pack<double, 4>, Pack<double, 8>, Pack<float, 4>, Pack<float, 8>>;
TYPED_TEST_SUITE(AdditionStepInLanes, Packs);

TYPED_TEST(AdditionStepInLanes, EqualsTheScalarRunBitForBitWhateverTheNeighboursNeed) {
  expect_lanes_equal_scalar_runs<EllipticBranchFree, Plain, TypeParam>();
  expect_lanes_equal_scalar_runs<EllipticIncrement, Plain, TypeParam>();
  expect_lanes_equal_scalar_runs<EllipticIncrement, Compensated, TypeParam>();
}

TEST(SeriesPlan, DiffersBetweenTheStepsThatAreMixedHere) {
  auto const c = generic_bodies()[0];
  auto const plan = [&](double h) {
    return plan_series(EllipticConstants<double>(c.body<double>()), c.start<double>().momentum, h, 0);
  };
  EXPECT_LT(plan(0.01).terms, plan(0.7).terms);
  EXPECT_LT(plan(0.7).halvings, plan(12).halvings);
}

TEST(AttitudeConstant, IsOneOfTheTrajectory) {
  // wherever on it the quadrature starts from, and of size h²
  for (auto const& c : generic_bodies()) {
    auto const body = c.body<Judge>();
    auto const flow = RigidBodyFlow<Judge>(body, c.start<Judge>());
    Judge const h("0.1");
    Judge const here = symmetric_step(body, c.start<Judge>().momentum, h, 30).rho;
    Judge const later = symmetric_step(body, flow.momentum(Judge(1)), h, 30).rho;
    EXPECT_LT(abs(Judge(later - here)), Judge("1e-68")) << c.name;
    Judge const of_half = symmetric_step(body, c.start<Judge>().momentum, Judge(h / 2), 30).rho;
    EXPECT_NEAR(static_cast<double>(Judge(here / of_half)), 4, 0.1) << c.name;
  }
}

}  // namespace
}  // namespace brouwer
