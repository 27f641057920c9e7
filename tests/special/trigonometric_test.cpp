// The library's own sine, cosine, arc tangent, sech and tanh against 77 digits, at their special values, and in lanes.
#include <brouwer/special/hyperbolic.hpp>
#include <brouwer/special/trigonometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/lanes.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Judge;
using testing_support::packed;
using testing_support::same_bits;
using testing_support::Uniform;

/// |computed − exact| in units of the last place of the exact value.
template <class T>
double ulps(T computed, Judge const& exact) {
  int exponent = 0;
  std::frexp(static_cast<T>(exact), &exponent);
  T const last = std::max(std::ldexp(epsilon<T>(), exponent - 1), std::numeric_limits<T>::denorm_min());
  return std::abs(static_cast<double>(Judge(Judge(Judge(computed) - exact) / last)));
}

/// Uniform near 0 and over the whole range of the reduction, logarithmic down to denormal numbers, and within two
/// ulp of multiples of π/2.
template <class E>
std::vector<E> arguments(int count) {
  Uniform uniform(11);
  double const range = ElementaryConstants<E>::largest_reduced, decades = std::numeric_limits<E>::max_exponent10 + 12;
  Judge const half_pi = acos(Judge(0));
  std::vector<E> xs;
  for (int i = 0; i < count; i += 5) {
    xs.push_back(static_cast<E>(uniform(-2, 2)));
    xs.push_back(static_cast<E>(uniform(-50, 50)));
    xs.push_back(static_cast<E>(uniform(-range, range)));
    xs.push_back(static_cast<E>((i % 2 == 0 ? 1 : -1) * std::pow(10.0, uniform(-decades, 0))));
    E near = static_cast<E>(Judge(half_pi * std::floor(uniform(-0.6, 0.6) * range)));
    for (int step = i / 5 % 5 - 2; step != 0; step += step > 0 ? -1 : 1)
      near = std::nextafter(near, static_cast<E>(step) * std::numeric_limits<E>::max());
    xs.push_back(near);
  }
  return xs;
}

/// Zeros, infinities, NaN, the ends of the number range, and arguments that no reduction in T reaches.
template <class E>
std::vector<E> special_arguments() {
  using Limits = std::numeric_limits<E>;
  std::vector<E> xs;
  for (E x : {E(0), Limits::denorm_min(), Limits::min(), E(1), E(3), ElementaryConstants<E>::largest_reduced,
              std::nextafter(ElementaryConstants<E>::largest_reduced, Limits::max()), E(1e9F), E(1e22F), E(1e37F),
              Limits::max() / 4, Limits::max(), Limits::infinity(), Limits::quiet_NaN()}) {
    xs.push_back(x);
    xs.push_back(-x);
  }
  return xs;
}

template <class T>
struct BuiltIn : testing::Test {};
using BuiltIns = testing::Types<float, double>;
TYPED_TEST_SUITE(BuiltIn, BuiltIns);

TYPED_TEST(BuiltIn, SineAndCosineErrByLessThanAnUlp) {
  double worst = 0;
  for (TypeParam x : arguments<TypeParam>(40000)) {
    auto const ours = sine_cosine(x);
    worst = std::max({worst, ulps(ours.sin, sin(Judge(x))), ulps(ours.cos, cos(Judge(x)))});
  }
  EXPECT_LT(worst, 0.87);
}

TYPED_TEST(BuiltIn, SineAndCosineOfHugeArgumentsAreRoundedCorrectly) {
  for (double power : {3.3, 6.5, 9.0, 22.0, 37.0}) {
    auto const x = static_cast<TypeParam>(std::pow(10.0, power));
    EXPECT_LE(ulps(sine_cosine(x).sin, sin(Judge(x))), 0.86) << x;
    EXPECT_LE(ulps(sine_cosine(x).cos, cos(Judge(x))), 0.86) << x;
  }
}

TYPED_TEST(BuiltIn, ArcTangentErrsByLessThanEpsilon) {
  Uniform uniform(12);
  double worst = 0;
  for (int i = 0; i < 40000; ++i) {
    auto const y = static_cast<TypeParam>(uniform(-1, 1) * std::pow(10.0, i % 3 == 0 ? uniform(-15, 15) : 0));
    auto const x = static_cast<TypeParam>(uniform(-1, 1));
    worst = std::max(worst, testing_support::relative_ulps(arctangent(y, x), atan2(Judge(y), Judge(x))));
  }
  EXPECT_LT(worst, 1);
}

TYPED_TEST(BuiltIn, ArcTangentHasTheZerosAndSignsOfTheStandards) {
  auto const numbers = special_arguments<TypeParam>();
  for (TypeParam y : numbers)
    for (TypeParam x : numbers) {
      if (std::isinf(x) && std::isinf(y)) continue;
      TypeParam const ours = arctangent(y, x), theirs = std::atan2(y, x);
      // what is 0, π/2 or π has the same bits
      if (y == 0 || x == 0 || std::isnan(x) || std::isnan(y) || std::isinf(x) || std::isinf(y))
        EXPECT_TRUE(same_bits(ours, theirs)) << y << ", " << x << ": " << ours << " for " << theirs;
      else
        EXPECT_NEAR(ours, theirs, epsilon<TypeParam>() * std::abs(theirs)) << y << ", " << x;
    }
}

TYPED_TEST(BuiltIn, SechAndTanhErrByLittle) {
  double worst_sech = 0, worst_tanh = 0;
  for (TypeParam u : arguments<TypeParam>(40000)) {
    if (std::abs(u) > ElementaryConstants<TypeParam>::largest_exponent) continue;
    auto const ours = sech_tanh(u);
    worst_sech = std::max(worst_sech, testing_support::relative_ulps(ours.sech, Judge(1 / cosh(Judge(u)))));
    worst_tanh = std::max(worst_tanh, ulps(ours.tanh, tanh(Judge(u))));
  }
  EXPECT_LT(worst_sech, 1.5);
  EXPECT_LT(worst_tanh, 3.3);
  TypeParam const infinite = std::numeric_limits<TypeParam>::infinity();
  EXPECT_EQ(sech_tanh(infinite).sech, 0);
  EXPECT_EQ(sech_tanh(-infinite).tanh, -1);
}

TYPED_TEST(BuiltIn, KeepsZerosSignAndNotANumber) {
  TypeParam const zero = 0, nan = std::numeric_limits<TypeParam>::quiet_NaN();
  TypeParam const infinite = std::numeric_limits<TypeParam>::infinity();
  EXPECT_TRUE(same_bits(sine_cosine(zero).sin, zero));
  EXPECT_TRUE(same_bits(sine_cosine(-zero).sin, -zero));
  EXPECT_TRUE(same_bits(sech_tanh(-zero).tanh, -zero));
  EXPECT_EQ(sine_cosine(-zero).cos, 1);
  for (TypeParam x : {nan, infinite, -infinite}) {
    EXPECT_TRUE(std::isnan(sine_cosine(x).sin));
    EXPECT_TRUE(std::isnan(sine_cosine(x).cos));
  }
  EXPECT_TRUE(std::isnan(sech_tanh(nan).sech) && std::isnan(sech_tanh(nan).tanh));
}

TEST(OtherScalars, CallTheirOwnLibrary) {
  EXPECT_EQ(sine_cosine(Judge(3)).sin, sin(Judge(3)));
  EXPECT_EQ(arctangent(Float128(-1), Float128(2)), atan2(Float128(-1), Float128(2)));
  EXPECT_EQ(arctangent(1.5L, -2.0L), std::atan2(1.5L, -2.0L));
  using Wide = Pack<Float128, 2>;
  EXPECT_EQ(sine_cosine(Wide(3)).cos[1], cos(Float128(3)));
}

template <class T>
struct ElementaryLanes : testing::Test {};
using Packs = testing::Types<Pack<double, 2>, Pack<double, 4>, Pack<double, 8>, Pack<double, 3>, Pack<float, 4>,
                             Pack<float, 8>, Pack<float, 16>>;
TYPED_TEST_SUITE(ElementaryLanes, Packs);

TYPED_TEST(ElementaryLanes, EqualTheScalarBitForBit) {
  using T = TypeParam;
  using E = Element<T>;
  auto numbers = special_arguments<E>();
  for (E x : arguments<E>(100'000)) numbers.push_back(x);
  auto const xs = packed<T>(numbers);
  int differing = 0;
  for (std::size_t n = 0; n < xs.size(); ++n) {
    T const x = xs[n], y = xs[(n * n) % xs.size()];
    auto const angle = sine_cosine(x);
    auto const hyperbolic = sech_tanh(x);
    T const arc = arctangent(y, x), large = larger(y, x), small = smaller(y, x);
    for (int i = 0; i < lanes<T>; ++i) {
      E const xi = x[i], yi = y[i];
      bool const same = same_bits(angle.sin[i], sine_cosine(xi).sin) && same_bits(angle.cos[i], sine_cosine(xi).cos) &&
                        same_bits(hyperbolic.sech[i], sech_tanh(xi).sech) &&
                        same_bits(hyperbolic.tanh[i], sech_tanh(xi).tanh) && same_bits(arc[i], arctangent(yi, xi)) &&
                        same_bits(large[i], larger(yi, xi)) && same_bits(small[i], smaller(yi, xi));
      if (!same) ++differing;
    }
  }
  EXPECT_EQ(differing, 0);
}

}  // namespace
}  // namespace brouwer
