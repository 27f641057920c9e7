// The decision table of the verdict, line by line, and what its sentences say.
#include "analysis/verdict/verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace brouwer {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A plain random walk, from which every case differs in what matters to it.
Estimates walk() {
  Estimates e;
  e.quantity = "energy";
  e.members = 64;
  e.samples = 3;
  e.times = {1, 100, 10'000};
  e.rms = {1.9e-16, 1.9e-15, 1.9e-14};
  e.mean = {1e-17, -1e-16, 5e-16};
  e.mean_error = {2.4e-17, 2.4e-16, 2.4e-15};
  e.rms_final = 1.9e-14;
  e.drift = {5e-20, {-4e-19, 5e-19}, 0.2, 0.84, 0.03};
  e.persistence = {0, 1.05, 0.4, 0.6};
  e.diffusion = {1.9e-16, {1.8e-16, 2e-16}};
  e.growth = {0.5, {0.47, 0.53}};
  e.smallest_visible_drift = 6e-19;
  return e;
}

Estimates bounded() {
  Estimates e = walk();
  e.rms = {1e-16, 1e-16, 1e-16};
  e.mean = {1e-17, 1e-17, 1e-17};
  e.mean_error = {1e-17, 1e-17, 1e-17};
  e.persistence = {0, 0.01, 1, 1e-50};
  e.growth = {0.01, {-0.02, 0.03}};
  return e;
}

TEST(Verdict, RandomWalkAroundOneHalf) { EXPECT_EQ(verdict_of(walk()), Verdict::random_walk); }

TEST(Verdict, RandomWalkWhenTheIntervalLiesNearOneHalfWithoutHoldingIt) {
  auto e = walk();
  e.growth = {0.56, {0.53, 0.59}};
  EXPECT_EQ(verdict_of(e), Verdict::random_walk);
  e.growth = {0.58, {0.55, 0.61}};
  EXPECT_EQ(verdict_of(e), Verdict::not_resolved);
}

TEST(Verdict, DriftWhenTheTTestSaysSo) {
  auto e = walk();
  e.drift.p = 9e-4;
  EXPECT_EQ(verdict_of(e), Verdict::drift);
  e.levels.test = 1e-4;
  EXPECT_EQ(verdict_of(e), Verdict::random_walk);
}

TEST(Verdict, PersistentSlopesWhenTheFTestSaysSoAndDriftGoesBefore) {
  auto e = walk();
  e.persistence = {3e-18, 13, 1e-20, 1};
  EXPECT_EQ(verdict_of(e), Verdict::persistent_slopes);
  e.drift.p = 1e-9;
  EXPECT_EQ(verdict_of(e), Verdict::drift);
}

TEST(Verdict, SuperlinearGoesBeforeDriftAndPersistence) {
  auto e = walk();
  e.growth = {1.48, {1.45, 1.51}};
  e.persistence = {3e-18, 13, 1e-20, 1};
  EXPECT_EQ(verdict_of(e), Verdict::faster_than_drift);
  e.drift.p = 1e-9;
  EXPECT_EQ(verdict_of(e), Verdict::faster_than_drift);
  EXPECT_THAT(sentence_of(e, verdict_of(e)), HasSubstr("a drift is seen as well"));
  e.growth.interval.low = 1.1;
  EXPECT_EQ(verdict_of(e), Verdict::drift);
}

TEST(Verdict, BoundedNeedsASmallFAndAFlatRms) {
  EXPECT_EQ(verdict_of(bounded()), Verdict::bounded);
  auto e = bounded();
  e.persistence.F = 0.6;
  EXPECT_NE(verdict_of(e), Verdict::bounded);
  e = bounded();
  e.growth.interval.high = 0.3;
  EXPECT_NE(verdict_of(e), Verdict::bounded);
  e = bounded();
  e.rms.back() = 1.7e-16;  // ratio of mean squares 2.9: F(64, 64) exceeds it with probability 2e-5
  EXPECT_EQ(verdict_of(e), Verdict::not_resolved);
}

TEST(Verdict, BoundedLooksForGrowthBetweenTwoSamplesToo) {
  auto e = bounded();
  e.times = {1, 10'000};
  e.rms = {1e-16, 1e-16};
  e.mean = e.mean_error = {1e-17, 1e-17};
  e.samples = 2;
  EXPECT_EQ(verdict_of(e), Verdict::bounded);
  e.rms.back() = 1.7e-16;
  EXPECT_NE(verdict_of(e), Verdict::bounded);
}

TEST(Verdict, ASignificantTIsNoDriftWhileABoundedErrorsMeanStays) {
  auto e = bounded();
  e.drift.p = 1e-9;  // an offset, the same at the end as before
  EXPECT_EQ(verdict_of(e), Verdict::bounded);
  e.mean.back() = 9e-17;  // an oscillation that all share, perhaps: F and the exponent contradict a drift
  EXPECT_EQ(verdict_of(e), Verdict::not_resolved);
}

TEST(Verdict, AWalkFarBelowItsIncrementsIsNotResolved) {
  auto e = walk();
  e.persistence = {0, 0.05, 1, 1e-30};
  EXPECT_EQ(verdict_of(e), Verdict::not_resolved);
  EXPECT_THAT(sentence_of(e, verdict_of(e)), HasSubstr("a bounded part"));
}

/// The law that a bounded part hides from F and the exponent, as the full model tells it.
Estimates walk_beside_noise() {
  auto e = walk();
  e.samples = 8;
  e.growth = {0.1, {0.08, 0.12}};
  e.persistence = {0, 0.05, 1, 1e-30};
  e.noise = {3e-15, {2.9e-15, 3.1e-15}};
  e.model = FullModel{{{{true, false, true}}}};
  return e;
}

TEST(Verdict, BesideBoundedNoiseIsTheFullModels) {
  auto e = walk_beside_noise();
  EXPECT_EQ(verdict_of(e), Verdict::random_walk);
  EXPECT_THAT(
      sentence_of(e, verdict_of(e)),
      HasSubstr(
          "told apart from bounded noise of 3.00e-15 (95 %: 2.90e-15 … 3.10e-15) by restricted maximum likelihood"));
  e.model->candidates[0].terms.slopes = true;
  EXPECT_EQ(verdict_of(e), Verdict::not_resolved) << "in the law, but not seen";
  e.model->p_slopes = 1e-5;
  EXPECT_EQ(verdict_of(e), Verdict::persistent_slopes);
  EXPECT_THAT(sentence_of(e, verdict_of(e)), HasSubstr("likelihood ratio, p = "));
  e.drift.p = 1e-9;
  EXPECT_EQ(verdict_of(e), Verdict::drift);
}

TEST(Verdict, BesideNoiseNeedsTimesAndAModelThatNothingContradicts) {
  auto const without = [](auto&& change) {
    auto e = walk_beside_noise();
    change(e);
    return verdict_of(e);
  };
  EXPECT_EQ(without([](Estimates& e) { e.samples = 7; }), Verdict::not_resolved);
  EXPECT_EQ(without([](Estimates& e) { e.members = 7; }), Verdict::not_resolved);
  EXPECT_EQ(without([](Estimates& e) { e.model->p_course = 1e-4; }), Verdict::not_resolved);
  EXPECT_EQ(without([](Estimates& e) { e.model->p_end = 1e-4; }), Verdict::not_resolved);
}

TEST(Verdict, ASlopeThatTheBeginningMakesIsNoDrift) {
  auto e = walk();
  e.drift.p = 1e-9;
  e.transient = Transient{100, 1e-12, {1e-20, {-4e-19, 4e-19}, 0.1, 0.9, 0}};
  EXPECT_EQ(verdict_of(e), Verdict::random_walk);
  EXPECT_THAT(sentence_of(e, verdict_of(e)), HasSubstr("is no drift: it comes from the beginning"));
  e.transient->after.p = 1e-5;
  EXPECT_EQ(verdict_of(e), Verdict::drift);
}

TEST(Verdict, FewMembersSupportTestsOfSlopesButNoLawOfGrowth) {
  auto e = walk();
  e.members = 7;
  EXPECT_EQ(verdict_of(e), Verdict::not_resolved);
  EXPECT_THAT(sentence_of(e, verdict_of(e)), HasSubstr("7 members are too few"));
  e.growth = {1.5, {1.4, 1.6}};
  EXPECT_EQ(verdict_of(e), Verdict::not_resolved);
  e.drift.p = 1e-9;
  EXPECT_EQ(verdict_of(e), Verdict::drift);
}

TEST(Verdict, AWideIntervalIsNotResolvedAndSaysHowManyMembersAreNeeded) {
  auto e = walk();
  e.growth = {0.5, {0.2, 0.8}};
  EXPECT_EQ(verdict_of(e), Verdict::not_resolved);
  EXPECT_THAT(sentence_of(e, verdict_of(e)), HasSubstr("about 580 members"));  // 64 · (0.3/0.1)² = 576
}

TEST(Verdict, ExactGoesBeforeEverything) {
  auto e = walk();
  e.rms = {0, 0, 0};
  e.members = 1;
  EXPECT_EQ(verdict_of(e), Verdict::exact);
}

TEST(Verdict, ACountHasNoLawWhateverItsNumbersAre) {
  auto e = walk();
  e.drift.p = 1e-9;
  e.count = {14.21, {13.9, 14.6}};
  e.unit = "iterations per step";
  EXPECT_EQ(verdict_of(e), Verdict::count);
  EXPECT_EQ(sentence_of(e, Verdict::count),
            "Count: 14.2 iterations per step in the mean (13.9 … 14.6 over members and samples).");
}

TEST(Verdict, OneMemberIsNeverResolved) {
  auto e = walk();
  e.members = 1;
  e.drift.p = e.persistence.p = e.smallest_visible_drift = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(verdict_of(e), Verdict::not_resolved);
  EXPECT_THAT(sentence_of(e, verdict_of(e)), HasSubstr("one member only"));
}

TEST(Verdict, EveryVerdictHasItsWord) {
  EXPECT_EQ(to_string(Verdict::exact), "exact");
  EXPECT_EQ(to_string(Verdict::random_walk), "random walk");
  EXPECT_EQ(to_string(Verdict::persistent_slopes), "persistent slopes");
  EXPECT_EQ(to_string(Verdict::drift), "drift");
  EXPECT_EQ(to_string(Verdict::bounded), "bounded");
  EXPECT_EQ(to_string(Verdict::faster_than_drift), "superlinear");
  EXPECT_EQ(to_string(Verdict::not_resolved), "not resolved");
  EXPECT_EQ(to_string(Verdict::count), "count");
}

class EverySentence : public testing::TestWithParam<Verdict> {};

TEST_P(EverySentence, NamesTheVerdictAndTheSmallestVisibleDrift) {
  auto const sentence = sentence_of(walk(), GetParam());
  auto word = to_string(GetParam());
  EXPECT_EQ(sentence.substr(1, word.size() - 1), word.substr(1));
  EXPECT_THAT(
      sentence,
      HasSubstr("the smallest drift this ensemble could have seen is 6.0e-19 per step (level 0.001, chance 0.9)."));
}
INSTANTIATE_TEST_SUITE_P(OfAnyVerdict, EverySentence,
                         testing::Values(Verdict::exact, Verdict::random_walk, Verdict::persistent_slopes,
                                         Verdict::drift, Verdict::bounded, Verdict::faster_than_drift,
                                         Verdict::not_resolved));

TEST(Sentence, OfADriftGivesItsIntervalTestAndShare) {
  auto e = walk();
  e.drift = {-2.3e-17, {-2.4e-17, -2.2e-17}, -457, 0, 0.97};
  EXPECT_EQ(
      sentence_of(e, Verdict::drift),
      "Drift: the error grows on average by −2.30e-17 per step (95 %: −2.40e-17 … −2.20e-17; t = −457, p < 1e-300), "
      "which is 97 % of the final RMS 1.9e-14; beside it the error spreads by 1.90e-16 per √step (95 %: 1.80e-16 … "
      "2.00e-16); the smallest drift this ensemble could have seen is 6.0e-19 per step (level 0.001, chance 0.9).");
}

TEST(Sentence, SaysThatMembersFailed) {
  auto e = walk();
  e.failed = 3;
  EXPECT_THAT(sentence_of(e, Verdict::random_walk), testing::EndsWith("; 3 of 67 members failed and are left out."));
}

TEST(Sentence, SaysWhyTheyFailed) {
  auto e = walk();
  e.failed = 3;
  e.failures = {{"the iteration did not converge", 2, 1200}, {"collision", 1, 17}};
  EXPECT_THAT(sentence_of(e, Verdict::random_walk),
              testing::EndsWith("; 3 of 67 members are left out: 2 because the iteration did not converge (the first "
                                "at step 1200), 1 because of a collision (at step 17)."));
  e.failed = 1;
  e.failures = {{"escape", 1, 17}};
  EXPECT_THAT(sentence_of(e, Verdict::random_walk),
              testing::EndsWith("; 1 of 65 members is left out because of an escape (at step 17)."));
  e.failed = 4;
  e.failures = {{"", 3, -1}, {"escape", 1, 17}};
  EXPECT_THAT(sentence_of(e, Verdict::random_walk),
              HasSubstr("4 of 68 members are left out: 3 because an error is not finite, 1 because of an escape"));
}

TEST(Sentence, SpeaksOfTheUnitOfTimeThatTheEnsembleHas) {
  auto e = walk();
  e.time_unit = "time unit";
  auto const sentence = sentence_of(e, Verdict::random_walk);
  EXPECT_THAT(sentence, HasSubstr("per √(time unit)"));
  EXPECT_THAT(sentence, HasSubstr("6.0e-19 per time unit"));
}

}  // namespace
}  // namespace brouwer
