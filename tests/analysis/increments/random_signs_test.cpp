// Sums of random signs, against all choices of signs.
#include "analysis/increments/random_signs.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "analysis/increments/pearson.hpp"

namespace brouwer {
namespace {

/// The share of all choices of signs of `a` for which the statistic is at least x, and at most x.
template <class Statistic>
BothTails over_all_signs(Eigen::ArrayXd const& a, double x, Statistic statistic) {
  auto const choices = 1u << static_cast<unsigned>(a.size());
  BothTails count{0, 0};
  for (unsigned choice = 0; choice < choices; ++choice) {
    Eigen::ArrayXd signed_a = a;
    for (Eigen::Index k = 0; k < a.size(); ++k)
      if ((choice >> static_cast<unsigned>(k)) & 1u) signed_a[k] = -a[k];
    double const value = statistic(signed_a);
    count.lower += value <= x + 1e-9 ? 1. / choices : 0;
    count.upper += value >= x - 1e-9 ? 1. / choices : 0;
  }
  return count;
}

double p_of(BothTails const& tails) { return std::min(1.0, 2 * std::min(tails.lower, tails.upper)); }

Eigen::ArrayXd sizes(int count, unsigned seed) {
  std::mt19937 generator(seed);
  Eigen::ArrayXd a(count);
  for (auto& x : a) x = static_cast<double>(generator() % 2000 + 1) / 1000;
  return a;
}

TEST(RandomSigns, AreCountedWhereTheyAreFew) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    auto const a = sizes(7, seed);
    for (double const x : {0.0, 1.3, -2.2, a.sum()}) {
      RandomSigns sum(7);
      sum.add_sum(a);
      auto const expected = p_of(over_all_signs(a, x, [](auto const& s) { return s.sum(); }));
      EXPECT_NEAR(sum.two_sided(x), std::max(expected, std::exp2(-6)), 1e-12) << seed << " " << x;
    }
  }
}

TEST(RandomSigns, OfASquareAreCountedToo) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    auto const a = sizes(6, seed);
    auto const square = [](auto const& s) { return s.sum() * s.sum() - s.square().sum(); };
    RandomSigns signs(5);
    signs.add_square(a);
    EXPECT_NEAR(signs.two_sided(square(a)), p_of(over_all_signs(a, square(a), square)), 1e-12);
  }
}

/// Where a part of 20 signs is fitted, the tail is that of all million choices to 4 % of itself, from 0.3 to 0.001.
TEST(RandomSigns, AreFittedWhereTheyAreMany) {
  auto const a = sizes(20, 3);
  RandomSigns sum(20);
  sum.add_sum(a);
  double const deviation = std::sqrt(a.square().sum());
  for (double const z : {1.0, 1.5, 2.0, 2.5, 3.0, 3.3}) {
    auto const expected = p_of(over_all_signs(a, z * deviation, [](auto const& s) { return s.sum(); }));
    EXPECT_NEAR(sum.two_sided(z * deviation) / expected, 1, 0.04) << z;
  }
}

TEST(RandomSigns, OfSquaresAreFittedWhereTheyAreMany) {
  auto const a = sizes(20, 4);
  auto const statistic = [](auto const& s) {
    double sum = 0;
    for (int block = 0; block < 5; ++block) {
      double const total = s.segment(4 * block, 4).sum();
      sum += total * total - s.segment(4 * block, 4).square().sum();
    }
    return sum;
  };
  RandomSigns signs(15);
  for (int block = 0; block < 5; ++block) signs.add_square(a.segment(4 * block, 4));
  for (double const x : {8.0, 15.0, 25.0, -12.0, 35.0}) {
    double const expected = p_of(over_all_signs(a, x, statistic));
    ASSERT_GT(expected, 1e-3) << x;
    EXPECT_NEAR(signs.two_sided(x) / expected, 1, 0.1) << x;
  }
}

TEST(RandomSigns, OfNothingGiveNoTest) {
  RandomSigns sum(2);
  sum.add_sum(Eigen::ArrayXd::Zero(2));
  EXPECT_TRUE(std::isnan(sum.two_sided(0)));
}

TEST(Pearson, HoldsTheLawsThatItIsMadeOf) {
  EXPECT_NEAR(pearson_tails(1.959963984540054, 0, 0).upper, 0.025, 1e-12);
  // χ²(4): skewness √2, excess 3; 9.487729 is exceeded with 0.05
  EXPECT_NEAR(pearson_tails((9.487729036781154 - 4) / std::sqrt(8.), std::sqrt(2.), 3).upper, 0.05, 1e-12);
  EXPECT_NEAR(pearson_tails(-(9.487729036781154 - 4) / std::sqrt(8.), -std::sqrt(2.), 3).lower, 0.05, 1e-12);
  // uniform on ±√3: excess −6/5
  EXPECT_NEAR(pearson_tails(0.9 * std::sqrt(3.), 0, -1.2).upper, 0.05, 1e-12);
  EXPECT_EQ(pearson_tails(1.01 * std::sqrt(3.), 0, -1.2).upper, 0);
}

}  // namespace
}  // namespace brouwer
