#include <brouwer/scalar/modelled.hpp>

#include <gtest/gtest.h>

#include <brouwer/special/trigonometric.hpp>

#include "tests/scalar/chosen_rounding.hpp"

namespace brouwer {
namespace {

using testing::HardPairs;
using testing::Judge;
using testing::steps_with;

template <class T>
class ModelledNumber : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ModelledNumber, Scalars);

template <class T>
bool same_bits(T a, T b) {
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

TYPED_TEST(ModelledNumber, HasTheBitsOfItsTypeByTheStandardRule) {
  using T = TypeParam;
  using M = Modelled<T>;
  HardPairs<T> pairs(21);
  T const inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
  T const special[] = {
      T(0), -T(0), inf, -inf, nan, std::numeric_limits<T>::denorm_min(), std::numeric_limits<T>::max()};
  for (int i = 0; i < 100'000; ++i) {
    auto [a, b] = pairs.next();
    if (i % 10 == 0) b = special[static_cast<std::size_t>(i / 10) % 7];
    if (i % 70 == 0) a = special[static_cast<std::size_t>(i / 70) % 7];
    ASSERT_TRUE(same_bits((M(a) + M(b)).value(), T(a + b))) << a << " " << b;
    ASSERT_TRUE(same_bits((M(a) - M(b)).value(), T(a - b))) << a << " " << b;
    ASSERT_TRUE(same_bits((M(a) * M(b)).value(), T(a * b))) << a << " " << b;
    ASSERT_TRUE(same_bits((M(a) / M(b)).value(), T(a / b))) << a << " " << b;
    ASSERT_TRUE(same_bits(sqrt(M(a)).value(), std::sqrt(a))) << a;
    ASSERT_TRUE(same_bits(fused_add(M(a), M(b), M(a)).value(), std::fma(a, b, a))) << a << " " << b;
    ASSERT_TRUE(same_bits(nearest_integer(M(b)).value(), std::nearbyint(b))) << b;
  }
}

TYPED_TEST(ModelledNumber, HasTheSinesAndAnglesOfItsTypeByTheStandardRule) {
  using T = TypeParam;
  HardPairs<T> pairs(22);
  for (int i = 0; i < 20'000; ++i) {
    T const x = pairs.ordinary() * T(i % 100), y = pairs.ordinary();
    ASSERT_EQ(sine_cosine(Modelled<T>(x)).sin.value(), sine_cosine(x).sin) << x;
    ASSERT_EQ(sine_cosine(Modelled<T>(x)).cos.value(), sine_cosine(x).cos) << x;
    ASSERT_EQ(arctangent(Modelled<T>(y), Modelled<T>(x)).value(), arctangent(y, x)) << x << " " << y;
  }
}

TYPED_TEST(ModelledNumber, FusesAProductWithTheSumThatTakesIt) {
  using T = TypeParam;
  using M = Modelled<T>;
  ContextScope const scope(steps_with({.contraction = true}));
  HardPairs<T> pairs(23);
  for (int i = 0; i < 100'000; ++i) {
    T const a = pairs.ordinary(), b = pairs.ordinary(), c = i % 3 == 0 ? T(-a * b) : pairs.ordinary() * T(i % 50);
    T const d = pairs.ordinary();
    M const p = M(a) * M(b);
    ASSERT_EQ((p + M(c)).value(), std::fma(a, b, c));
    ASSERT_EQ((M(c) + p).value(), std::fma(a, b, c));
    ASSERT_EQ((p - M(c)).value(), std::fma(a, b, -c));
    ASSERT_EQ((M(c) - p).value(), std::fma(-a, b, c));
    ASSERT_EQ((-p + M(c)).value(), std::fma(-a, b, c));
    ASSERT_EQ((p + M(c) * M(d)).value(), std::fma(a, b, T(c * d)));  // of two products the left one
    ASSERT_EQ((p * M(d)).value(), T(T(a * b) * d));                  // other uses see the rounded product
    ASSERT_EQ(((p + M(c)) + M(d)).value(), T(std::fma(a, b, c) + d));
    M settled = p;
    settled.settle();
    ASSERT_EQ((settled + M(c)).value(), T(T(a * b) + c));
  }
}

TYPED_TEST(ModelledNumber, FusesNothingUnasked) {
  using M = Modelled<TypeParam>;
  TypeParam const third = TypeParam(1) / 3;
  EXPECT_EQ((M(third) * M(third) - M(TypeParam(third * third))).value(), 0);
}

/// Constants in about twice the bits of T: a quotient, whose products are often next to ties, or a root, whose are not.
template <class T>
Modelled<T> constant(HardPairs<T>& pairs, bool root) {
  auto const quotient = Float128(Float128(pairs.ordinary()) / Float128(pairs.ordinary()));
  return Modelled<T>(root ? Float128(quotient * sqrt(Float128(2))) : quotient);
}
template <class T>
Judge whole(Modelled<T> const& a) {
  return Judge(double(a.value())) + Judge(double(a.rest()));
}

TYPED_TEST(ModelledNumber, RoundsOperationsWithAnExactConstantOnce) {
  using T = TypeParam;
  HardPairs<T> pairs(24);
  for (int i = 0; i < 20'000; ++i) {
    auto const k = constant(pairs, i % 2 == 0);
    T const x = pairs.ordinary();
    Judge const exact[] = {whole(k) * Judge(double(x)), whole(k) + Judge(double(x)), whole(k) - Judge(double(x)),
                           Judge(double(x)) - whole(k), whole(k) / Judge(double(x)), Judge(double(x)) / whole(k)};
    for (auto const& [rounding, judged] : testing::directed_cases) {
      ContextScope const scope(steps_with({.rounding = rounding, .exact_constants = true}));
      Modelled<T> const y(x), found[] = {k * y, k + y, k - y, y - k, k / y, y / k};
      for (std::size_t n = 0; n < (i % 2 == 0 ? 6u : 4u); ++n)  // sums and products of any constant
        ASSERT_EQ(found[n].value(), exact[n].template as<T>(judged)) << "operation " << n << ", rounding " << judged;
    }
  }
}

TYPED_TEST(ModelledNumber, FormsConstantsInTwiceTheBitsOnlyWhereTheyAreToBeExact) {
  using T = TypeParam;
  using M = Modelled<T>;
  for (bool const exact : {false, true}) {
    ContextScope const scope(OperationContext{{.exact_constants = exact}, true, {}});
    M const c = sqrt(M(2) / M(3) + M(1) * M(5));
    EXPECT_EQ(c.value(), exact ? static_cast<T>(sqrt(Float128(Float128(17) / 3))) : std::sqrt(T(2) / T(3) + T(5)));
    double const rest = static_cast<double>(Float128(sqrt(Float128(Float128(17) / 3)) - Float128(c.value())));
    double const ulp = std::numeric_limits<T>::epsilon();
    EXPECT_NEAR(static_cast<double>(c.rest()), exact ? rest : 0.0, 8 * ulp * ulp);
  }
}

TYPED_TEST(ModelledNumber, SeesRestsOfConstantsOnlyWhereTheyAreToBeExact) {
  using T = TypeParam;
  Modelled<T> const third(Float128(Float128(1) / 3));
  ASSERT_NE(third.rest(), 0);
  EXPECT_EQ((third - Modelled<T>(third.value())).value(), 0);
  ContextScope const scope(steps_with({.exact_constants = true}));
  EXPECT_EQ((third - Modelled<T>(third.value())).value(), third.rest());
  EXPECT_EQ((third * Modelled<T>(3)).value(), 1);
}

TEST(ContextScope, GivesTheFormerContextBack) {
  {
    ContextScope const scope(steps_with({.rounding = Rounding::up}));
    EXPECT_GT((Modelled<double>(1) + Modelled<double>(0x1p-80)).value(), 1);
  }
  EXPECT_EQ((Modelled<double>(1) + Modelled<double>(0x1p-80)).value(), 1);
}

}  // namespace
}  // namespace brouwer
