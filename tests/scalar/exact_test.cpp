// Error-free transformations are free of error, in every scalar that has correctly rounded operations.
#include <brouwer/scalar/exact.hpp>
#include <brouwer/scalar/wider.hpp>

#include <gtest/gtest.h>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Uniform;

template <class T>
struct ErrorFree : testing::Test {
  /// Sums of two numbers 60 binary orders apart need p + 60 bits, products 2p.
  using Exactly = Mpfr<512>;
};
using Scalars = testing::Types<float, double, long double, Float128, Mpfr<128>>;
TYPED_TEST_SUITE(ErrorFree, Scalars);

template <class T>
T random_number(Uniform& uniform, int spread) {
  using std::ldexp;
  T const mantissa = T(uniform(-1, 1)) + T(uniform(-1, 1)) * epsilon<T>() * T(1 << 20);
  return ldexp(mantissa, static_cast<int>(uniform(-spread, spread)));
}

TYPED_TEST(ErrorFree, TwoSumLosesNothing) {
  using E = typename TestFixture::Exactly;
  Uniform uniform(1);
  int rounded_sums = 0;
  for (int i = 0; i < 2000; ++i) {
    auto const a = random_number<TypeParam>(uniform, 30), b = random_number<TypeParam>(uniform, 30);
    auto const [sum, error] = two_sum(a, b);
    ASSERT_EQ(sum, a + b);
    ASSERT_EQ(E(sum) + E(error), E(a) + E(b));
    rounded_sums += error != TypeParam(0);
  }
  EXPECT_GT(rounded_sums, 1000) << "the samples must round";
}

TYPED_TEST(ErrorFree, TwoDifferenceIsTheTwoSumOfTheNegative) {
  Uniform uniform(4);
  for (int i = 0; i < 2000; ++i) {
    auto const a = random_number<TypeParam>(uniform, 30), b = random_number<TypeParam>(uniform, 30);
    auto const difference = two_difference(a, b), sum = two_sum(a, TypeParam(-b));
    ASSERT_EQ(difference.value, sum.value);
    ASSERT_EQ(difference.error, sum.error);
  }
}

TYPED_TEST(ErrorFree, FastTwoSumLosesNothingWhenTheFirstIsLarger) {
  using E = typename TestFixture::Exactly;
  Uniform uniform(2);
  for (int i = 0; i < 2000; ++i) {
    auto a = random_number<TypeParam>(uniform, 30), b = random_number<TypeParam>(uniform, 30);
    using std::abs;
    if (abs(a) < abs(b)) std::swap(a, b);
    auto const [sum, error] = fast_two_sum(a, b);
    ASSERT_EQ(E(sum) + E(error), E(a) + E(b));
  }
}

TYPED_TEST(ErrorFree, TwoProdLosesNothing) {
  using E = typename TestFixture::Exactly;
  Uniform uniform(3);
  for (int i = 0; i < 2000; ++i) {
    auto const a = random_number<TypeParam>(uniform, 10), b = random_number<TypeParam>(uniform, 10);
    auto const [product, error] = two_prod(a, b);
    ASSERT_EQ(product, a * b);
    ASSERT_EQ(E(product) + E(error), E(a) * E(b));
  }
}

}  // namespace
}  // namespace brouwer
