// Members far from all others: found, named, set aside where they are few, and never without a word.
#include "analysis/growth/far_off.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/growth/inference.hpp"
#include "analysis/pages/tables.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Ensemble walks(int members = 64) { return simulated({.diffusion = 2e-16}, members, log_spaced(16, 1e4), 1959ul); }

/// These members drift, a thousand times a walk's slope.
Ensemble with_wild(std::vector<Eigen::Index> const& rows) {
  auto ensemble = walks();
  for (auto const row : rows)
    ensemble.errors.row(row) += 2e-15 * Eigen::Map<Eigen::RowVectorXd>(ensemble.times.data(), 16);
  return ensemble;
}

TEST(FarOff, AreNamedAndSetAsideAndBothDriftsAreSaid) {
  auto const e = estimate(with_wild({17, 40}), {});
  EXPECT_THAT(e.far_off.members, ElementsAre("17", "40"));
  EXPECT_TRUE(e.far_off.set_aside);
  EXPECT_EQ(e.members, 62);
  EXPECT_EQ(e.verdict, Verdict::random_walk);
  EXPECT_THAT(e.sentence,
              HasSubstr("2 members lie far outside the others (17, 40) and are set aside; with them: drift "));
  EXPECT_GT(e.far_off.drift.per_step, 10 * std::abs(e.drift.per_step));
}

TEST(FarOff, LeaveTheOthersEstimatesAsIfTheyHadNeverBeen) {
  auto ensemble = with_wild({17, 40});
  auto const e = estimate(ensemble, {}), alone = estimate(without(ensemble, {17, 40}), {});
  EXPECT_EQ(e.drift.per_step, alone.drift.per_step);
  EXPECT_EQ(e.diffusion.interval.high, alone.diffusion.interval.high);
  EXPECT_EQ(e.growth.exponent, alone.growth.exponent);
}

TEST(FarOff, HaveTheNamesThatTheEnsembleGivesThem) {
  auto ensemble = with_wild({3});
  for (int i = 0; i < 64; ++i) ensemble.names.push_back("body " + std::to_string(100 + i));
  EXPECT_THAT(estimate(ensemble, {}).far_off.members, ElementsAre("body 103"));
}

TEST(FarOff, ShowInTheirOwnWalkAsWell) {
  auto ensemble = walks();
  ensemble.errors.row(5) *= 20;
  ensemble.errors(5, 15) = ensemble.errors(6, 15);  // it ends among the others
  EXPECT_THAT(estimate(ensemble, {}).far_off.members, ElementsAre("5"));
}

TEST(FarOff, OfAPopulationOfTheirOwnAreSaidAndKept) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < 64; i += 5) rows.push_back(i);  // 13 of 64
  auto const e = estimate(with_wild(rows), {});
  EXPECT_EQ(e.far_off.members.size(), 13u);
  EXPECT_FALSE(e.far_off.set_aside);
  EXPECT_EQ(e.members, 64);
  EXPECT_THAT(e.sentence, HasSubstr("20 % of all, a population of their own and not set aside"));
}

TEST(FarOff, StandInTablesAndJson) {
  auto const e = estimate(with_wild({17, 40}), {});
  EXPECT_THAT(render_table({e}, TableFormat::text), HasSubstr("62 of 64 members"));
  EXPECT_THAT(render_table({e}, TableFormat::text), HasSubstr("2 members lie far outside"));
  EXPECT_THAT(render_table({e}, TableFormat::json),
              HasSubstr(R"("far_off": {"members": ["17", "40"], "set_aside": true)"));
}

TEST(FarOff, AreNoneOfAHandfulOrWhereMostMembersAreEqual) {
  auto few = simulated({.diffusion = 1}, 7, log_spaced(8, 1e3), 2ul);
  few.errors.row(0) *= 1000;
  EXPECT_TRUE(estimate(few, {}).far_off.members.empty());
  auto equal = walks();
  equal.errors.topRows(40).setConstant(1e-16);
  EXPECT_TRUE(estimate(equal, {}).far_off.members.empty());
}

class CleanEnsembles : public testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(CleanEnsembles, RaiseHardlyAnAlarmHoweverHeavyTheirTails) {
  auto const [members, heavy] = GetParam();
  Normal normal(11);
  int alarms = 0;
  for (int k = 0; k < 500; ++k) {
    auto const ensemble =
        simulated({.diffusion = 1, .shape = heavy ? student_5 : normal_shape}, members, log_spaced(16, 1e4), normal);
    alarms += !far_off_members(ensemble, units_of(ensemble)).empty();
  }
  EXPECT_LE(alarms, heavy ? 20 : 10);
}
INSTANTIATE_TEST_SUITE_P(NormalAndHeavy, CleanEnsembles,
                         testing::Combine(testing::Values(8, 32, 256), testing::Bool()));

}  // namespace
}  // namespace brouwer
