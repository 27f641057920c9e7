// What passes for a good result and is none: each guard fails on the thing it guards against, and on nothing else.
#include "analysis/expectations/guards.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/growth/inference.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A planet and its sun in three dimensions, the barycentre at rest in 0: `members` orbits, each a little different.
UnitRecord two_bodies(std::int64_t members) {
  UnitRecord unit;
  unit.members = members;
  for (auto const* body : {"sun", "planet"})
    for (auto const* axis : {"-x", "-y", "-z"}) unit.state_names.push_back(body + std::string(axis));
  for (auto const* body : {"sun", "planet"})
    for (auto const* axis : {"-vx", "-vy", "-vz"}) unit.state_names.push_back(body + std::string(axis));
  unit.start_names = {"masses-1", "masses-2"};
  unit.start_names.insert(unit.start_names.end(), unit.state_names.begin(), unit.state_names.end());
  for (std::int64_t i = 0; i < members; ++i) {
    double const radius = 1 + 1e-6 * static_cast<double>(i);
    unit.start.insert(unit.start.end(), {9, 1, -0.1 * radius, 0, 0, 0.9 * radius, 0, 0, 0, -0.1, 0, 0, 0.9, 0});
    unit.final_state.insert(unit.final_state.end(), {0, -0.1 * radius, 0, 0, 0.9 * radius, 0, 0.1, 0, 0, -0.9, 0, 0});
  }
  return unit;
}

std::size_t constexpr width = 12;

Estimates row(Law const& law, int members) { return estimate(simulated(law, members, log_spaced(16, 1000), 5), {}); }

GuardedCell good_cell(std::int64_t members = 8) {
  return {{}, {two_bodies(members)}, {row({.diffusion = 1e-16}, static_cast<int>(members))}};
}

/// The claims of the guards that fail.
std::vector<std::string> failing(GuardedCell const& cell) {
  std::vector<std::string> claims;
  for (auto const& outcome : check_guards({cell}))
    if (!outcome.passed) claims.push_back(outcome.claim.substr(outcome.claim.find(": ") + 2));
  return claims;
}

std::string found(GuardedCell const& cell) {
  for (auto const& outcome : check_guards({cell}))
    if (!outcome.passed) return outcome.found;
  return "nothing";
}

TEST(Guards, HoldWhereNothingIsWrong) {
  auto const outcomes = check_guards({good_cell(), good_cell(2)});
  EXPECT_EQ(outcomes.size(), 5U);
  for (auto const& outcome : outcomes) EXPECT_TRUE(outcome.passed) << outcome.claim << ": " << outcome.found;
  EXPECT_EQ(outcomes.front().found, "in 2 cells");
}

TEST(Guards, SeeAFrozenState) {
  auto cell = good_cell();
  auto& unit = cell.units.front();
  for (std::size_t i = 0; i < 8; ++i)
    std::copy_n(unit.start.begin() + static_cast<std::ptrdiff_t>(i * (width + 2) + 2), width,
                unit.final_state.begin() + static_cast<std::ptrdiff_t>(i * width));
  EXPECT_THAT(failing(cell), ElementsAre("the state has moved"));
  EXPECT_THAT(found(cell), HasSubstr("8 of 8 members end where they began"));
  unit.final_state[3] = std::nextafter(unit.final_state[3], 2);  // one ulp is no motion
  EXPECT_THAT(failing(cell), ElementsAre("the state has moved"));
}

TEST(Guards, TakeAReturnAfterOnePeriodForMotion) {
  auto cell = good_cell();
  auto& unit = cell.units.front();
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t c = 0; c < width; ++c)
      unit.final_state[i * width + c] = unit.start[i * (width + 2) + 2 + c] + 1e-13 * (c % 3 == 0 ? 1 : 0);
  EXPECT_THAT(failing(cell), IsEmpty()) << "round-off alone tells that it was integrated";
}

TEST(Guards, SeeAFrameThatDrifts) {
  auto cell = good_cell();
  for (std::size_t c : {0U, 3U}) cell.units.front().final_state[c] += 0.01;
  EXPECT_THAT(failing(cell), ElementsAre("the frame rests"));
  EXPECT_THAT(found(cell), HasSubstr("the barycentre moved by 0.011 of the system's radius"));
  auto slow = good_cell();
  for (std::size_t c : {0U, 3U}) slow.units.front().final_state[c] += 1e-6;
  EXPECT_THAT(failing(slow), IsEmpty());
}

TEST(Guards, AskNoBarycentreOfAPendulum) {
  auto cell = good_cell();
  auto& unit = cell.units.front();
  unit.state_names = {"angle-1", "angle-2", "p1", "p2"};
  unit.start_names = {"masses-1", "masses-2", "angle-1", "angle-2", "p1", "p2"};
  unit.members = 1;
  unit.start = {1, 1, 0.5, 0.5, 0, 0};
  unit.final_state = {7, 7, 1, 1};
  EXPECT_THAT(failing(cell), IsEmpty());
}

TEST(Guards, SeeMembersThatAreCopies) {
  auto cell = good_cell();
  auto& unit = cell.units.front();
  for (std::size_t i = 1; i < 6; ++i) {
    std::copy_n(unit.start.begin(), width + 2, unit.start.begin() + static_cast<std::ptrdiff_t>(i * (width + 2)));
    std::copy_n(unit.final_state.begin(), width, unit.final_state.begin() + static_cast<std::ptrdiff_t>(i * width));
  }
  EXPECT_THAT(failing(cell), ElementsAre("the members differ"));
  EXPECT_THAT(found(cell), HasSubstr("5 of 8 members are copies of others (the perturbation is missing"));
}

TEST(Guards, CountEqualStartsWithDifferentEndsAsDifferent) {  // rounded stochastically
  auto cell = good_cell();
  auto& unit = cell.units.front();
  for (std::size_t i = 1; i < 8; ++i)
    std::copy_n(unit.start.begin(), width + 2, unit.start.begin() + static_cast<std::ptrdiff_t>(i * (width + 2)));
  EXPECT_THAT(failing(cell), IsEmpty());
}

TEST(Guards, LeaveOutMembersThatFailed) {
  auto cell = good_cell();
  auto& unit = cell.units.front();
  unit.failed_at.assign(8, -1);
  unit.failed_at[0] = 3;
  unit.final_state[0] = std::nan("");
  unit.final_state[width] = std::nan("");  // not recorded, and yet gone
  EXPECT_THAT(failing(cell), IsEmpty());
}

TEST(Guards, SeeStatisticsThatAreInfinite) {
  auto cell = good_cell();
  Ensemble same = simulated({.diffusion = 1}, 8, log_spaced(16, 1000), 5);
  for (auto errors : same.errors.rowwise()) errors = same.errors.row(0).eval();
  cell.rows = {estimate(same, {})};
  EXPECT_THAT(failing(cell), ElementsAre("the statistics are finite"));
  EXPECT_THAT(found(cell), HasSubstr("t of energy is infinite: all 8 members"));
  Ensemble straight = same;
  for (Eigen::Index i = 0; i < 8; ++i)
    for (Eigen::Index j = 0; j < 16; ++j)
      straight.errors(i, j) = static_cast<double>(i) * same.times[static_cast<std::size_t>(j)];
  cell.rows = {estimate(straight, {})};
  EXPECT_THAT(found(cell), HasSubstr("F of energy is infinite"));
}

TEST(Guards, SeeThatMostMembersFailed) {
  auto cell = good_cell();
  cell.rows.front().failed = 9;
  EXPECT_THAT(failing(cell), ElementsAre("most members came through"));
  cell.rows.front().failed = 8;
  EXPECT_THAT(failing(cell), IsEmpty());
}

// --- of another program's numbers -----------------------------------------------------------------

TEST(Doubts, AreFewAboutTheModel) {
  int doubtful = 0;
  for (unsigned long seed = 1; seed <= 200; ++seed)
    for (Law const& law : {Law{.diffusion = 1}, Law{.drift = 1, .diffusion = 1}, Law{.noise = 1}})
      doubtful += !doubts(simulated(law, 16, log_spaced(12, 10'000), seed)).empty();
  EXPECT_EQ(doubtful, 0);
}

TEST(Doubts, SeeAbsoluteValues) {
  int seen = 0;
  for (unsigned long seed = 1; seed <= 200; ++seed) {
    auto ensemble = simulated({.diffusion = 1}, 16, log_spaced(12, 10'000), seed);
    ensemble.errors = ensemble.errors.cwiseAbs().eval();
    seen += !doubts(ensemble).empty();
  }
  EXPECT_GE(seen, 190);  // 196 of these 200
}

TEST(Doubts, SeeCopies) {
  auto ensemble = simulated({.diffusion = 1}, 16, log_spaced(12, 10'000), 3);
  for (Eigen::Index i = 4; i < 16; ++i) ensemble.errors.row(i) = ensemble.errors.row(i % 4).eval();
  EXPECT_THAT(doubts(ensemble), ElementsAre(HasSubstr("12 of 16 members are copies of others")));
  ensemble.errors.setZero();
  EXPECT_THAT(doubts(ensemble), IsEmpty()) << "exact";
}

}  // namespace
}  // namespace brouwer
