// What a study expects against what was found: each part passes and fails where it should, and says why.
#include "analysis/expectations/expectations.hpp"

#include <gmock/gmock.h>

#include <brouwer/error.hpp>
#include <cmath>

#include "analysis/growth/sweep.hpp"
#include "tests/analysis/presented_estimates.hpp"

namespace brouwer {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Wanted = Expectation::DriftWanted;

std::vector<Estimates> drifting_and_not() {
  return {presented_estimates("elliptic-naive", "energy", -2.31e-17),
          presented_estimates("elliptic-three-constants", "energy", 0)};
}

SweepLaw no_sweep(std::vector<std::size_t> const&) {
  ADD_FAILURE() << "nothing asked for a law in h";
  return {};
}

Expectation expecting(std::string const& of, std::string const& method = "") {
  Expectation expectation;
  expectation.of = of;
  if (!method.empty()) expectation.where.method = method;
  return expectation;
}

Outcome only(Expectation const& expectation, std::vector<Estimates> const& rows = drifting_and_not()) {
  auto const outcomes = check({expectation}, rows, no_sweep);
  EXPECT_EQ(outcomes.size(), 1u);
  return outcomes.empty() ? Outcome{} : outcomes.front();
}

TEST(ExpectNoDrift, HoldsWhereNoneIsSeenAndTellsWhatWouldHaveBeenSeen) {
  auto expectation = expecting("energy", "elliptic-three-constants");
  expectation.drift = Wanted::none;
  auto const outcome = only(expectation);
  EXPECT_TRUE(outcome.passed);
  EXPECT_EQ(outcome.claim, "energy, elliptic-three-constants, double, h = 0.01: no drift at level 0.001");
  EXPECT_THAT(outcome.found, HasSubstr("smallest drift visible at level 0.001 with chance 0.9 is 7.3e-19"));
}

TEST(ExpectNoDrift, FailsWhereADriftIsSeen) {
  auto expectation = expecting("energy", "elliptic-naive");
  expectation.drift = Wanted::none;
  auto const outcome = only(expectation);
  EXPECT_FALSE(outcome.passed);
  EXPECT_THAT(outcome.found, HasSubstr("β = (−2.31 ± 0.03)e-17 per step (t = −144, p = 1.0e-80)"));
}

TEST(ExpectNoDrift, FailsWhereThereIsNoTest) {
  auto expectation = expecting("energy");
  expectation.drift = Wanted::none;
  auto row = presented_estimates("m", "energy", 0);
  row.drift.p = std::nan("");
  EXPECT_FALSE(only(expectation, {row}).passed);
}

TEST(ExpectNoDrift, IsTestedAtItsOwnLevel) {
  auto expectation = expecting("energy", "elliptic-three-constants");
  expectation.drift = Wanted::none;
  expectation.level = 0.7;  // p is 0.6
  auto const outcome = only(expectation);
  EXPECT_FALSE(outcome.passed);
  EXPECT_THAT(outcome.found,
              HasSubstr("visible at level 0.7 with chance 0.9 is 2.5e-19"));  // δ is 1.668 there, 4.778 at 0.001
}

TEST(ExpectDriftBand, WantsTheEstimateInsideAndTheDriftSeen) {
  auto expectation = expecting("energy", "elliptic-naive");
  expectation.drift = Wanted::band;
  expectation.drift_band = {-3e-17, -1.5e-17};
  EXPECT_TRUE(only(expectation).passed);
  expectation.drift_band = {-2e-17, -1.5e-17};
  EXPECT_FALSE(only(expectation).passed);
  expectation.drift_band = {-3e-17, -1.5e-17};
  auto rows = drifting_and_not();
  rows[0].drift.p = 0.01;
  EXPECT_FALSE(only(expectation, rows).passed) << "inside the band, but not seen at 0.001";
}

TEST(ExpectDriftBand, AroundZeroAsksForNoSignificance) {
  auto expectation = expecting("energy", "elliptic-three-constants");
  expectation.drift = Wanted::band;
  expectation.drift_band = {-1e-19, 1e-19};
  EXPECT_TRUE(only(expectation).passed);
}

TEST(ExpectGrowth, ComparesTheExponentAndTellsItsInterval) {
  auto expectation = expecting("energy", "elliptic-naive");
  expectation.growth = Around{0.5, 0.05};
  auto const outcome = only(expectation);
  EXPECT_FALSE(outcome.passed);
  EXPECT_THAT(outcome.claim, HasSubstr("q = 0.5 ± 0.05"));
  EXPECT_THAT(outcome.found, HasSubstr("q = 0.810 (95 % interval 0.780 … 0.840)"));
  expectation.where.method = "elliptic-three-constants";
  EXPECT_TRUE(only(expectation).passed);
}

TEST(ExpectPersistence, WorksBothWays) {
  auto expectation = expecting("energy", "elliptic-naive");
  expectation.persistence = false;
  EXPECT_TRUE(only(expectation).passed);
  expectation.persistence = true;
  EXPECT_FALSE(only(expectation).passed);
  auto rows = drifting_and_not();
  rows[0].persistence.p = 1e-9;
  EXPECT_TRUE(only(expectation, rows).passed);
}

TEST(ExpectVerdict, TakesAnyOfItsWordsAndRefusesOthers) {
  auto expectation = expecting("energy", "elliptic-naive");
  expectation.verdict = {"random walk", "drift"};
  EXPECT_TRUE(only(expectation).passed);
  expectation.verdict = {"bounded"};
  EXPECT_FALSE(only(expectation).passed);
  expectation.verdict = {"randm walk"};
  expectation.line = 17;
  try {
    check({expectation}, drifting_and_not(), no_sweep);
    FAIL() << "accepted a verdict that does not exist";
  } catch (InputError const& error) {
    EXPECT_STREQ(error.what(), "line 17: there is no verdict 'randm walk'; did you mean 'random walk'?");
  }
}

TEST(Expectation, OfAQuantitySpeaksOfItsComponentsInEveryCell) {
  auto expectation = expecting("spatial-momentum");
  expectation.drift = Wanted::none;
  std::vector<Estimates> const rows = {presented_estimates("a", "spatial-momentum-1", 0),
                                       presented_estimates("b", "spatial-momentum-1", 0),
                                       presented_estimates("b", "energy", 0)};
  EXPECT_EQ(check({expectation}, rows, no_sweep).size(), 2u);
}

TEST(Expectation, OfSeveralPartsHasAnOutcomeForEach) {
  auto expectation = expecting("energy", "elliptic-naive");
  expectation.drift = Wanted::none;
  expectation.growth = Around{0.8, 0.1};
  expectation.verdict = {"drift"};
  auto const outcomes = check({expectation}, drifting_and_not(), no_sweep);
  ASSERT_EQ(outcomes.size(), 3u);
  EXPECT_FALSE(outcomes[0].passed);
  EXPECT_TRUE(outcomes[1].passed && outcomes[2].passed);
}

TEST(Expectation, ThatSpeaksOfNothingHasFailedAndTellsWhatThereIs) {
  auto elsewhere = expecting("energy", "elliptic-naiv");
  elsewhere.drift = Wanted::none;
  EXPECT_FALSE(only(elsewhere).passed);
  EXPECT_THAT(only(elsewhere).claim, HasSubstr("energy where method = elliptic-naiv"));
  EXPECT_THAT(only(elsewhere).found, AllOf(HasSubstr("elliptic-naive, double"), HasSubstr("elliptic-three-constants")));
  auto unknown = expecting("enrgy");
  unknown.drift = Wanted::none;
  EXPECT_THAT(only(unknown).found, HasSubstr("no result has 'enrgy'; there are energy"));
  EXPECT_FALSE(only(expecting("energy", "elliptic-naive")).passed) << "it says nothing that could be checked";
}

TEST(Expectation, SpeaksOfTheCoefficientsItSelects) {
  auto rows = drifting_and_not();
  for (auto& row : rows) row.cell.method = "dmv-10";
  rows[0].cell.coefficients = "per-step";
  rows[1].cell.coefficients = "per-trajectory";
  auto expectation = expecting("energy");
  expectation.drift = Wanted::none;
  expectation.where.coefficients = "per-trajectory";
  auto const outcome = only(expectation, rows);
  EXPECT_TRUE(outcome.passed);
  EXPECT_THAT(outcome.claim, HasSubstr("dmv-10, double, per-trajectory coefficients, h = 0.01"));
  expectation.where.coefficients = "per-step";
  EXPECT_FALSE(only(expectation, rows).passed);
  EXPECT_THAT(only(expectation, rows).claim, HasSubstr("dmv-10, double, h = 0.01")) << "the usual ones are not said";
  expectation.where.coefficients = "-";
  EXPECT_EQ(only(expectation, rows).claim, "energy where coefficients = -");
}

TEST(Expectation, MentionsMembersThatWereLeftOut) {
  auto expectation = expecting("energy", "elliptic-three-constants");
  expectation.drift = Wanted::none;
  auto rows = drifting_and_not();
  rows[1].failed = 2;
  auto const outcome = only(expectation, rows);
  EXPECT_TRUE(outcome.passed);
  EXPECT_THAT(outcome.found, HasSubstr("2 of 66 members failed and were left out"));
}

TEST(ExpectMean, LooksAtTheLastSample) {
  auto expectation = expecting("energy", "elliptic-naive");
  expectation.mean = Interval{-5e-13, -4e-13};  // 20 000 steps of −2.31e-17
  auto const outcome = only(expectation);
  EXPECT_TRUE(outcome.passed);
  EXPECT_THAT(outcome.claim, HasSubstr(": mean at the end between −5.00e-13 and −4.00e-13"));
  EXPECT_THAT(outcome.found, HasSubstr("mean = −4.62e-13 (standard error 3.2e-15) over 64 members"));
  expectation.mean = Interval{-5e-13, -4.7e-13};
  EXPECT_FALSE(only(expectation).passed);
  expectation.mean = Interval{-4.6e-13, 0};
  EXPECT_FALSE(only(expectation).passed);
}

TEST(ExpectRms, LooksAtTheLastSample) {
  auto expectation = expecting("energy", "elliptic-naive");
  expectation.rms_final = Interval{4e-13, 5e-13};
  EXPECT_TRUE(only(expectation).passed);
  EXPECT_THAT(only(expectation).claim, HasSubstr("RMS at the end between 4.00e-13 and 5.00e-13"));
  EXPECT_THAT(only(expectation).found, HasSubstr("RMS = 4.60e-13 over 64 members"));
  expectation.rms_final = Interval{0, 4.5e-13};
  EXPECT_FALSE(only(expectation).passed);
  auto rows = drifting_and_not();
  rows[0].rms_final = std::nan("");
  EXPECT_FALSE(only(expectation, rows).passed) << "every member failed";
}

TEST(Expectation, OfALawFailsForACountAndSaysThatItHasNone) {
  auto row = presented_estimates("gauss-4", "iterations", 0);
  row.count = {14.2, {13.9, 14.6}};
  auto expectation = expecting("iterations");
  expectation.drift = Wanted::none;
  expectation.growth = Around{0.5, 0.1};
  expectation.persistence = false;
  expectation.step_exponent = Around{0.5, 0.1};
  auto const outcomes = check({expectation}, {row}, no_sweep);
  ASSERT_EQ(outcomes.size(), 4u);
  for (auto const& outcome : outcomes) EXPECT_FALSE(outcome.passed) << outcome.claim;
  EXPECT_THAT(outcomes[0].found, HasSubstr("iterations is a count: it has no drift"));
  EXPECT_THAT(outcomes[1].found, HasSubstr("iterations is a count: it has no law of growth"));
  EXPECT_THAT(outcomes[3].found, HasSubstr("iterations is a count: it has no law in h"));
  Expectation mean = expecting("iterations");
  row.mean.back() = 14.2;
  mean.mean = Interval{5, 20};
  mean.verdict = {"count"};
  row.verdict = Verdict::count;
  for (auto const& outcome : check({mean}, {row}, no_sweep)) EXPECT_TRUE(outcome.passed) << outcome.claim;
}

struct ExpectStepExponent : testing::Test {
  std::vector<Estimates> rows;
  Expectation expectation = expecting("energy");

  void SetUp() override {
    expectation.step_exponent = Around{0.5, 0.05};
    for (double const h : {0.01, 0.02, 0.04})
      for (auto const* method : {"a", "b"}) {
        rows.push_back(presented_estimates(method, "energy", 0));
        rows.back().cell.step = h;
        rows.back().cell.steps = static_cast<std::int64_t>(1000 / h);
      }
  }
};

TEST_F(ExpectStepExponent, FitsEachSetOfRowsThatDifferInTheStepAlone) {
  std::vector<std::vector<std::size_t>> asked;
  auto const fit = [&](std::vector<std::size_t> const& chosen) {
    asked.push_back(chosen);
    return SweepLaw{chosen[0] == 0 ? 0.51 : -0.49, {0.48, 0.54}, 0.5, {0.49, 0.51}, 1, chosen.size()};
  };
  auto const outcomes = check({expectation}, rows, fit);
  EXPECT_EQ(asked, (std::vector<std::vector<std::size_t>>{{0, 2, 4}, {1, 3, 5}}));
  ASSERT_EQ(outcomes.size(), 2u);
  EXPECT_TRUE(outcomes[0].passed);
  EXPECT_FALSE(outcomes[1].passed);
  EXPECT_THAT(outcomes[0].claim, testing::StartsWith("energy, a, double"));
  EXPECT_THAT(outcomes[0].found, HasSubstr("p = 0.51 ± 0.03, q = 0.500 ± 0.010 over 3 steps h = 0.01 … 0.04"));
}

TEST_F(ExpectStepExponent, IsFittedOverTheRangeOfStepsThatItSelects) {
  for (auto const* method : {"a", "b"}) {
    rows.push_back(presented_estimates(method, "energy", 0));
    rows.back().cell.step = 0.08;
  }
  expectation.where.method = "a";
  expectation.where.step_range = Interval{0.02, 0.08};  // both ends belong to it
  std::vector<std::size_t> asked;
  auto const fit = [&](std::vector<std::size_t> const& chosen) {
    asked = chosen;
    return SweepLaw{0.51, {0.48, 0.54}, 0.5, {0.49, 0.51}, 1, chosen.size()};
  };
  auto outcomes = check({expectation}, rows, fit);
  EXPECT_EQ(asked, (std::vector<std::size_t>{2, 4, 6}));
  ASSERT_EQ(outcomes.size(), 1u);
  EXPECT_EQ(outcomes[0].claim, "energy, a, double, h = 0.02 … 0.08: grows as h^p t^q with p = 0.5 ± 0.05");
  expectation.where.step_range = Interval{0.1, 0.2};
  EXPECT_EQ(check({expectation}, rows, no_sweep)[0].claim, "energy where method = a, step = 0.1 … 0.2");
}

TEST_F(ExpectStepExponent, FailsWhereNoLawCanBeFitted) {
  auto const fit = [](std::vector<std::size_t> const&) -> SweepLaw { throw InputError("all errors are zero"); };
  auto const outcomes = check({expectation}, rows, fit);
  ASSERT_EQ(outcomes.size(), 2u);
  EXPECT_FALSE(outcomes[1].passed);
  EXPECT_EQ(outcomes[1].found, "all errors are zero");
}

TEST_F(ExpectStepExponent, NeedsThreeSteps) {
  rows.resize(4);
  auto const outcomes = check({expectation}, rows, no_sweep);
  ASSERT_EQ(outcomes.size(), 2u);
  EXPECT_FALSE(outcomes[0].passed);
  EXPECT_THAT(outcomes[0].found, HasSubstr("at least three steps; here is 2"));
}

}  // namespace
}  // namespace brouwer
