// A member without a next state is marked with the step and the reason, and the others go on.
#include <brouwer/ensemble/run.hpp>
#include <brouwer/ensemble/start.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/ensemble/small_study.hpp"

namespace brouwer {
namespace {

using testing_support::small_study;
using testing_support::standard_study;

Catalogue const& catalogue() {
  static Catalogue const all = builtin_catalogue();
  return all;
}

/// Starts of the double well at these places, at rest.
std::vector<Start> wells(std::vector<double> const& positions) {
  std::vector<Start> starts;
  for (double q : positions) starts.push_back({{}, {q, 0}});
  return starts;
}

CellLabels cell(std::string const& method, double h, std::string const& coefficients = no_level) {
  return {"double_well", method, "double", no_level, coefficients, false, h, 0};
}

std::unique_ptr<Trajectories> begin(CellLabels const& c, std::vector<Start> const& starts, InstructionSet widest) {
  return begin_trajectories(catalogue(), c, starts, true, widest);
}

/// How many steps can be made one by one until the state is no number.
std::int64_t last_finite_step(CellLabels const& c, Start const& start) {
  auto const alone = begin(c, {start}, InstructionSet::none);
  std::vector<Widest> state(2);
  for (std::int64_t step = 0; step < 1000; ++step) {
    alone->advance(1);
    alone->state(0, state);
    if (!std::isfinite(static_cast<double>(state[0] + state[1]))) return step;
  }
  return 1000;
}

TEST(Failures, NameTheLastStepWithAStateHoweverTheStepsAreCut) {
  auto const c = cell("explicit-euler", 0.1);
  auto const starts = wells({1.1, 5, 1.2, 40, 7});
  for (auto const set : {InstructionSet::none, widest_instruction_set()})
    for (std::int64_t const stride : {1, 7, 42}) {
      auto const all = begin(c, starts, set);
      for (std::int64_t done = 0; done < 42; done += stride) all->advance(stride);
      for (std::size_t i = 0; i < starts.size(); ++i) {
        bool const fails = starts[i].state[0] >= 5;
        ASSERT_EQ(all->failure(i).has_value(), fails) << i;
        if (!fails) continue;
        EXPECT_EQ(all->failure(i)->step, last_finite_step(c, starts[i])) << i << ", in strides of " << stride;
        EXPECT_EQ(all->failure(i)->reason, Failure::diverged) << i;
      }
    }
}

TEST(Failures, AreOfTheIterationWhereItDoesNotConverge) {
  auto const all = begin(cell("gauss-8", 0.3, "split"), wells({1.1, 9}), InstructionSet::none);
  all->advance(5);
  EXPECT_FALSE(all->failure(0));
  ASSERT_TRUE(all->failure(1));
  EXPECT_THAT(all->failure(1)->reason, testing::AnyOf(Failure::no_convergence, Failure::diverged));
  EXPECT_EQ(all->failure(1)->step, 0);
}

TEST(Failures, OfTheDiscreteMoserVeselovAlgorithmAreOfItsIteration) {
  auto study = small_study();
  auto const start = nominal_start(study, catalogue().system("rigid_body"));
  CellLabels const large{"rigid_body", "dmv-2", "double", no_level, no_level, false, 50, 0};
  auto const all = begin_trajectory(catalogue(), large, start, true);
  all->advance(3);
  ASSERT_TRUE(all->failure(0));
  EXPECT_EQ(all->failure(0)->reason, Failure::no_convergence);
}

TEST(Failures, OfAStartThatIsNoNumberAreAtStepZero) {
  auto const all = begin(cell("stoermer-verlet", 0.1), wells({NAN, 1.1}), widest_instruction_set());
  all->advance(5);
  ASSERT_TRUE(all->failure(0));
  EXPECT_EQ(all->failure(0)->step, 0);
  EXPECT_EQ(all->failure(0)->reason, Failure::not_finite);
  EXPECT_FALSE(all->failure(1));
}

Study study_of_wells() {
  auto study = standard_study(catalogue().system("double_well"));
  study.methods = {"explicit-euler"};
  study.arithmetics = {"double"};
  study.compensation = {false};
  study.special_functions = {"own"};
  study.step = {0.1};
  study.steps = 60;
  study.members = 16;
  study.perturb = {{"position", {Perturbation::Law::uniform, 1.4}}};
  study.quantities = {"energy"};
  study.samples = {6, Samples::Spacing::linear};
  return study;
}

UnitRecord first_unit(Study const& study) {
  auto const plan = make_plan(study, catalogue());
  Progress progress;
  return compute_unit(study, catalogue(), plan, plan.units.front(), "hash", progress, nullptr).record;
}

TEST(Failures, AreInTheRecordAndNoSampleAfterThemIsANumber) {
  auto const record = first_unit(study_of_wells());
  int failed = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    bool const fails = record.failed_at[i] >= 0;
    EXPECT_EQ(record.failure[i], fails ? "a step diverged" : "");
    for (std::size_t j = 0; j < 6; ++j) {
      bool const before = !fails || record.sample_steps[j] <= record.failed_at[i];
      EXPECT_EQ(std::isfinite(record.series[0].errors[i * 6 + j]), before) << i << ' ' << j;
    }
    failed += fails ? 1 : 0;
  }
  EXPECT_GT(failed, 2);
  EXPECT_LT(failed, 14);
}

TEST(Failures, OfAReferenceCostWhatIsComparedWithItAlone) {
  auto all = catalogue();
  auto& verlet = all.method("double_well", "stoermer-verlet");
  auto const makers = verlet.makers;
  verlet.makers = {{InstructionSet::none, [makers](TrajectoryRequest request) -> std::unique_ptr<Trajectories> {
                      if (request.arithmetic == "float128") request.starts[1].state[0] = NAN;
                      for (auto const& maker : makers)
                        if (maker.set == InstructionSet::none)
                          if (auto made = maker.begin(request)) return made;
                      return nullptr;
                    }}};
  auto study = study_of_wells();
  study.methods = {"stoermer-verlet"};
  study.perturb = {{"position", {Perturbation::Law::uniform, 0.1}}};
  study.quantities = {"energy", "phase"};
  study.reference = {Reference::Kind::same_method, "float128", 4};
  auto const plan = make_plan(study, all);
  Progress progress;
  auto const record = compute_unit(study, all, plan, plan.units.front(), "hash", progress, nullptr).record;
  EXPECT_TRUE(std::isfinite(record.series[0].errors[6 + 5])) << "the member's own energy";
  EXPECT_TRUE(std::isnan(record.series[1].errors[6 + 5])) << "its phase against the reference";
  EXPECT_TRUE(std::isfinite(record.series[1].errors[5]));
  EXPECT_EQ(record.failed_at[1], -1);
  EXPECT_THAT(record.failure[1], testing::StartsWith("its reference failed after step 0"));
  EXPECT_EQ(record.failure[0], "");
}

TEST(States, AreKeptWhereAStudyAsksForThem) {
  auto study = study_of_wells();
  study.methods = {"stoermer-verlet"};
  study.perturb = {{"position", {Perturbation::Law::uniform, 0.1}}};
  EXPECT_THAT(first_unit(study).states, testing::IsEmpty());
  auto const without = study_hash(study);
  study.states = true;
  EXPECT_NE(study_hash(study), without);
  auto const record = first_unit(study);
  ASSERT_EQ(record.states.size(), 16U * 6 * 2);
  for (std::size_t i = 0; i < 16; ++i)
    for (std::size_t c = 0; c < 2; ++c)
      EXPECT_EQ(record.states[(i * 6 + 5) * 2 + c], record.final_state[i * 2 + c]) << "the last sample is the end";
  auto const half = begin(cell("stoermer-verlet", 0.1), {member_start(study, catalogue().system("double_well"), 3)},
                          InstructionSet::none);
  half->advance(20);
  std::vector<Widest> state(2);
  half->state(0, state);
  EXPECT_EQ(record.states[(3 * 6 + 1) * 2], static_cast<double>(state[0]));
}

TEST(Iterations, AreTurnsPerStepAndAbsentWhereAMethodHasNone) {
  auto study = study_of_wells();
  study.methods = {"gauss-8", "stoermer-verlet"};
  study.perturb = {{"position", {Perturbation::Law::uniform, 0.1}}};
  study.quantities = {"iterations"};
  auto const plan = make_plan(study, catalogue());
  ASSERT_EQ(plan.cells.size(), 2U);
  Progress progress;
  auto const gauss = compute_unit(study, catalogue(), plan, plan.units[0], "hash", progress, nullptr).record;
  auto const verlet = compute_unit(study, catalogue(), plan, plan.units.back(), "hash", progress, nullptr).record;
  ASSERT_EQ(gauss.series.size(), 1U);
  EXPECT_TRUE(gauss.series[0].count);
  EXPECT_EQ(verlet.series[0].members, 0);
  auto const alone = begin(cell("gauss-8", 0.1, "standard"),
                           {member_start(study, catalogue().system("double_well"), 0)}, InstructionSet::none);
  alone->advance(60);
  EXPECT_EQ(gauss.series[0].errors[5], alone->iterations(0) / 60);
  EXPECT_GT(gauss.series[0].errors[5], 4);
  EXPECT_LT(gauss.series[0].errors[5], 40);
}

TEST(RoundingOfIntegrals, IsWhatIsLeftOfAnErrorWithoutTruncation) {
  auto study = study_of_wells();
  study.methods = {"stoermer-verlet"};
  study.perturb = {{"position", {Perturbation::Law::uniform, 0.1}}};
  study.quantities = {"energy", "rounding-of-energy"};
  study.reference = {Reference::Kind::same_method, "double-double", 16};
  auto const record = first_unit(study);
  ASSERT_EQ(record.series.size(), 2U);
  double truncation = 0, rounding = 0;
  for (double e : record.series[0].errors) truncation = std::max(truncation, std::abs(e));
  for (double e : record.series[1].errors) rounding = std::max(rounding, std::abs(e));
  EXPECT_EQ(record.series[1].name, "rounding-of-energy");
  EXPECT_GT(truncation, 1e-3);
  EXPECT_GT(rounding, 1e-18);
  EXPECT_LT(rounding, 1e-13);
}

}  // namespace
}  // namespace brouwer
