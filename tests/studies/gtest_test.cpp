// The header for users of GoogleTest, tested by using it: the elliptic integrators at toy size.
#include "studies/gtest.hpp"

#include <gtest/gtest.h>

namespace brouwer {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::Not;

std::string const study_file = std::string(BROUWER_SOURCE) + "/studies/elliptic-drift.toml";

StudyRun const& small_run() {
  static StudyRun const run(study_file, {"ensemble.members=32", "integrate.steps=20000"});
  return run;
}

Estimates const& energy(std::string const& method) { return small_run().row("energy", {.method = method}); }

TEST(DriftTest, TellsTheNaiveConstantsFromTheConsistentOnes) {
  EXPECT_THAT(energy("elliptic-three-constants"), HasNoDrift());
  EXPECT_THAT(energy("elliptic-naive"), Not(HasNoDrift()));
  EXPECT_THAT(energy("elliptic-naive"), DriftsBetween(-3e-17, -1.5e-17));
  EXPECT_THAT(energy("elliptic-naive"), Not(DriftsBetween(1.5e-17, 3e-17)));
}

TEST(DriftTest, SaysWhatWasFound) {
  testing::StringMatchResultListener found;
  EXPECT_FALSE(testing::ExplainMatchResult(HasNoDrift(), energy("elliptic-naive"), &found));
  EXPECT_THAT(found.str(), HasSubstr("t = "));
}

TEST(DriftTest, JudgesTheGrowth) {
  EXPECT_THAT(energy("elliptic-three-constants"), GrowsAs(0.5, 0.1));
  EXPECT_THAT(energy("elliptic-naive"), Not(GrowsAs(0.5, 0.1)));
}

TEST(DriftTest, RunsTheStudysOwnExpectations) { EXPECT_EQ(small_run().outcomes().size(), 3U); }

TEST(DriftTest, RefusesAnAmbiguousRow) {
  EXPECT_THROW(small_run().row("energy"), InputError);
  EXPECT_THROW(small_run().row("enrgy"), InputError);
}

}  // namespace
}  // namespace brouwer
