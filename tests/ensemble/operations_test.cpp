// Factors of operations: what exists, what a study says of them, and what becomes of members.
#include <brouwer/ensemble/operations.hpp>
#include <brouwer/ensemble/reference.hpp>
#include <brouwer/ensemble/run.hpp>
#include <brouwer/ensemble/start.hpp>
#include <brouwer/error.hpp>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "tests/ensemble/small_study.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;
using testing_support::levels_or_none;
using testing_support::small_study;
using testing_support::standard_study;

Catalogue const& catalogue() {
  static Catalogue const all = builtin_catalogue();
  return all;
}

CellLabels first_cell(Study const& study) { return make_plan(study, catalogue()).cells.at(0); }

std::vector<double> states_of(Trajectories const& all, CellLabels const& cell) {
  std::vector<double> states;
  std::vector<Widest> state(catalogue().system(cell.system).state_components.size());
  for (std::size_t i = 0; i < all.members(); ++i) {
    all.state(i, state);
    for (auto const& component : state) states.push_back(static_cast<double>(component));
  }
  return states;
}

std::vector<double> final_states(CellLabels const& cell, std::vector<Start> const& starts, RandomStreams const& streams,
                                 std::vector<std::int64_t> const& strides) {
  auto const all = begin_trajectories(catalogue(), cell, starts, true, widest_instruction_set(), streams);
  for (std::int64_t const steps : strides) all->advance(steps);
  return states_of(*all, cell);
}

TEST(FactorsOfOperations, AreCrossedLikeOthersAndLeaveStandardStudiesAsTheyWere) {
  auto study = small_study();
  auto const text = canonical_text(study);
  EXPECT_THAT(text, testing::Not(HasSubstr("rounding")));
  auto const before = make_plan(study, catalogue()).cells.size();
  study.rounding = {"nearest", "up", "stochastic"};
  study.constants = {"rounded", "exact"};
  study.contraction = {false, true};
  EXPECT_EQ(make_plan(study, catalogue()).cells.size(), 12 * before);
  EXPECT_THAT(canonical_text(study), HasSubstr("rounding = nearest, up, stochastic\nconstants = rounded, exact\n"
                                               "contraction = false, true\n"));
}

TEST(FactorsOfOperations, ExistWhereOperationsPassThroughTheScalar) {
  auto study = small_study();
  study.compensation = {false};
  study.rounding = {"nearest", "up"};
  study.arithmetics = {"double", "long-double"};
  study.methods = {"elliptic-naive", "dmv-matrix"};
  study.special_functions = {"own", "gsl"};
  std::set<std::string> reasons;
  for (auto const& skipped : make_plan(study, catalogue()).skipped)
    if (skipped.cell.rounding == "up") reasons.insert(skipped.reason);
  EXPECT_THAT(reasons, testing::Contains(
                           HasSubstr("a step with rounding up exists in float and double only, not in long-double")));
  EXPECT_THAT(reasons, testing::Contains(HasSubstr("does not reach into the 'gsl' elliptic functions")));
  EXPECT_THAT(reasons, testing::Contains(HasSubstr("dmv-matrix computes in part by libraries")));
}

TEST(FactorsOfOperations, AreRefusedByNameWhereThereIsNoSuchLevel) {
  auto study = small_study();
  study.rounding = {"upp"};
  EXPECT_THAT([&] { make_plan(study, catalogue()); },
              testing::ThrowsMessage<InputError>(HasSubstr("there is no rounding 'upp'; did you mean 'up'?")));
}

TEST(FactorsOfOperations, AreTheProcessorsInAReference) {
  CellLabels cell = first_cell(small_study());
  cell.rounding = "up";
  cell.constants = "exact";
  cell.contraction = true;
  EXPECT_TRUE(operation_rule(reference_cell(cell, "float128")).standard());
}

/// After 50 steps with another rounding nothing but last digits has changed.
void expect_other_last_digits(CellLabels const& cell, std::vector<Start> const& start) {
  auto const standard = final_states(with_standard_operations(cell), start, {}, {50});
  auto const other = final_states(cell, start, {}, {50});
  std::string const what = fmt::format("{} {} {}", cell.system, cell.method, cell.rounding);
  EXPECT_NE(other, standard) << what;
  for (std::size_t c = 0; c < standard.size(); ++c)
    EXPECT_NEAR(other[c], standard[c], 1e-11 * (1 + std::abs(standard[c]))) << what;
}

/// h at which no method fails in 1000 steps.
double small_step(std::string const& system) {
  static std::map<std::string, double> const own = {
      {"outer_solar_system", 10}, {"kepler", 0.005}, {"double_well", 0.01}, {"henon_heiles", 0.02}};
  return own.contains(system) ? own.at(system) : 0.05;
}

/// Do fused products change a bit in 1000 steps? Where a sum is much larger than they are it takes some.
bool fused_products_show(CellLabels cell, std::vector<Start> const& start) {
  auto const begin = [&] { return begin_trajectories(catalogue(), cell, start, true, InstructionSet::none); };
  auto const separate = begin();
  cell.contraction = true;
  auto const fused = begin();
  for (int i = 0; i < 40; ++i) {
    separate->advance(25);
    fused->advance(25);
    auto const states = states_of(*separate, cell);
    for (double const component : states) EXPECT_TRUE(std::isfinite(component)) << cell.system << ' ' << cell.method;
    if (states_of(*fused, cell) != states) return true;
  }
  return false;
}

/// A pendulum's force is a sine, whose fused products seldom change its last digit; these methods add hk or hk/2 to the
/// state, where there is nothing else to fuse (gauss-4: little). Within some thousand steps they show it, or not.
bool fuses_much(MethodEntry const& method) {
  static std::set<std::string> const little = {"symplectic-euler-kick-drift",
                                               "symplectic-euler-drift-kick",
                                               "explicit-euler",
                                               "runge-2",
                                               "implicit-euler",
                                               "gauss-2",
                                               "gauss-4"};
  return method.system != "pendulum" || !little.contains(method.name);
}

/// Every method that runs in lanes has each of them. (Constants may be exact as they are.)
TEST(FactorsOfOperations, ChangeTheBitsOfEveryMethod) {
  for (auto const& method : catalogue().methods) {
    if (!method.runs_in_lanes) continue;
    auto const& system = catalogue().system(method.system);
    auto study = standard_study(system);
    for (auto const& field : system.fields)
      if (!field.parameter) study.perturb[field.name] = {Perturbation::Law::uniform, 0.03};
    auto const start = member_starts(study, system, "double", 0, 6);
    CellLabels cell{method.system,
                    method.name,
                    "double",
                    method.uses_special_functions ? "own" : no_level,
                    levels_or_none(method.coefficients).front(),
                    false,
                    small_step(method.system),
                    1000};
    EXPECT_TRUE(!fuses_much(method) || fused_products_show(cell, start)) << method.system << ' ' << method.name;
    for (auto const* rounding : {"up", "down", "toward-zero", "stochastic"}) {
      cell.rounding = rounding;
      expect_other_last_digits(cell, {start[0], start[1]});
    }
  }
}

struct StochasticMembers : testing::Test {
  Study study = small_study();
  CellLabels cell;
  std::vector<Start> starts;
  void SetUp() override {
    study.methods = {"dmv-2"};
    study.rounding = {"stochastic"};
    cell = first_cell(study);
    starts = member_starts(study, catalogue().system("rigid_body"), "double", 0, 12);
  }
};

TEST_F(StochasticMembers, DependOnSeedAndNumberAlone) {
  auto const all = final_states(cell, starts, {7, 0}, {200});
  EXPECT_EQ(final_states(cell, starts, {7, 0}, {1, 63, 100, 36}), all);
  std::vector<Start> const last(starts.begin() + 8, starts.end());
  auto const apart = final_states(cell, last, {7, 8}, {200});
  EXPECT_TRUE(std::equal(apart.begin(), apart.end(), all.end() - static_cast<std::ptrdiff_t>(apart.size())));
  EXPECT_NE(final_states(cell, starts, {8, 0}, {200}), all);
  EXPECT_NE(final_states(cell, last, {7, 0}, {200}), apart);
}

TEST_F(StochasticMembers, WalkAgainWithTheSameNumbersToSeeWhereTheyFailed) {
  starts[3].state = {400, -300, 200, 1, 0, 0, 0};  // too fast for this step
  auto const all = begin_trajectories(catalogue(), cell, starts, true, InstructionSet::none, {7, 0});
  auto const again = begin_trajectories(catalogue(), cell, starts, true, InstructionSet::none, {7, 0});
  all->advance(40);
  for (int i = 0; i < 40; ++i) again->advance(1);
  ASSERT_TRUE(all->failure(3).has_value());
  EXPECT_EQ(all->failure(3)->step, again->failure(3)->step);
  EXPECT_FALSE(all->failure(2).has_value());
}

/// Drift and its standard error of the energy after `steps` steps, per step.
struct Drift {
  double mean, error;
};
Drift energy_drift(Study const& study, std::string const& rounding, std::string const& constants) {
  auto chosen = study;
  chosen.rounding = {rounding};
  chosen.constants = {constants};
  auto const cell = first_cell(chosen);
  auto const& system = catalogue().system(study.system);
  auto const starts = member_starts(chosen, system, "double", 0, study.members);
  auto const all = begin_trajectories(catalogue(), cell, starts, false, widest_instruction_set(), {study.seed, 0});
  all->advance(cell.steps);
  std::size_t const integrals = system.count(Quantity::Kind::integral);
  std::vector<double> errors(integrals * starts.size());
  all->first_integral_errors(errors);
  auto const members = static_cast<double>(starts.size()), steps = static_cast<double>(cell.steps);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < starts.size(); ++i) sum += errors[i * integrals];
  for (std::size_t i = 0; i < starts.size(); ++i) squares += std::pow(errors[i * integrals] - sum / members, 2);
  return {sum / members / steps, std::sqrt(squares / (members - 1) / members) / steps};
}

Study small_drift_study(char const* method) {
  auto study = small_study();
  study.methods = {method};
  study.compensation = {false};
  study.step = {0.01};
  study.steps = 4000;
  study.members = 64;
  return study;
}

/// Without bias in the operations the textbook's constants drift where they are rounded (−4.6·10⁻¹⁷ per step, t = −109
/// with 128 members) and do not where they are exact. Rounded to nearest they drift both ways (−2.3 and −3.3·10⁻¹⁷): what
/// is nearly the same in every step (a₁, a₂, k, u̇h) is also rounded the same way in every step.
TEST(CauseOfADrift, IsTheRoundedConstantsOfTheTextbook) {
  auto const study = small_drift_study("elliptic-naive");
  auto const rounded = energy_drift(study, "stochastic", "rounded"), exact = energy_drift(study, "stochastic", "exact");
  EXPECT_LT(rounded.mean, -20 * rounded.error);
  EXPECT_LT(std::abs(exact.mean), 4 * exact.error);
  auto const frozen = energy_drift(study, "nearest", "exact");
  EXPECT_LT(frozen.mean, -7 * frozen.error);
}

/// Three consistent constants, which walk when rounded to nearest, drift where every operation errs one way: by
/// ±5.5·10⁻¹⁶ per step.
TEST(CauseOfADrift, IsTheRoundingAlsoWithConsistentConstants) {
  auto const study = small_drift_study("elliptic-three-constants");
  auto const up = energy_drift(study, "up", "rounded"), down = energy_drift(study, "down", "rounded");
  EXPECT_NEAR(up.mean, 5.5e-16, 2e-17);
  EXPECT_NEAR(up.mean / -down.mean, 1, 0.02);
  for (auto const* unbiased : {"nearest", "stochastic"}) {
    auto const walk = energy_drift(study, unbiased, "rounded");
    EXPECT_LT(std::abs(walk.mean), 4 * walk.error) << unbiased;
  }
}

/// Rounding up and down drift by as much in opposite directions (±1.0·10⁻¹⁶ per step), cutting off loses energy.
TEST(CauseOfADrift, IsTheRoundingWhereItIsBiased) {
  auto const study = small_drift_study("elliptic-increment");
  auto const up = energy_drift(study, "up", "rounded"), down = energy_drift(study, "down", "rounded");
  EXPECT_GT(up.mean, 5e-17);
  EXPECT_NEAR(up.mean, -down.mean, 5 * (up.error + down.error));
  EXPECT_LT(energy_drift(study, "toward-zero", "rounded").mean, down.mean);
  auto const walk = energy_drift(study, "stochastic", "rounded");
  EXPECT_LT(std::abs(walk.mean), 4 * walk.error);
}

}  // namespace
}  // namespace brouwer
