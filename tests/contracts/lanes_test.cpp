// A member's result is the same bits alone, in a lane of a pack, and in a block of packs of any size.
#include <brouwer/scalar/pack.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <set>

#include "tests/bodies.hpp"
#include "tests/contracts/steppers.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::generic_bodies;
using testing_support::special_bodies;
using testing_support::Uniform;

constexpr std::int64_t steps = 300;

template <class T>
using Member = Setup<RigidBody<T>>;

/// Slow and fast ones side by side, which need different numbers of turns, and three that fail.
template <class T>
std::vector<Member<T>> members_of_all_kinds(std::size_t count, bool attitude) {
  Uniform uniform(20240817);
  auto cases = generic_bodies();
  for (auto const& c : special_bodies()) cases.push_back(c);
  std::vector<Member<T>> members;
  for (std::size_t i = 0; i < count; ++i) {
    auto c = cases[i % cases.size()];
    double const pace = i < 2 * cases.size() ? 1 : uniform(0.01, 2);
    for (double& y : c.momentum) y *= pace;
    if (i >= cases.size())
      for (double& inertia : c.inertia) inertia *= uniform(0.95, 1.05);
    members.push_back({c.body<T>(), T(0.05), c.start<T>(), attitude});
  }
  members[1].step = T(50);
  members[4].start.momentum[2] = std::numeric_limits<T>::quiet_NaN();
  members[7].start.momentum[0] = std::numeric_limits<T>::infinity();
  return members;
}

/// N members in the lanes of one pack; the last one again where there are no more.
template <class P, class T>
Member<P> packed(std::vector<Member<T>> const& members, std::size_t first) {
  auto const lanes_of = [&](auto of_member) {
    return from_lanes<P>(
        [&](int l) { return of_member(members[std::min(first + static_cast<std::size_t>(l), members.size() - 1)]); });
  };
  Vector3<P> inertia;
  RigidBodyState<P> start;
  for (int j = 0; j < 3; ++j) {
    inertia[j] = lanes_of([&](auto const& m) { return m.system.inertia()[j]; });
    start.momentum[j] = lanes_of([&](auto const& m) { return m.start.momentum[j]; });
  }
  for (int j = 0; j < 4; ++j)
    start.attitude.coeffs()[j] = lanes_of([&](auto const& m) { return m.start.attitude.coeffs()[j]; });
  return {RigidBody<P>(inertia), lanes_of([](auto const& m) { return m.step; }), start, members[0].whole_state};
}

template <class T>
using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;

/// The bits of a state's components (and residues) in lane l; every NaN counts as one.
template <class State>
void append_bits(State const& s, int l, std::vector<std::uint64_t>& bits) {
  for_components(
      [&](auto const& c) {
        using T = Element<std::remove_cvref_t<decltype(c)>>;
        T const v = lane(c, l);
        bits.push_back(std::isnan(v) ? ~std::uint64_t{0} : std::bit_cast<Bits<T>>(v));
      },
      s);
}
template <class State>
void append_bits(Compensated<State> const& s, int l, std::vector<std::uint64_t>& bits) {
  append_bits(s.value, l, bits);
  append_bits(s.residue, l, bits);
}

/// Member by member, what it has come to.
using Outcome = std::vector<std::vector<std::uint64_t>>;

/// Y makes the kind of state that is advanced, plain or compensated, from a start.
template <class S, template <class> class Y, class T>
Outcome alone(std::vector<Member<T>> const& members) {
  Outcome outcome;
  for (auto const& m : members) {
    Y<RigidBodyState<T>> y(m.start);
    advance(S(m), y, steps);
    append_bits(y, 0, outcome.emplace_back());
  }
  return outcome;
}

template <class S, template <class> class Y, class T>
Outcome in_blocks_of(std::size_t packs, std::vector<Member<T>> const& members) {
  using P = typename S::Scalar;
  constexpr auto in_pack = static_cast<std::size_t>(lanes<P>);
  Outcome outcome;
  for (std::size_t first = 0; first < members.size(); first += packs * in_pack) {
    std::vector<S> steppers;
    std::vector<Y<RigidBodyState<P>>> states;
    for (std::size_t p = 0; p < packs && first + p * in_pack < members.size(); ++p) {
      auto const m = packed<P>(members, first + p * in_pack);
      steppers.emplace_back(m);
      states.emplace_back(m.start);
    }
    advance_block(std::span<S const>(steppers), std::span(states), steps);
    for (auto const& y : states)
      for (int l = 0; l < lanes<P>; ++l) append_bits(y, l, outcome.emplace_back());
  }
  return outcome;
}

template <class S>
using Plain = S;

template <class Family, template <class> class Y, class T, int N>
void expect_lanes_to_be(Outcome const& expected, std::vector<Member<T>> const& members) {
  using S = typename Family::template In<Pack<T, N>>;
  for (std::size_t packs : {1U, 3U, 8U}) {
    auto const outcome = in_blocks_of<S, Y>(packs, members);
    ASSERT_EQ(outcome.size() % N, 0U);
    ASSERT_GE(outcome.size(), members.size());
    for (std::size_t i = 0; i < outcome.size(); ++i)
      EXPECT_EQ(outcome[i], expected[std::min(i, members.size() - 1)])
          << "member " << i << ", packs of " << N << ", blocks of " << packs;
  }
}

template <class Family, template <class> class Y, class T, int... N>
void expect_lanes_to_be_scalar_runs(bool attitude) {
  auto const members = members_of_all_kinds<T>(59, attitude);
  auto const expected = alone<typename Family::template In<T>, Y>(members);
  (expect_lanes_to_be<Family, Y, T, N>(expected, members), ...);
}

template <class Family>
struct StepperInLanes : testing::Test {};
TYPED_TEST_SUITE(StepperInLanes, testing_support::RigidBodySteppersInLanes);

TYPED_TEST(StepperInLanes, LanesOfAPackEqualTheScalarRunBitForBit) {
  for (bool attitude : {true, false}) {
    expect_lanes_to_be_scalar_runs<TypeParam, Plain, double, 2, 4, 8>(attitude);
    expect_lanes_to_be_scalar_runs<TypeParam, Plain, float, 4, 8>(attitude);
    if constexpr (IncrementStep<typename TypeParam::template In<double>>) {
      expect_lanes_to_be_scalar_runs<TypeParam, Compensated, double, 2, 4, 8>(attitude);
      expect_lanes_to_be_scalar_runs<TypeParam, Compensated, float, 4, 8>(attitude);
    }
  }
}

TYPED_TEST(StepperInLanes,
           NeighboursNeedDifferentNumbersOfTurnsAndSomeOfThemFail) {  // so that the above means something
  using S = typename TypeParam::template In<double>;
  auto const members = members_of_all_kinds<double>(59, true);
  int failed = 0;
  std::set<int> turns;
  for (auto const& m : members) {
    S const step(m);
    auto y = m.start;
    advance(step, y, steps);
    if (std::isnan(y.momentum[0])) ++failed;
    if constexpr (IterativeStep<S>) turns.insert(step.blind_turns());
  }
  EXPECT_GE(failed, 2);  // no number at the start; for the iteration also a step that is too large
  if constexpr (IterativeStep<S>) {
    // three perturbed bodies have I₂ > I₃, which only what is made from the elliptic solution minds
    EXPECT_GE(failed, 3);
    EXPECT_LE(failed, 6);
    EXPECT_GE(turns.size(), 5U);
  }
}

}  // namespace
}  // namespace brouwer
