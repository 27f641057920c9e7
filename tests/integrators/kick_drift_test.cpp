// Sequences of kicks and drifts: what they are made of, and what they cost.
#include <brouwer/integrators/kick_drift.hpp>
#include <brouwer/systems/henon_heiles.hpp>

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Judge;

/// Hénon–Heiles that counts how often it is asked.
struct Counting : HenonHeiles<double> {
  template <class U>
  using In = HenonHeiles<U>;
  int* forces;
  int* velocities;

  explicit Counting(std::span<double const>) : forces(nullptr), velocities(nullptr) {}
  Counting(int& f, int& v) : forces(&f), velocities(&v) {}
  template <std::same_as<double>>
  Counting in() const {
    return *this;
  }
  Part force(Part const& q) const {
    ++*forces;
    return HenonHeiles<double>::force(q);
  }
  Part velocity(Part const& p) const {
    ++*velocities;
    return HenonHeiles<double>::velocity(p);
  }
};

PhaseState<double, 2> start() { return {{0.125, 0.25}, {0.375, 0.125}}; }

KickDriftMethod const& named(std::string const& name) {
  for (auto const& m : kick_drift_methods())
    if (m.name == name) return m;
  throw std::invalid_argument(name);
}

/// Forces and velocities in a step.
std::pair<int, int> cost(KickDriftMethod const& method) {
  int forces = 0, velocities = 0;
  KickDrift<Counting>({Counting(forces, velocities), 0.1, start()}, method).increment(start());
  return {forces, velocities};
}

TEST(KickDrift, TakesOneForceAStageAndOneMoreBecauseAdjacentKicksAreOne) {
  for (auto const& m : kick_drift_methods()) {
    int const stages = m.composition->stages();
    if (m.base == KickDriftMethod::Base::kick_drift_kick) {
      EXPECT_EQ(cost(m), std::pair(stages + 1, stages)) << m.name;
    }
  }
  EXPECT_EQ(cost(named("position-verlet")), std::pair(1, 2));
  EXPECT_EQ(cost(named("symplectic-euler-kick-drift")), std::pair(1, 1));
  EXPECT_EQ(cost(named("symplectic-euler-drift-kick")), std::pair(1, 1));
}

TEST(KickDrift, KicksAndDriftsAddUpToTheStepAndArePalindromicInSymmetricMethods) {
  for (auto const& m : kick_drift_methods()) {
    auto const lengths = kicks_and_drifts<Judge>(m);
    Judge of_first = 0, of_second = 0;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      (i % 2 == 0 ? of_first : of_second) += lengths[i];
      if (m.symmetric()) {
        EXPECT_EQ(lengths[i], lengths[lengths.size() - 1 - i]) << m.name;
      }
    }
    EXPECT_LT(abs(Judge(of_first - 1)), Judge("1e-75")) << m.name;
    EXPECT_LT(abs(Judge(of_second - 1)), Judge("1e-75")) << m.name;
  }
}

/// By hand, in exact arithmetic: with h = 1/4 and the start's few bits 77 digits hold everything.
TEST(KickDrift, IsWhatItsNameSays) {
  HenonHeiles<Judge> const system;
  PhaseState<Judge, 2> const y{{Judge(1) / 8, Judge(1) / 4}, {Judge(3) / 8, Judge(1) / 8}};
  Judge const h = Judge(1) / 4;
  auto const kick = [&](auto s, Judge const& by) {
    auto const f = system.force(s.q);
    for (std::size_t i = 0; i < 2; ++i) s.p[i] += by * f[i];
    return s;
  };
  auto const drift = [&](auto s, Judge const& by) {
    for (std::size_t i = 0; i < 2; ++i) s.q[i] += by * s.p[i];
    return s;
  };
  auto const step = [&](char const* name) {
    return sum(y, KickDrift<HenonHeiles<Judge>>({system, h, y}, named(name)).increment(y));
  };
  auto const expect_same = [](auto const& a, auto const& b) {
    EXPECT_EQ(a.q, b.q);
    EXPECT_EQ(a.p, b.p);
  };
  expect_same(step("symplectic-euler-kick-drift"), drift(kick(y, h), h));
  expect_same(step("symplectic-euler-drift-kick"), kick(drift(y, h), h));
  expect_same(step("stoermer-verlet"), kick(drift(kick(y, h / 2), h), h / 2));
  expect_same(step("position-verlet"), drift(kick(drift(y, h / 2), h), h / 2));
}

TEST(KickDriftMethods, HaveNamesOfTheirOwnAndSources) {
  std::set<std::string> names;
  for (auto const& m : kick_drift_methods()) {
    names.insert(m.name);
    EXPECT_FALSE(std::string(m.source).empty());
    EXPECT_FALSE(std::string(m.summary).empty());
  }
  EXPECT_EQ(names.size(), kick_drift_methods().size());
}

}  // namespace
}  // namespace brouwer
