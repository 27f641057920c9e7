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

TEST(DriftTest, ComparesWithABaseline) {
  auto const before = small_run().recorded();
  EXPECT_THAT(before, IsNotWorseThan(before));
  StudyRun const others(study_file, {"ensemble.members=32", "integrate.steps=20000", "ensemble.seed=7"});
  EXPECT_THAT(others.recorded(), IsNotWorseThan(before)) << "other members of the same population";
  auto drifting = before.only("energy", {.method = "elliptic-naive"});
  EXPECT_THAT(others.recorded().only("energy", {.method = "elliptic-naive"}), IsNotWorseThan(drifting));
  EXPECT_THAT(others.recorded().only("casimir"), Not(IsNotWorseThan(drifting))) << "it is gone";
  drifting.rows[0].slope_mean /= 2;  // as if it had been better
  testing::StringMatchResultListener said;
  EXPECT_FALSE(testing::ExplainMatchResult(IsNotWorseThan(drifting), others.recorded().only("energy"), &said));
  EXPECT_THAT(said.str(), HasSubstr("drift β is larger: −1.1"));
  EXPECT_THROW(static_cast<void>(before.only("enrgy")), InputError);
}

TEST(DriftTest, RefusesAnAmbiguousRow) {
  EXPECT_THROW(small_run().row("energy"), InputError);
  EXPECT_THROW(small_run().row("enrgy"), InputError);
}

}  // namespace
}  // namespace brouwer
