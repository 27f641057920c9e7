// Methods for any system: a member's result is the same bits alone, in a lane of a pack, and in a block of packs.
#include <brouwer/scalar/double_double.hpp>
#include <brouwer/scalar/pack.hpp>

#include <gtest/gtest.h>

#include <set>

#include "tests/contracts/field_methods.hpp"
#include "tests/contracts/field_systems.hpp"
#include "tests/lanes.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::field_methods;
using testing_support::FieldMethod;
using testing_support::Geodesics;
using testing_support::identifier;
using testing_support::same_bits;
using testing_support::Uniform;
using testing_support::with_method;

constexpr std::int64_t steps = 8;
constexpr std::size_t member_count = 37;

/// A member by its numbers.
struct Member {
  std::vector<double> parameters, state;
  double step;
};

/// Slow and fast ones side by side, which need different numbers of turns, and three that fail.
std::vector<Member> members_of_all_kinds() {
  Uniform uniform(20240817);
  std::vector<Member> members;
  for (std::size_t i = 0; i < member_count; ++i) {
    double const size = i % 5 == 0 ? 1e-3 : uniform(0.1, 1);
    Member m{{uniform(0.2, 1)}, {}, i % 3 == 0 ? 0.3 : 0.05};
    for (int c = 0; c < 4; ++c) m.state.push_back(size * uniform(-0.7, 0.7));
    members.push_back(m);
  }
  members[2].state = {0, 0, 0, 0};  // at rest
  members[4].step = 1e20;
  members[9].state[1] = std::numeric_limits<double>::quiet_NaN();
  members[17].state = {1e30, -1e30, 1e30, 1e30};
  return members;
}

/// N members in the lanes of one pack; the last one again where there are no more.
template <class System>
Setup<System> packed(std::vector<Member> const& members, std::size_t first) {
  using P = typename System::Scalar;
  auto const gathered = [&](auto number_of) {
    return from_lanes<P>([&](int l) {
      return Element<P>(number_of(members[std::min(first + static_cast<std::size_t>(l), members.size() - 1)]));
    });
  };
  std::vector<P> state;
  for (std::size_t c = 0; c < 4; ++c) state.push_back(gathered([c](Member const& m) { return m.state[c]; }));
  std::array<P, 1> const parameters{gathered([](Member const& m) { return m.parameters[0]; })};
  return {System(std::span<P const>(parameters)), gathered([](Member const& m) { return m.step; }),
          System::State::from_components(state)};
}

/// The components of a state (and its residues) in lane l.
template <State S>
void append(S const& s, int l, std::vector<Element<typename S::Scalar>>& numbers) {
  for_components([&](auto const& c) { numbers.push_back(lane(c, l)); }, s);
}
template <class S>
void append(Compensated<S> const& s, int l, std::vector<Element<typename S::Scalar>>& numbers) {
  append(s.value, l, numbers);
  append(s.residue, l, numbers);
}

/// Member by member, what it has come to, and in how many turns.
template <class E>
using Outcome = std::vector<std::vector<E>>;

/// In blocks of so many packs; Y makes the kind of state that is advanced, plain or compensated, from a start.
template <class System, template <class> class Y>
Outcome<Element<typename System::Scalar>> outcome_of(FieldMethod const& method, std::vector<Member> const& members,
                                                     std::size_t packs) {
  using P = typename System::Scalar;
  constexpr auto in_pack = static_cast<std::size_t>(lanes<P>);
  Outcome<Element<P>> outcome;
  with_method<System>(method, [&](auto make) {
    using S = decltype(make(packed<System>(members, 0)));
    for (std::size_t first = 0; first < members.size(); first += packs * in_pack) {
      std::vector<S> steppers;
      std::vector<Y<typename System::State>> states;
      for (std::size_t p = 0; p < packs && first + p * in_pack < members.size(); ++p) {
        auto const setup = packed<System>(members, first + p * in_pack);
        steppers.push_back(make(setup));
        states.emplace_back(setup.start);
      }
      auto counted = states;
      advance_block(std::span<S const>(steppers), std::span(states), steps);
      for (std::size_t p = 0; p < states.size(); ++p) {
        P turns(0);
        if constexpr (CountsIterations<S>) advance(steppers[p], counted[p], steps, turns);
        for (int l = 0; l < lanes<P>; ++l) {
          append(states[p], l, outcome.emplace_back());
          outcome.back().push_back(lane(turns, l));
        }
      }
    }
  });
  return outcome;
}

template <class E>
bool same(E const& a, E const& b) {
  return same_bits(a, b);
}
template <class E>
bool same(DoubleDouble<E> const& a, DoubleDouble<E> const& b) {
  return same_bits(a.high(), b.high()) && same_bits(a.low(), b.low());
}

template <class System, template <class> class Y, class Alone>
void expect_lanes_to_be(Alone const& alone, FieldMethod const& method, std::vector<Member> const& members,
                        std::initializer_list<std::size_t> blocks) {
  for (std::size_t packs : blocks) {
    auto const outcome = outcome_of<System, Y>(method, members, packs);
    ASSERT_GE(outcome.size(), members.size());
    for (std::size_t i = 0; i < outcome.size(); ++i) {
      auto const& expected = alone[std::min(i, members.size() - 1)];
      ASSERT_EQ(outcome[i].size(), expected.size());
      for (std::size_t c = 0; c < expected.size(); ++c)
        EXPECT_TRUE(same(outcome[i][c], expected[c])) << "member " << i << ", number " << c << ", packs of "
                                                      << lanes<typename System::Scalar> << ", blocks of " << packs;
    }
  }
}

template <class S>
using Plain = S;

/// Numbers T in packs of them, plainly and with compensation.
template <template <class> class System, class T, class... Packs>
void expect_lanes_to_be_scalar_runs(FieldMethod const& method) {
  auto const members = members_of_all_kinds();
  auto const plain = outcome_of<System<T>, Plain>(method, members, 1);
  auto const compensated = outcome_of<System<T>, Compensated>(method, members, 1);
  (expect_lanes_to_be<System<Packs>, Plain>(plain, method, members, {1, 3}), ...);
  (expect_lanes_to_be<System<Packs>, Compensated>(compensated, method, members, {2}), ...);
}

struct AFieldMethodInLanes : testing::TestWithParam<FieldMethod> {};
INSTANTIATE_TEST_SUITE_P(Of, AFieldMethodInLanes, testing::ValuesIn(field_methods()),
                         [](auto const& one) { return identifier(one.param.name); });

TEST_P(AFieldMethodInLanes, LanesOfAPackEqualTheScalarRunBitForBit) {
  expect_lanes_to_be_scalar_runs<HenonHeiles, double, Pack<double, 4>, Pack<double, 16>>(GetParam());
  expect_lanes_to_be_scalar_runs<HenonHeiles, float, Pack<float, 8>>(GetParam());
  if (GetParam().for_separable_only()) return;
  expect_lanes_to_be_scalar_runs<Geodesics, double, Pack<double, 8>>(GetParam());
  expect_lanes_to_be_scalar_runs<Geodesics, float, Pack<float, 16>>(GetParam());
}

TEST_P(AFieldMethodInLanes, LanesOfDoubleDoublesEqualTheScalarRunBitForBit) {
  using P = DoubleDouble<Pack<double, 8>>;
  expect_lanes_to_be_scalar_runs<HenonHeiles, DoubleDouble<double>, P>(GetParam());
}

TEST_P(AFieldMethodInLanes,
       NeighboursNeedDifferentNumbersOfTurnsAndSomeOfThemFail) {  // so that the above means something
  auto const outcome = outcome_of<HenonHeiles<double>, Plain>(GetParam(), members_of_all_kinds(), 1);
  int failed = 0;
  std::set<double> turns;
  for (auto const& numbers : outcome) {
    failed += std::isfinite(numbers[0]) ? 0 : 1;
    turns.insert(numbers.back());
  }
  EXPECT_GE(failed, 3);
  if (GetParam().iterates()) {
    EXPECT_GE(turns.size(), 5U);
  }
}

}  // namespace
}  // namespace brouwer
