// A stepper that is a template over where it takes its modified coefficients from becomes one entry of the catalogue,
// and the two ways are two different runs.
#include <brouwer/ensemble/method.hpp>
#include <brouwer/ensemble/run.hpp>
#include <brouwer/ensemble/start.hpp>
#include <brouwer/error.hpp>
#include <brouwer/systems/rigid_body.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <type_traits>

#include "tests/ensemble/small_study.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;
using testing_support::small_study;

/// Euler's method with the modified step h·σ, σ = 1 + h|y|²: no good method, but its σ grows with |y|, which it does
/// not conserve, so that both ways to take σ differ from the second step on.
template <Real T, class Coefficients>
class ModifiedEuler {
 public:
  using Scalar = T;
  using System = RigidBody<T>;
  using State = RigidBodyState<T>;
  static constexpr int order = 1;

  explicit ModifiedEuler(Setup<System> const& setup)
      : body_(setup.system), h_(setup.step), sigma_(coefficient(setup.start)) {}

  State increment(State const& s) const {
    T const step = h_ * (std::is_same_v<Coefficients, PerStep> ? coefficient(s) : sigma_);
    Vector3<T> const rate = body_.momentum_rate(s.momentum);
    return {{step * rate[0], step * rate[1], step * rate[2]}, {T(0), T(0), T(0), T(0)}};
  }

 private:
  T coefficient(State const& s) const { return T(1) + h_ * squared_norm(s.momentum); }

  System body_;
  T h_, sigma_;
};

Catalogue const& catalogue() {
  static Catalogue const with_euler = [] {
    auto all = builtin_catalogue();
    all.methods.push_back(method_with_coefficients<ModifiedEuler>({"modified-euler", "rigid_body", "", "this test"}));
    return all;
  }();
  return with_euler;
}

CellLabels cell_with(std::string const& coefficients) {
  return {"rigid_body", "modified-euler", "double", "-", coefficients, false, 0.05, 2};
}

double momentum_after(int steps, std::string const& coefficients) {
  auto const start = nominal_start(small_study(), catalogue().system("rigid_body"));
  auto const trajectory = begin_trajectory(catalogue(), cell_with(coefficients), start, true);
  trajectory->advance(steps);
  std::vector<Widest> state(7);
  trajectory->state(0, state);
  return static_cast<double>(state[0]);
}

TEST(Coefficients, AreAnOptionOfTheMethod) {
  EXPECT_THAT(catalogue().method("rigid_body", "modified-euler").coefficients,
              ElementsAre("per-step", "per-trajectory"));
  EXPECT_THAT(catalogue().method("rigid_body", "dmv-2").coefficients, IsEmpty());
}

TEST(Coefficients, AreTakenFromTheCurrentStateOrFromTheStart) {
  EXPECT_EQ(momentum_after(1, "per-step"), momentum_after(1, "per-trajectory"));
  EXPECT_NE(momentum_after(2, "per-step"), momentum_after(2, "per-trajectory"));
}

TEST(Coefficients, MustBeOfAKnownLevel) {
  EXPECT_THAT([] { momentum_after(1, "-"); }, ThrowsMessage<InputError>(HasSubstr("and coefficients '-'")));
}

TEST(Coefficients, AreThoseOfTheCellInAMemberAndInItsReference) {
  auto study = small_study();
  study.methods = {"modified-euler"};
  study.coefficients = {"per-step", "per-trajectory"};
  study.compensation = {false};
  study.quantities = {"state"};
  study.reference = {Reference::Kind::same_method, "float128", 4};
  auto const plan = make_plan(study, catalogue());
  ASSERT_EQ(plan.cells.size(), 2U);
  Progress progress;
  std::vector<std::vector<double>> ends;
  for (auto const& unit : plan.units) {
    if (unit.first_member > 0) continue;
    auto const record = compute_unit(study, catalogue(), plan, unit, "hash", progress, nullptr).record;
    EXPECT_EQ(record.cell, plan.cells[unit.cell]);
    ends.push_back(record.final_state);
    for (auto const& series : record.series)  // round-off alone: a reference of the other level would be far away
      for (double e : series.errors) EXPECT_LT(std::abs(e), 1e-10) << record.cell.coefficients << ' ' << series.name;
  }
  EXPECT_NE(ends.at(0), ends.at(1));
}

}  // namespace
}  // namespace brouwer
