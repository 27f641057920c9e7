// Claims that are proven, claims about failures, and many claims at once.
#include <gmock/gmock.h>

#include <cmath>

#include "analysis/expectations/correct.hpp"
#include "analysis/expectations/expectations.hpp"
#include "analysis/growth/sweep.hpp"
#include "analysis/pages/increments_table.hpp"
#include "analysis/pages/tables.hpp"
#include "tests/analysis/presented_estimates.hpp"

namespace brouwer {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Wanted = Expectation::DriftWanted;

Estimates walk(double p = 0.6) {
  auto row = presented_estimates("three", "energy", 0);
  row.drift.p = p;
  return row;
}

Estimates drifting() { return presented_estimates("naive", "energy", -2.31e-17); }

Expectation smaller_than(double bound) {
  Expectation expectation;
  expectation.of = "energy";
  expectation.drift = Wanted::smaller_than;
  expectation.drift_bound = bound;
  return expectation;
}

Expectation no_drift() {
  Expectation expectation;
  expectation.of = "energy";
  expectation.drift = Wanted::none;
  return expectation;
}

Expectation failing_at_most(std::int64_t members) {
  Expectation expectation;
  expectation.of = "energy";
  expectation.failed = members;
  return expectation;
}

std::vector<Outcome> checked(std::vector<Expectation> const& expectations, std::vector<Estimates> const& rows,
                             Correction correction = Correction::none) {
  return check(expectations, rows, {}, correction);
}

Outcome only(Expectation const& expectation, Estimates const& row) { return checked({expectation}, {row}).at(0); }

// The standard error of these estimates is 7.3e-19/4.778 = 1.53e-19; t(63) is 3.225 at 0.001, one-sided: 4.93e-19.

TEST(ExpectSmallDrift, IsProvenWhereTheIntervalLiesInside) {
  auto const outcome = only(smaller_than(5e-19), walk());
  EXPECT_TRUE(outcome.passed) << outcome.found;
  EXPECT_EQ(outcome.claim, "energy, three, double, h = 0.01: |drift| < 5.00e-19 per step, proven at level 0.001");
  EXPECT_THAT(outcome.found,
              AllOf(HasSubstr("t = 3.27 from −δ, 3.27 from δ"), HasSubstr("99.8 % interval −4.9e-19 … 4.9e-19"),
                    HasSubstr("the smallest δ proven is 4.9e-19")));
}

TEST(ExpectSmallDrift, IsNotProvenByNotSeeingOne) {
  EXPECT_FALSE(only(smaller_than(4.8e-19), walk()).passed);
  EXPECT_FALSE(only(smaller_than(1e-17), drifting()).passed);
  EXPECT_TRUE(only(smaller_than(3e-17), drifting()).passed);
}

TEST(ExpectSmallDrift, IsTestedAtItsOwnLevel) {
  auto expectation = smaller_than(4e-19);
  expectation.level = 0.05;  // t(63) is 1.669: 2.55e-19
  EXPECT_TRUE(only(expectation, walk()).passed);
  EXPECT_THAT(only(expectation, walk()).found, HasSubstr("90 % interval"));
}

TEST(ExpectSmallDrift, FailsWhereThereIsNoTest) {
  auto row = walk();
  row.smallest_visible_drift = std::nan("");
  EXPECT_FALSE(only(smaller_than(1), row).passed);
  row.count = Counted{};
  EXPECT_THAT(only(smaller_than(1), row).found, HasSubstr("is a count"));
}

TEST(ExpectFailed, CountsMembersThatAreLeftOut) {
  auto row = walk();
  EXPECT_TRUE(only(failing_at_most(0), row).passed);
  EXPECT_THAT(only(failing_at_most(0), row).claim, HasSubstr("no member failed"));
  row.failed = 3;
  EXPECT_FALSE(only(failing_at_most(0), row).passed);
  EXPECT_THAT(only(failing_at_most(0), row).found, HasSubstr("3 of 67"));
  EXPECT_FALSE(only(failing_at_most(2), row).passed);
  EXPECT_TRUE(only(failing_at_most(3), row).passed);
}

// --- many claims at once --------------------------------------------------------------------------

/// One p of 0.0004 among five that are nothing.
std::vector<Estimates> six_walks() {
  std::vector<Estimates> rows;
  for (double const p : {0.3, 0.0004, 0.9, 0.5, 0.2, 0.7}) rows.push_back(walk(p));
  return rows;
}

TEST(ManyClaims, AreCorrectedTogether) {
  auto const alone = checked({no_drift()}, six_walks()), holm = checked({no_drift()}, six_walks(), Correction::holm);
  EXPECT_FALSE(alone[1].passed);
  EXPECT_TRUE(holm[1].passed);  // 6 · 0.0004
  EXPECT_THAT(holm[1].found, HasSubstr("; adjusted for 6 tests (holm): p = 0.0024"));
  EXPECT_THAT(alone[1].found, Not(HasSubstr("adjusted")));
}

TEST(ManyClaims, ThatADriftMustBeSeenAreHarderToMeet) {
  auto seen = no_drift();
  seen.drift = Wanted::band;
  seen.drift_band = {1e-20, 1e-18};
  auto rows = six_walks();
  for (auto& row : rows) row.drift.per_step = 1e-19;
  EXPECT_TRUE(checked({seen}, rows)[1].passed);
  EXPECT_FALSE(checked({seen}, rows, Correction::fdr)[1].passed);
}

TEST(ManyClaims, OfOtherKindsAreNoTests) {
  auto growth = no_drift();
  growth.drift = Wanted::unsaid;
  growth.growth = Around{0.5, 0.1};
  auto const outcomes = checked({no_drift(), growth}, six_walks(), Correction::holm);
  EXPECT_EQ(outcomes.size(), 12u);
  EXPECT_THAT(outcomes[1].found, HasSubstr("6 tests"));
  EXPECT_THAT(outcomes[7].found, Not(HasSubstr("adjusted")));
}

TEST(ManyDrifts, AreSeenByTheirAdjustedP) {
  auto rows = six_walks();
  for (auto& row : rows) row.growth = {0.9, {0.85, 0.95}};  // judged by the drift alone
  correct(rows, Correction::none);
  EXPECT_FALSE(rows[1].drift.p_alone);
  rows[1].drift.p = 1e-5;
  correct(rows, Correction::holm);
  EXPECT_EQ(rows[1].drift.p_alone, 1e-5);
  EXPECT_DOUBLE_EQ(rows[1].drift.p, 6e-5);
  EXPECT_EQ(rows[1].verdict, Verdict::drift);
  EXPECT_THAT(rows[1].sentence, HasSubstr("p = 1.0e-5, adjusted p = 6.0e-5"));
  rows[1].drift.p_alone = 0.0004;
  correct(rows, Correction::holm);
  EXPECT_DOUBLE_EQ(rows[1].drift.p, 0.0024);
  EXPECT_NE(rows[1].verdict, Verdict::drift);
  EXPECT_EQ(rows[1].levels.correction, Correction::holm);
}

TEST(ManyDrifts, AreTabulatedWithBoth) {
  auto rows = six_walks();
  correct(rows, Correction::fdr);
  auto const json = render_table(rows, TableFormat::json);
  EXPECT_THAT(json, AllOf(HasSubstr("\"p\": 0.00040000000000000002, "), HasSubstr("\"p_adjusted\": 0.0024"),
                          HasSubstr("\"correction\": \"fdr\"")));
  auto const table = decisions_table(rows, CellsAs::columns);
  EXPECT_THAT(table.legend.back(), HasSubstr("corrected for 6 drifts (fdr)"));
  EXPECT_EQ(table.rows[1].words.back(), "0.0024");
}

}  // namespace
}  // namespace brouwer
