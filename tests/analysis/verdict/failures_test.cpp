// Members in words: how many there are, how many were run, how many are still to come.
#include "analysis/verdict/failures.hpp"

#include <gtest/gtest.h>

#include "tests/analysis/presented_estimates.hpp"

namespace brouwer {
namespace {

TEST(Unfinished, IsToldInMembersOfAllCells) {
  EXPECT_EQ(unfinished_in_words(900, 300, 14), "unfinished: 900 of 4200 members in 14 cells");
  EXPECT_EQ(unfinished_in_words(99, 100, 1), "unfinished: 99 of 100 members in 1 cell");
  EXPECT_EQ(unfinished_in_words(4200, 300, 14), "");
}

TEST(Members, AreThoseThatWereRun) {
  auto e = presented_estimates("elliptic-naive", "energy", 0);
  EXPECT_EQ(members_in_words(e), "64 members");
  auto fewer = e;
  fewer.members = 39, fewer.failed = 61;
  EXPECT_EQ(members_in_words(fewer), "39 of 100 members");
  EXPECT_FALSE(same_members(e, fewer));
  fewer.members = 64;
  EXPECT_FALSE(same_members(e, fewer)) << "64 of 64 are not 64 of 125";
}

}  // namespace
}  // namespace brouwer
