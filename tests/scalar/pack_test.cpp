// A lane of a pack is bit for bit the scalar, in every operation and for every operand.
#include <brouwer/scalar/pack.hpp>

#include <gtest/gtest.h>

#include <vector>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Uniform;

/// Equal with the sign of zero; a NaN is a NaN. Boost's zeros have the sign that its operators for temporaries give them.
template <class T>
bool same(T const& a, T const& b) {
  if (a != a || b != b) return a != a && b != b;
  if constexpr (std::is_arithmetic_v<T>)
    return a == b && std::signbit(a) == std::signbit(b);
  else
    return a == b;
}

template <class P>
struct PackLanes : testing::Test {
  using T = Element<P>;
  static constexpr int N = lanes<P>;

  PackLanes() {
    using std::ldexp;
    using L = std::numeric_limits<T>;  // Boost 1.81's min() and max() of Float128 do not compile in strict C++
    T const one(1), smallest = ldexp(one, L::min_exponent - 1), denormal = smallest * epsilon<T>();
    T const largest = ldexp(T(2) - epsilon<T>(), L::max_exponent - 1);
    for (T const& a : {T(0), L::infinity(), denormal, smallest - denormal, smallest, largest, one, one + epsilon<T>(),
                       T(2), T(1) / T(3)}) {
      special_.push_back(a);
      special_.push_back(-a);
    }
    special_.push_back(L::quiet_NaN());
  }

  /// A special number in a third of the lanes.
  P operand() {
    return from_lanes<P>([&](int) {
      if (uniform_(0, 3) < 1) return special_[static_cast<std::size_t>(uniform_(0, double(special_.size())))];
      using std::ldexp;
      T const number = T(uniform_(-1, 1)) + T(uniform_(-1, 1)) * epsilon<T>() * T(1024);
      return T(ldexp(number, static_cast<int>(uniform_(-60, 60))));
    });
  }

  static constexpr int samples = std::is_arithmetic_v<T> ? 20'000 : 2'000;

  /// f of packs and f of numbers, whose results are numbers.
  template <class F>
  void expect_equal(char const* name, F f) {
    for (int n = 0; n < samples; ++n) {
      P const a = operand(), b = operand(), c = operand(), result = f(a, b, c);
      for (int i = 0; i < N; ++i)
        ASSERT_TRUE(same(result[i], T(f(a[i], b[i], c[i]))))
            << name << " of " << a[i] << ", " << b[i] << " and " << c[i] << " is " << result[i];
    }
  }
  /// … whose results are flags.
  template <class F>
  void expect_equal_flags(char const* name, F f) {
    for (int n = 0; n < samples; ++n) {
      P const a = operand(), b = n % 4 == 0 ? a : operand();
      auto const mask = f(a, b);
      bool any_lane = false, all_lanes = true;
      for (int i = 0; i < N; ++i) {
        ASSERT_EQ(mask[i], f(a[i], b[i])) << name << " of " << a[i] << " and " << b[i];
        any_lane = any_lane || mask[i];
        all_lanes = all_lanes && mask[i];
      }
      ASSERT_EQ(any(mask), any_lane);
      ASSERT_EQ(all(mask), all_lanes);
    }
  }

 private:
  std::vector<T> special_;
  Uniform uniform_{23};
};

using Packs = testing::Types<Pack<double, 2>, Pack<double, 4>, Pack<double, 8>, Pack<float, 4>, Pack<float, 8>,
                             Pack<float, 16>, Pack<double, 16>, Pack<float, 32>, Pack<Float128, 4>, Pack<double, 3>>;
TYPED_TEST_SUITE(PackLanes, Packs);

TYPED_TEST(PackLanes, Calculate) {
  this->expect_equal("+", [](auto a, auto b, auto) { return a + b; });
  this->expect_equal("-", [](auto a, auto b, auto) { return a - b; });
  this->expect_equal("*", [](auto a, auto b, auto) { return a * b; });
  this->expect_equal("/", [](auto a, auto b, auto) { return a / b; });
  this->expect_equal("negation", [](auto a, auto, auto) { return -a; });
  this->expect_equal("assignments", [](auto a, auto b, auto c) {
    a += b;
    a -= c;
    a *= b;
    a /= c;
    return a;
  });
}

TYPED_TEST(PackLanes, Compare) {
  this->expect_equal_flags("<", [](auto a, auto b) { return a < b; });
  this->expect_equal_flags("<=", [](auto a, auto b) { return a <= b; });
  this->expect_equal_flags(">", [](auto a, auto b) { return a > b; });
  this->expect_equal_flags(">=", [](auto a, auto b) { return a >= b; });
  this->expect_equal_flags("==", [](auto a, auto b) { return a == b; });
  this->expect_equal_flags("!=", [](auto a, auto b) { return a != b; });
}

TYPED_TEST(PackLanes, CombineFlagsAndSelect) {
  this->expect_equal_flags("both", [](auto a, auto b) { return both(a<b, a> - b); });
  this->expect_equal_flags("either", [](auto a, auto b) { return either(a<b, a> - b); });
  this->expect_equal_flags("negated", [](auto a, auto b) { return negated(a < b); });
  this->expect_equal("select", [](auto a, auto b, auto c) { return select(a < b, b, c); });
  this->expect_equal("larger", [](auto a, auto b, auto) { return larger(a, b); });
  this->expect_equal("sign_of", [](auto a, auto, auto) { return sign_of(a); });
}

TYPED_TEST(PackLanes, CallFunctions) {
  using math::abs;
  using math::sqrt;
  using std::floor;
  using std::ldexp;
  this->expect_equal("sqrt", [](auto a, auto, auto) { return sqrt(a); });
  this->expect_equal("abs", [](auto a, auto, auto) { return abs(a); });
  this->expect_equal("floor", [](auto a, auto, auto) { return floor(a); });
  this->expect_equal("ldexp", [](auto a, auto, auto) { return ldexp(a, -5); });
  if constexpr (std::is_arithmetic_v<typename TestFixture::T>) {  // libquadmath's have no NaN in some corners
    using math::atan2;
    using math::cos;
    using math::cosh;
    using math::sin;
    using math::tanh;
    using std::pow;
    this->expect_equal("sin", [](auto a, auto, auto) { return sin(a); });
    this->expect_equal("cos", [](auto a, auto, auto) { return cos(a); });
    this->expect_equal("cosh", [](auto a, auto, auto) { return cosh(a); });
    this->expect_equal("tanh", [](auto a, auto, auto) { return tanh(a); });
    this->expect_equal("atan2", [](auto a, auto b, auto) { return atan2(a, b); });
    this->expect_equal("pow", [](auto a, auto b, auto) { return pow(a, b); });
  }
}

TYPED_TEST(PackLanes, SplitSumsAndProducts) {
  this->expect_equal("fused_add", [](auto a, auto b, auto c) { return fused_add(a, b, c); });
  this->expect_equal("fused_subtract", [](auto a, auto b, auto c) { return fused_subtract(a, b, c); });
  this->expect_equal("two_sum's value", [](auto a, auto b, auto) { return two_sum(a, b).value; });
  this->expect_equal("two_sum's error", [](auto a, auto b, auto) { return two_sum(a, b).error; });
  this->expect_equal("two_difference's error", [](auto a, auto b, auto) { return two_difference(a, b).error; });
  this->expect_equal("fast_two_sum's error", [](auto a, auto b, auto) { return fast_two_sum(a, b).error; });
  this->expect_equal("two_prod's value", [](auto a, auto b, auto) { return two_prod(a, b).value; });
  this->expect_equal("two_prod's error", [](auto a, auto b, auto) { return two_prod(a, b).error; });
}

TYPED_TEST(PackLanes, HoldOneNumberIncludingMinusZeroAndNan) {
  using E = Element<TypeParam>;
  using L = std::numeric_limits<E>;
  for (E const& a : {E(0), -E(0), E(1) / E(3), L::infinity(), -L::infinity(), L::quiet_NaN()}) {
    TypeParam const pack(a);
    for (int i = 0; i < lanes<TypeParam>; ++i) EXPECT_TRUE(same(pack[i], a)) << a;
  }
  for (int i = 0; i < lanes<TypeParam>; ++i) EXPECT_EQ(TypeParam(-7)[i], E(-7));
}

TYPED_TEST(PackLanes, Convert) {
  using E = Element<TypeParam>;
  constexpr int count = lanes<TypeParam>;
  for (int n = 0; n < 1000; ++n) {
    TypeParam const a = this->operand();
    Wider<TypeParam> const wider(a);
    TypeParam const back = rounded<TypeParam>(wider);
    Pack<float, count> const single(a);
    for (int i = 0; i < count; ++i) {
      ASSERT_TRUE(same(back[i], a[i])) << a[i];
      ASSERT_TRUE(same(single[i], static_cast<float>(a[i]))) << a[i];
      ASSERT_TRUE(same(lane(a, i), a[i]));
    }
    ASSERT_TRUE(same(TypeParam(Wider<E>(a[0]))[count - 1], a[0])) << "a wider number in every lane";
  }
}

TYPED_TEST(PackLanes, HaveTheLimitsOfTheirElement) {
  using E = Element<TypeParam>;
  using L = std::numeric_limits<E>;
  using LP = std::numeric_limits<TypeParam>;
  EXPECT_EQ(LP::digits, L::digits);
  for (int i = 0; i < lanes<TypeParam>; ++i) {
    EXPECT_EQ(epsilon<TypeParam>()[i], epsilon<E>());
    EXPECT_EQ(LP::infinity()[i], L::infinity());
    EXPECT_NE(LP::quiet_NaN()[i], LP::quiet_NaN()[i]);
    if constexpr (std::is_arithmetic_v<E>) {
      EXPECT_EQ(LP::min()[i], L::min());
      EXPECT_EQ(LP::max()[i], L::max());
    }
  }
}

TYPED_TEST(PackLanes, AreSetOneByOne) {
  constexpr int count = lanes<TypeParam>;
  using E = Element<TypeParam>;
  TypeParam a(1);
  Mask<TypeParam> mask(false);
  for (int i = 0; i < count; ++i) {
    a.set(i, E(i + 2));
    mask.set(i, true);
    for (int j = 0; j < count; ++j) {
      EXPECT_EQ(a[j], j <= i ? E(j + 2) : E(1));
      EXPECT_EQ(mask[j], j <= i);
    }
    EXPECT_EQ(all(mask), i == count - 1);
  }
  mask.set(0, false);
  EXPECT_FALSE(mask[0]);
  EXPECT_EQ(any(mask), count > 1);
}

}  // namespace
}  // namespace brouwer
