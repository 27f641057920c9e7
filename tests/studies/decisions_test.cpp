// Claims that are proven, [tests] and --correction: read, refused where they are wrong, and as a user meets them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <brouwer/error.hpp>

#include "studies/gtest.hpp"
#include "studies/read.hpp"
#include "studies/reading/tests_section.hpp"
#include "tests/studies/small_catalogue.hpp"

namespace brouwer {
namespace {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using Wanted = Expectation::DriftWanted;

constexpr char const* head = R"([system.rigid_body]
momentum = [1.8, 0.4, -0.9]
[integrate]
methods = "dmv-2"
step = 0.01
steps = 1000
[ensemble]
members = 8
perturb = { momentum = { uniform = 1e-2 } }
[observe]
quantities = "energy"
)";

StudyFile read(std::string const& rest) { return parse_study(head + rest, "drift.toml", small_catalogue()); }

Expectation expecting(std::string const& claims) {
  return read("[[expect]]\nof = 'energy'\n" + claims).expectations.at(0);
}

std::string complaint(std::string const& rest) {
  try {
    read(rest);
  } catch (InputError const& error) {
    return error.what();
  }
  return "";
}

std::string complaint_of_claims(std::string const& claims) { return complaint("[[expect]]\nof = 'energy'\n" + claims); }

TEST(SmallDrift, IsRead) {
  auto const expectation = expecting("drift = { smaller_than = 1e-19 }");
  EXPECT_EQ(expectation.drift, Wanted::smaller_than);
  EXPECT_EQ(expectation.drift_bound, 1e-19);
}

TEST(SmallDrift, IsRefusedWhereItIsNoneOrTwo) {
  EXPECT_THAT(complaint_of_claims("drift = { smaller_than = 0 }"),
              HasSubstr("drift.toml:14: expect[1].drift.smaller_than = 0, expected a finite number greater than 0"));
  EXPECT_THAT(complaint_of_claims("drift = { smaller_then = 1e-19 }"),
              HasSubstr("unknown key 'expect[1].drift.smaller_then'; did you mean 'smaller_than'?"));
  for (auto const* both : {"drift = { smaller_than = 1e-19, per_step = [0, 1] }", "drift = {}"})
    EXPECT_THAT(complaint_of_claims(both), HasSubstr("expect[1].drift: expected one of per_step, smaller_than"));
}

TEST(FailedMembers, AreRead) {
  EXPECT_EQ(expecting("failed = 0").failed, 0);
  EXPECT_EQ(expecting("failed = 3").failed, 3);
  EXPECT_THAT(complaint_of_claims("failed = -1"), HasSubstr("expect[1].failed = -1, expected a whole number from 0"));
  EXPECT_THAT(complaint_of_claims(""), HasSubstr("claims nothing"));
}

TEST(TestsSection, IsOfTheExpectationsThatDoNotSayTheirOwn) {
  auto const file = read(
      "[tests]\nlevel = 0.01\ncorrection = 'holm'\n"
      "[[expect]]\nof = 'energy'\ndrift = 'none'\n[[expect]]\nof = 'energy'\ndrift = 'none'\nlevel = 0.2\n");
  EXPECT_EQ(file.correction, Correction::holm);
  EXPECT_EQ(file.expectations[0].level, 0.01);
  EXPECT_EQ(file.expectations[1].level, 0.2);
  EXPECT_FALSE(read("").correction);
}

TEST(TestsSection, ChangesNothingThatIsRun) {
  EXPECT_EQ(canonical_text(read("[tests]\ncorrection = 'fdr'\n").study), canonical_text(read("").study));
}

TEST(TestsSection, IsRefusedWhereItIsWrong) {
  EXPECT_THAT(
      complaint("[tests]\ncorrection = 'bonferroni'\n"),
      HasSubstr("drift.toml:13: tests.correction: there is no correction 'bonferroni'; known are none, holm, fdr"));
  EXPECT_THAT(complaint("[tests]\nlevel = 2\n"), HasSubstr("tests.level = 2, expected a number greater than 0"));
  EXPECT_THAT(complaint("[tests]\nlevels = 0.1\n"), HasSubstr("unknown key 'tests.levels'; did you mean 'level'?"));
}

TEST(TestsSection, IsFoundInAStoredStudy) {
  EXPECT_EQ(correction_in(std::string(head) + "[tests]\ncorrection = 'fdr'\n"), Correction::fdr);
  EXPECT_FALSE(correction_in(head));
}

// --- at work --------------------------------------------------------------------------------------

std::string const study_file = std::string(BROUWER_SOURCE) + "/studies/elliptic-drift.toml";

StudyRun const& small_run() {
  static StudyRun const run(study_file, {"ensemble.members=32", "integrate.steps=20000", "tests.correction='holm'"});
  return run;
}

Estimates const& energy(std::string const& method) { return small_run().row("energy", {.method = method}); }

TEST(DriftTest, ProvesThatADriftIsSmall) {
  EXPECT_THAT(energy("elliptic-three-constants"), DriftIsSmallerThan(1.5e-18));
  EXPECT_THAT(energy("elliptic-three-constants"), Not(DriftIsSmallerThan(1e-20)));
  EXPECT_THAT(energy("elliptic-three-constants"), DriftIsSmallerThan(7e-19, 0.05));
  EXPECT_THAT(energy("elliptic-naive"), Not(DriftIsSmallerThan(1e-17)));
  testing::StringMatchResultListener found;
  testing::ExplainMatchResult(DriftIsSmallerThan(1e-20), energy("elliptic-three-constants"), &found);
  EXPECT_THAT(found.str(), HasSubstr("the smallest δ proven is"));
  EXPECT_THAT(testing::DescribeMatcher<Estimates>(DriftIsSmallerThan(1e-20)), HasSubstr("|drift| < 1e-20 per step"));
}

TEST(DriftTest, CountsFailures) {
  EXPECT_THAT(energy("elliptic-naive"), HasFailedAtMost(0));
  EXPECT_THAT(testing::DescribeMatcher<Estimates>(HasFailedAtMost(2)), HasSubstr("at most 2 members failed"));
}

TEST(DriftTest, CorrectsForAllTestsOfTheStudy) {
  EXPECT_TRUE(energy("elliptic-naive").drift.p_alone);
  EXPECT_DOUBLE_EQ(energy("elliptic-naive").drift.p, 4 * *energy("elliptic-naive").drift.p_alone);  // of four rows
  auto const outcomes = small_run().outcomes();
  EXPECT_THAT(outcomes, Each(Passed()));
  EXPECT_THAT(outcomes.at(0).found, HasSubstr("adjusted for 2 tests (holm)"));
}

TEST(DriftTest, SeesIncrements) {
  auto const& tests = energy("elliptic-three-constants").increments;
  ASSERT_TRUE(tests);
  EXPECT_EQ(tests->count, 32 * 63);
  EXPECT_LT(std::abs(tests->autocorrelations[0].rho), 0.2);
}

}  // namespace
}  // namespace brouwer
