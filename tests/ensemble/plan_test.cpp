// A study becomes cells and units: crossed, merged where a factor does not apply, refused where it is impossible.
#include <brouwer/ensemble/plan.hpp>
#include <brouwer/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ensemble/small_study.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing_support::small_study;

std::string complaint_of(Study const& study) {
  try {
    make_plan(study, builtin_catalogue());
  } catch (InputError const& error) {
    return error.what();
  }
  return "(accepted)";
}

TEST(Plan, CrossesTheFactors) {
  auto study = small_study();
  study.step = {0.05, 0.1, 0.2};
  study.steps.reset();
  study.until = 20;
  auto const plan = make_plan(study, builtin_catalogue());
  EXPECT_EQ(plan.cells.size(), 2 * 2 * 3);
  EXPECT_TRUE(plan.skipped.empty());
  EXPECT_EQ(plan.cells[0].steps, 400);
  EXPECT_EQ(plan.cells[2].steps, 100);
  EXPECT_EQ(plan.cells[0].special_functions, "-");
  EXPECT_EQ(plan.cells[0].coefficients, "-");
}

TEST(Plan, RunsAMethodOnceWhereAFactorDoesNotTouchIt) {
  auto study = small_study();
  study.compensation = {false};
  study.special_functions = {"own", "gsl"};
  study.methods = {"dmv-2", "elliptic-naive"};
  auto const plan = make_plan(study, builtin_catalogue());
  ASSERT_EQ(plan.cells.size(), 3);
  EXPECT_EQ(plan.cells[0].method, "dmv-2");
  EXPECT_EQ(plan.cells[2].special_functions, "gsl");
}

/// The catalogue with a method whose modified coefficients may be taken per step or per trajectory.
Catalogue with_preprocessed_method() {
  auto catalogue = builtin_catalogue();
  auto method = catalogue.method("rigid_body", "dmv-2");
  method.name = "preprocessed";
  method.coefficients = {"per-step", "per-trajectory"};
  catalogue.methods.push_back(method);
  return catalogue;
}

TEST(Plan, CrossesCoefficientsForMethodsThatHaveThem) {
  auto study = small_study();
  study.compensation = {false};
  study.methods = {"dmv-2", "preprocessed", "elliptic-naive"};
  study.coefficients = {"per-trajectory", "per-step"};
  std::vector<std::string> levels;
  for (auto const& cell : make_plan(study, with_preprocessed_method()).cells)
    levels.push_back(cell.method + " " + cell.special_functions + " " + cell.coefficients);
  EXPECT_THAT(levels, ElementsAre("dmv-2 - -", "preprocessed - per-trajectory", "preprocessed - per-step",
                                  "elliptic-naive own -"));
}

TEST(Plan, TakesCoefficientsPerStepUnlessToldOtherwise) {
  auto study = small_study();
  study.methods = {"preprocessed"};
  for (auto const& cell : make_plan(study, with_preprocessed_method()).cells) EXPECT_EQ(cell.coefficients, "per-step");
}

TEST(Plan, SkipsWhatDoesNotExistAndSaysWhy) {
  auto study = small_study();
  study.methods = {"elliptic-naive"};
  study.special_functions = {"own", "gsl"};
  study.arithmetics = {"double", "float"};
  auto const plan = make_plan(study, builtin_catalogue());
  EXPECT_EQ(plan.cells.size(), 3);  // own and gsl in double, own in float; none with compensation
  ASSERT_EQ(plan.skipped.size(), 5);
  EXPECT_THAT(plan.skipped[0].reason, HasSubstr("compensation does not apply"));
  EXPECT_THAT(plan.skipped.back().reason,
              testing::AnyOf(HasSubstr("do not exist in float"), HasSubstr("compensation")));
}

TEST(Plan, CutsEachCellIntoUnitsThatHoldEveryMemberOnce) {
  auto study = small_study();
  for (std::int64_t members : {1, 15, 16, 17, 511, 512, 1000, 100'000}) {
    study.members = members;
    auto const plan = make_plan(study, builtin_catalogue());
    std::vector<std::int64_t> next(plan.cells.size(), 0), units(plan.cells.size(), 0);
    for (auto const& unit : plan.units) {
      EXPECT_EQ(unit.first_member, next[unit.cell]);
      next[unit.cell] += unit.members;
      ++units[unit.cell];
    }
    for (std::size_t c = 0; c < plan.cells.size(); ++c) {
      EXPECT_EQ(next[c], members);
      EXPECT_LE(units[c], 256);
    }
  }
}

TEST(Plan, RefusesWhatCannotBe) {
  auto const with = [](auto change) {
    auto study = small_study();
    change(study);
    return complaint_of(study);
  };
  EXPECT_EQ(with([](Study&) {}), "(accepted)");
  EXPECT_THAT(with([](Study& s) { s.methods = {"elliptic-niave"}; }), HasSubstr("did you mean 'elliptic-naive'"));
  EXPECT_THAT(with([](Study& s) { s.arithmetics = {"duoble"}; }), HasSubstr("did you mean 'double'"));
  EXPECT_THAT(with([](Study& s) { s.coefficients = {"per-stpe"}; }), HasSubstr("did you mean 'per-step'"));
  EXPECT_THAT(with([](Study& s) { s.quantities = {"energie"}; }), HasSubstr("did you mean 'energy'"));
  EXPECT_THAT(with([](Study& s) { s.system = "pendulun"; }), HasSubstr("did you mean 'pendulum'"));
  EXPECT_THAT(with([](Study& s) { s.system = "pendulum"; }), HasSubstr("'frequency' of pendulum is missing"));
  EXPECT_THAT(with([](Study& s) { s.values["inertia"] = {1, 2}; }), HasSubstr("expected 3 numbers, found 2"));
  EXPECT_THAT(with([](Study& s) { s.values["inertia"] = {1, 0.5, 1}; }), HasSubstr("sorted"));
  EXPECT_THAT(with([](Study& s) { s.steps = 5; }), HasSubstr("cannot be sampled 8 times"));
  EXPECT_THAT(with([](Study& s) { s.reference = {}; }), HasSubstr("needs a reference"));
  EXPECT_THAT(with([](Study& s) {
                s.reference = {Reference::Kind::same_method, "double", 4};
              }),
              HasSubstr("cannot judge double"));
  EXPECT_THAT(with([](Study& s) { s.members = 0; }), HasSubstr("at least 1"));
  EXPECT_THAT(with([](Study& s) { s.steps.reset(), s.until = 1e300; }), HasSubstr("steps; expected"));
  EXPECT_THAT(with([](Study& s) { s.methods = {"elliptic-naive"}, s.compensation = {true}; }),
              HasSubstr("nothing is left to run"));
}

TEST(SampleSteps, IncreaseEndAtTheEndAndAreSpacedAsAsked) {
  for (std::int64_t steps : {1, 2, 7, 64, 65, 100, 12345, 1'000'000'000})
    for (std::int64_t count : {1, 2, 5, 64})
      for (auto spacing : {Samples::Spacing::linear, Samples::Spacing::log}) {
        if (count > steps) continue;
        auto const at = sample_steps({count, spacing}, steps);
        ASSERT_EQ(static_cast<std::int64_t>(at.size()), count);
        EXPECT_GE(at.front(), 1);
        EXPECT_EQ(at.back(), steps);
        EXPECT_TRUE(std::adjacent_find(at.begin(), at.end(), std::greater_equal<>()) == at.end());
      }
  EXPECT_EQ(sample_steps({4, Samples::Spacing::linear}, 100), (std::vector<std::int64_t>{25, 50, 75, 100}));
  EXPECT_EQ(sample_steps({4, Samples::Spacing::log}, 1000), (std::vector<std::int64_t>{1, 10, 100, 1000}));
}

TEST(StudyHash, IsThatOfTheResultsNotOfTheWords) {
  auto const study = small_study();
  auto other = study;
  other.question = "something else?";
  other.name = "renamed";
  EXPECT_EQ(study_hash(study), study_hash(other));
  for (auto change : std::vector<std::function<void(Study&)>>{
           [](Study& s) { s.seed = 8; }, [](Study& s) { s.step[0] = std::nextafter(0.05, 1); },
           [](Study& s) { s.perturb["momentum"].size *= 2; }, [](Study& s) { s.values["momentum"][1] = -0.0; },
           [](Study& s) { s.members = 21; }, [](Study& s) { s.samples.count = 9; },
           [](Study& s) { s.coefficients = {"per-trajectory"}; },
           [](Study& s) {
             s.coefficients = {"per-step", "per-trajectory"};
           }}) {
    other = study;
    change(other);
    EXPECT_NE(study_hash(study), study_hash(other));
  }
}

TEST(StudyHash, IsWhatItWasBeforeTheFactorCoefficients) {
  auto study = small_study();
  EXPECT_THAT(canonical_text(study), Not(HasSubstr("coefficients")));
  study.coefficients = {"per-trajectory"};
  EXPECT_THAT(canonical_text(study), HasSubstr("\ncoefficients = per-trajectory\n"));
}

}  // namespace
}  // namespace brouwer
