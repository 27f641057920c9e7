#include "tests/scalar/chosen_rounding.hpp"

#include <gtest/gtest.h>

namespace brouwer {
namespace {

using testing::directed_cases;
using testing::HardPairs;
using testing::Judge;

template <class T>
class ChosenRounding : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ChosenRounding, Scalars);

/// Every directed rounding of f(a, b), 100 000 hard pairs, is MPFR's.
template <class T, class F>
void expect_correct(F f, std::uint64_t seed) {
  HardPairs<T> pairs(seed);
  int wrong = 0;
  for (int i = 0; i < 100'000; ++i) {
    auto const [a, b] = pairs.next();
    Judge const exact = f(Judge(double(a)), Judge(double(b)));
    for (auto const& [rounding, judged] : directed_cases) {
      ContextScope const scope(testing::steps_with({.rounding = rounding}));
      T const found = f(Modelled<T>(a), Modelled<T>(b)).value(), expected = exact.as<T>(judged);
      bool const same = found == expected || (std::isnan(found) && std::isnan(expected));
      if (!same && ++wrong < 5)
        ADD_FAILURE() << std::hexfloat << a << ", " << b << ": " << found << ", expected " << expected << " ("
                      << static_cast<int>(rounding) << ")";
    }
  }
  EXPECT_EQ(wrong, 0);
}

TYPED_TEST(ChosenRounding, OfSumsIsThatOfMpfr) {
  expect_correct<TypeParam>([](auto const& a, auto const& b) { return a + b; }, 1);
}
TYPED_TEST(ChosenRounding, OfDifferencesIsThatOfMpfr) {
  expect_correct<TypeParam>([](auto const& a, auto const& b) { return a - b; }, 2);
}
TYPED_TEST(ChosenRounding, OfProductsIsThatOfMpfr) {
  expect_correct<TypeParam>([](auto const& a, auto const& b) { return a * b; }, 3);
}
TYPED_TEST(ChosenRounding, OfQuotientsIsThatOfMpfr) {
  expect_correct<TypeParam>([](auto const& a, auto const& b) { return a / b; }, 4);
}
TYPED_TEST(ChosenRounding, OfRootsIsThatOfMpfr) {
  expect_correct<TypeParam>([](auto const& a, auto const&) { return sqrt(a); }, 5);
}

/// The share of draws that go up is that of the exact result between its neighbours, within five standard deviations.
template <class T, class F>
void expect_unbiased(F f, std::uint64_t seed) {
  constexpr int draws = 4000;
  HardPairs<T> pairs(seed);
  OperationContext context = testing::steps_with({.rounding = Rounding::stochastic});
  context.random = MemberRandom(seed, 0);
  ContextScope const scope(context);
  double variance_sum = 0, excess_sum = 0;
  for (int i = 0; i < 300; ++i) {
    auto const [a, b] = pairs.next();
    Judge const exact = f(Judge(double(a)), Judge(double(b)));
    T const below = exact.as<T>(MPFR_RNDD), above = exact.as<T>(MPFR_RNDU);
    if (!std::isfinite(below) || !std::isfinite(above)) continue;
    int ups = 0;
    for (int n = 0; n < draws; ++n) {
      T const found = f(Modelled<T>(a), Modelled<T>(b)).value();
      ASSERT_TRUE(found == below || found == above) << std::hexfloat << a << ", " << b << ": " << found;
      ups += found == above ? 1 : 0;
    }
    if (below == above) continue;  // exact: always itself, as asserted
    double const share =
        ((exact - Judge(double(below))) / (Judge(double(above)) - Judge(double(below)))).as<double>(MPFR_RNDN);
    double const variance = draws * share * (1 - share);
    EXPECT_LE(std::abs(ups - draws * share), 5 * std::sqrt(variance) + 2) << std::hexfloat << a << ", " << b;
    variance_sum += variance;
    excess_sum += ups - draws * share;
  }
  ASSERT_GT(variance_sum, 1000);
  EXPECT_LE(std::abs(excess_sum), 4 * std::sqrt(variance_sum));
}

TYPED_TEST(ChosenRounding, AtRandomIsUnbiasedAndLeavesExactResultsAlone) {
  expect_unbiased<TypeParam>([](auto const& a, auto const& b) { return a + b; }, 11);
  expect_unbiased<TypeParam>([](auto const& a, auto const& b) { return a * b; }, 12);
  expect_unbiased<TypeParam>([](auto const& a, auto const& b) { return a / b; }, 13);
  expect_unbiased<TypeParam>([](auto const& a, auto const&) { return sqrt(a); }, 14);
}

TEST(MemberRandom, IsAFunctionOfSeedAndMember) {
  MemberRandom one(5, 7), same(5, 7), other_member(5, 8), other_seed(6, 7);
  double const first = one.next();
  EXPECT_EQ(first, same.next());
  EXPECT_NE(first, other_member.next());
  EXPECT_NE(first, other_seed.next());
}

/// Mean 1/2 and, over 64 equal cells, χ² within its 10⁻⁶ quantiles.
TEST(MemberRandom, IsUniform) {
  constexpr int cells = 64, draws = 640'000;
  std::array<int, cells> counts{};
  MemberRandom random(2008, 3);
  for (int n = 0; n < draws; ++n) ++counts.at(static_cast<std::size_t>(random.next() * cells));
  double chi2 = 0;
  for (int count : counts) chi2 += std::pow(count - draws / cells, 2) / (draws / cells);
  EXPECT_GT(chi2, 22);
  EXPECT_LT(chi2, 130);
}

}  // namespace
}  // namespace brouwer
