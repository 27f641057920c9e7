// What a study may ask of a count, and of a range of steps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <brouwer/error.hpp>

#include "studies/read.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;

/// A study of a method that counts and one that does not, with this expectation.
std::string study_with(std::string const& expectation) {
  return R"(question = "How many turns?"
source = "this test"
[system.henon_heiles]
[integrate]
methods = ["gauss-8", "stoermer-verlet"]
step = [0.3, 0.2, 0.1, 0.05]
steps = 100
[ensemble]
members = 4
perturb = { position = { uniform = 1e-2 } }
[observe]
quantities = ["energy", "iterations"]
samples = { count = 8 }
[[expect]]
)" + expectation;
}

Catalogue const& catalogue() {
  static Catalogue const all = builtin_catalogue();
  return all;
}

StudyFile read(std::string const& expectation) { return parse_study(study_with(expectation), "x.toml", catalogue()); }

std::string complaint(std::string const& expectation) {
  try {
    read(expectation);
    return "(accepted)";
  } catch (InputError const& error) {
    return error.what();
  }
}

TEST(Counts, HaveAMeanAndAnRms) {
  auto const file = read("of = \"iterations\"\nmean = [5, 20]\nrms = [5, 21]");
  ASSERT_EQ(file.expectations.size(), 1U);
  EXPECT_EQ(file.expectations[0].mean->low, 5);
  EXPECT_EQ(file.expectations[0].rms_final->high, 21);
}

TEST(Counts, HaveNoLawOfGrowth) {
  for (char const* law : {"drift = \"none\"", "growth = { exponent = 0.5, within = 0.1 }", "persistence = \"none\"",
                          "step_exponent = { exponent = 1, within = 0.1 }", "verdict = \"drift\""})
    EXPECT_THAT(complaint(std::string("of = \"iterations\"\n") + law),
                HasSubstr("x.toml:14: [[expect]] 'iterations' is a count"))
        << law;
}

TEST(Counts, AreOfMethodsThatCount) {
  EXPECT_THAT(complaint("of = \"iterations\"\nwhere = { method = \"stoermer-verlet\" }\nmean = [1, 2]"),
              HasSubstr("no method that 'where' selects counts 'iterations'"));
}

TEST(StepRange, SelectsTheStepsInsideAndBothEnds) {
  auto const file = read("of = \"energy\"\nwhere = { step = { from = 0.1, to = 0.2 } }\ndrift = \"none\"");
  auto const& where = file.expectations.at(0).where;
  int matched = 0;
  for (auto const& cell : file.plan.cells) matched += where.matches(cell) ? 1 : 0;
  EXPECT_EQ(matched, 2 * 2);
}

TEST(StepRange, IsRefusedWhereItIsNone) {
  EXPECT_THAT(complaint("of = \"energy\"\nwhere = { step = { from = 0.2, to = 0.1 } }\ndrift = \"none\""),
              HasSubstr("from is larger than to"));
  EXPECT_THAT(complaint("of = \"energy\"\nwhere = { step = [0.1, 0.2] }\ndrift = \"none\""),
              HasSubstr("or { from = …, to = … }"));
  EXPECT_THAT(complaint("of = \"energy\"\nrms = [-2, -1]"), HasSubstr("rms is never below 0"));
}

TEST(MethodNames, OfOtherSystemsAreToldFromUnknownOnes) {
  auto text = study_with("of = \"energy\"\ndrift = \"none\"");
  text.replace(text.find("gauss-8"), 7, "dmv-10");
  EXPECT_THAT([&] { parse_study(text, "x.toml", catalogue()); },
              testing::ThrowsMessage<InputError>(HasSubstr("'dmv-10' is a method of rigid_body, not of henon_heiles")));
}

TEST(Coefficients, OfNoMethodOfTheStudyAreRefused) {
  auto text = study_with("of = \"energy\"\ndrift = \"none\"");
  text.replace(text.find("\"gauss-8\", "), 11, "");
  text.replace(text.find("step ="), 0, "coefficients = \"split\"\n");
  text.replace(text.find(", \"iterations\""), 14, "");
  EXPECT_THAT(
      [&] { parse_study(text, "x.toml", catalogue()); },
      testing::ThrowsMessage<InputError>(HasSubstr("'split' is a level of none of the methods stoermer-verlet")));
}

}  // namespace
}  // namespace brouwer
