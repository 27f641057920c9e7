// Hénon–Heiles: its symmetry, its saddles, its standard start.
#include <brouwer/systems/henon_heiles.hpp>

#include <gtest/gtest.h>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Judge;

HenonHeiles<Judge> const system;

TEST(HenonHeiles, LooksTheSameTurnedByAThirdOfATurn) {
  Judge const c = Judge(-1) / 2, s = sqrt(Judge(3)) / 2;
  auto const turned = [&](std::array<Judge, 2> const& v) {
    return std::array<Judge, 2>{c * v[0] - s * v[1], s * v[0] + c * v[1]};
  };
  std::array<Judge, 2> const q{Judge("0.37"), Judge("-0.21")};
  auto const before = turned(system.force(q)), after = system.force(turned(q));
  for (std::size_t i = 0; i < 2; ++i) EXPECT_LT(abs(Judge(before[i] - after[i])), Judge("1e-75"));
}

TEST(HenonHeiles, HasSaddlesOfTheHeightOneSixthAtTheCornersOfTheTriangle) {
  Judge const x = sqrt(Judge(3)) / 2, y = Judge(-1) / 2;
  for (auto const& q :
       {std::array<Judge, 2>{Judge(0), Judge(1)}, std::array<Judge, 2>{x, y}, std::array<Judge, 2>{Judge(-x), y}}) {
    EXPECT_LT(abs(system.force(q)[0]), Judge("1e-75"));
    EXPECT_LT(abs(system.force(q)[1]), Judge("1e-75"));
    EXPECT_LT(abs(Judge(system.energy({q, {Judge(0), Judge(0)}}) - Judge(1) / 6)), Judge("1e-75"));
  }
}

TEST(HenonHeiles, StartsWithFiveFortyEighths) {
  EXPECT_LT(abs(Judge(system.energy({{Judge(0), Judge("0.25")}, {Judge("0.375"), Judge("0.125")}}) - Judge(5) / 48)),
            Judge("1e-76"));
}

}  // namespace
}  // namespace brouwer
