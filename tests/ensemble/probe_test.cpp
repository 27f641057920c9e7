// Errors of single steps: against steps made by hand, on every path, in any threads and lanes.
#include <brouwer/ensemble/probe.hpp>
#include <brouwer/ensemble/reference.hpp>
#include <brouwer/ensemble/start.hpp>
#include <brouwer/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/ensemble/small_study.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;

Catalogue const& catalogue() {
  static auto const built = builtin_catalogue();
  return built;
}

CellLabels cell_of(Study const& study) { return make_plan(study, catalogue()).cells.front(); }

Study body(char const* method, bool compensation) {
  auto study = testing_support::small_study();
  study.methods = {method};
  study.compensation = {compensation};
  study.steps = 600;
  study.quantities = {"energy", "casimir"};
  return study;
}

Study pendulum(char const* method) {
  auto study = testing_support::standard_study(catalogue().system("pendulum"));
  study.methods = {method};
  study.arithmetics = {"double"};
  study.special_functions = {"own"};
  study.compensation = {false};
  study.step = {0.05};
  study.steps = 600;
  study.members = 20;
  study.perturb = {{"position", {Perturbation::Law::uniform, 1e-2}}};
  study.quantities = {"energy", "rounding-of-energy", "state"};
  study.reference = {Reference::Kind::same_method, "double-double", 4};
  study.samples = {8, Samples::Spacing::log};
  return study;
}

constexpr ProbeDesign small_design = {.members = 20, .windows = 4, .length = 16, .covered = 400};

std::vector<LocalErrors> errors_of(Study const& study, RunOptions const& options = {}) {
  return probe(study, catalogue(), cell_of(study), small_design, options).errors;
}

/// Rounding and truncation of one step of one member in an arithmetic that the probe does not use, state by state.
std::pair<double, double> step_by_hand(Study const& study, std::int64_t member, std::int64_t step) {
  auto const cell = cell_of(study);
  auto const start = member_starts(study, catalogue().system(study.system), "double", member, 1).front();
  auto const working = begin_trajectory(catalogue(), cell, start, true);
  std::vector<Widest> before(start.state.size()), after(before), exact(before);
  working->advance(step);
  working->state(0, before);
  working->advance(1);
  working->state(0, after);
  Start from{start.parameters, {}, {}};
  for (auto const& x : before) {
    from.state.push_back(static_cast<double>(x));
    from.state_rest.push_back(static_cast<double>(Widest(x - from.state.back())));
    EXPECT_EQ(Widest(from.state.back()) + from.state_rest.back(), x) << "two doubles hold a state with its residue";
  }
  auto const judge = begin_trajectory(catalogue(), reference_cell(cell, "mpfr-256"), from, true);
  std::vector<double> rounding(catalogue().system(study.system).count(Quantity::Kind::integral)), truncation(rounding);
  judge->advance(1);
  judge->state(0, exact);
  working->rounding_errors(0, exact, rounding);
  judge->first_integral_errors(truncation);
  return {rounding[0], truncation[0]};
}

void expect_steps_by_hand(Study const& study) {
  auto const found = errors_of(study).front();
  for (std::int64_t const member : {0, 17})
    for (std::int64_t const l : {std::int64_t{0}, found.length - 1}) {
      auto const [rounding, truncation] =
          step_by_hand(study, member, window_begin(small_design, study.seed, member, 1) + l);
      EXPECT_NE(rounding, 0);
      EXPECT_NEAR(found.rounding(member, found.length + l), rounding, 1e-5 * std::abs(rounding) + 1e-30);
      if (l < found.judged) {
        EXPECT_NEAR(found.truncation(member, found.judged + l), truncation, 1e-12 * std::abs(truncation) + 1e-30);
      }
    }
}

TEST(Probe, FindsWhatStepsMadeByHandInAnotherArithmeticFind) {
  expect_steps_by_hand(body("dmv-2", true));  // with a residue
  expect_steps_by_hand(body("elliptic-naive", false));
  expect_steps_by_hand(pendulum("kutta-4"));
}

TEST(Probe, JudgesOneStepAWindowWhereTheMethodConservesAndAllElsewhere) {
  EXPECT_EQ(errors_of(body("dmv-2", false)).front().judged, 1);
  auto const found = errors_of(pendulum("kutta-4"));
  EXPECT_EQ(found.front().judged, small_design.length);
  EXPECT_GT(found.front().truncation.cwiseAbs().maxCoeff(), 1e6 * found.front().rounding.cwiseAbs().maxCoeff());
}

TEST(Probe, HasEveryQuantityInItsKind) {
  auto const found = errors_of(pendulum("kutta-4"));
  ASSERT_EQ(found.size(), 4U);  // energy, its rounding, position, momentum
  EXPECT_EQ(found[0].rounding, found[1].rounding);
  EXPECT_EQ(found[0].truncation.cols(), small_design.steps());
  EXPECT_EQ(found[1].truncation.cols(), 0);
  EXPECT_TRUE(found[2].of_state);
  EXPECT_LT(found[2].rounding.cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_GT(found[2].rounding.cwiseAbs().maxCoeff(), 0);
}

TEST(Probe, HasTheSameBitsInAnyThreadsAndLanes) {
  RunOptions alone;
  alone.threads = 1;
  alone.widest = InstructionSet::none;
  RunOptions many;
  many.threads = 3;
  for (auto const& study : {body("dmv-2", true), pendulum("kutta-4")}) {
    auto const one = errors_of(study, alone), other = errors_of(study, many);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(one[i].rounding, other[i].rounding);
      EXPECT_EQ(one[i].truncation, other[i].truncation);
    }
  }
}

TEST(Probe, OfFewerMembersIsThatOfTheFirst) {
  auto const study = body("dmv-2", false);
  auto few = small_design;
  few.members = 5;
  auto const found = probe(study, catalogue(), cell_of(study), few, {}).errors.front();
  EXPECT_EQ(found.rounding, errors_of(study).front().rounding.topRows(5));
}

TEST(ProbeDesign, PutsEachWindowIntoItsPartForEachMemberElsewhere) {
  ProbeDesign const design;
  std::int64_t const part = design.covered / design.windows;
  std::set<std::int64_t> places;
  for (std::int64_t member = 0; member < 100; ++member)
    for (std::int64_t w = 0; w < design.windows; ++w) {
      auto const begin = window_begin(design, 7, member, w);
      EXPECT_GE(begin, w * part);
      EXPECT_LE(begin + design.length, (w + 1) * part);
      places.insert(begin % part);
    }
  EXPECT_GT(places.size(), 400U) << "of 961 places";
}

TEST(ProbeDesign, FitsShortRuns) {
  auto study = body("dmv-2", false);
  study.steps = 100;
  auto const design = fitted({}, study, cell_of(study));
  EXPECT_EQ(design.members, 20);
  EXPECT_EQ(design.covered, 100);
  EXPECT_EQ(design.length, 12);
  EXPECT_EQ(reason_not_to_probe(study, catalogue(), cell_of(study), {}), "");
}

TEST(Probe, SaysWhyACellIsNotProbed) {
  auto study = body("dmv-2", false);
  study.steps = 20;
  EXPECT_THAT(reason_not_to_probe(study, catalogue(), cell_of(study), {}),
              HasSubstr("8 windows of 4 steps do not fit into 20 steps"));
  study.steps = 600;
  study.members = 1;
  EXPECT_THAT(reason_not_to_probe(study, catalogue(), cell_of(study), {}), HasSubstr("expected at least 2, found 1"));
  study.members = 4;
  study.reference = {};
  study.arithmetics = {"float128"};
  EXPECT_THAT(reason_not_to_probe(study, catalogue(), cell_of(study), {}), HasSubstr("dmv-2 in float128"));
  EXPECT_THROW(probe(study, catalogue(), cell_of(study), {}, {}), InputError);
  study.arithmetics = {"double-double"};
  EXPECT_EQ(judge_of(catalogue(), cell_of(study)), "mpfr-256");
}

TEST(Probe, WorksInWiderAndNarrowerArithmetics) {
  double const epsilon[] = {0x1p-23, 0x1p-63, 0x1p-105};
  char const* const arithmetics[] = {"float", "long-double", "double-double"};
  for (std::size_t i = 0; i < 3; ++i) {
    auto study = body("elliptic-increment", false);
    study.reference = {};
    study.arithmetics = {arithmetics[i]};
    auto const found = errors_of(study).front();
    double const size = std::sqrt(found.rounding.array().square().mean());
    EXPECT_GT(size, 0.01 * epsilon[i]) << arithmetics[i];
    EXPECT_LT(size, 3 * epsilon[i]) << arithmetics[i];
    EXPECT_LT(found.truncation.cwiseAbs().maxCoeff(), 1e-3 * size) << arithmetics[i];
  }
}

TEST(Probe, LeavesMembersThatFailOut) {
  auto study = pendulum("kutta-4");
  study.step = {1e3};  // too large: some energies are not finite soon
  study.perturb = {{"position", {Perturbation::Law::uniform, 1e-2}}};
  study.quantities = {"energy"};
  auto const found = errors_of(study).front();
  EXPECT_EQ(found.failed + found.rounding.rows(), 20);
  std::int64_t counted = 0;
  for (auto const& failures : found.failures) counted += failures.members;
  EXPECT_EQ(counted, found.failed);
  EXPECT_TRUE(found.rounding.allFinite());
}

}  // namespace
}  // namespace brouwer
