// Double-double keeps the error bounds that it cites, nearly attains them, and is in every lane of a pack the scalar's.
#include <brouwer/scalar/double_double.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include <brouwer/integrators/dmv.hpp>
#include <brouwer/integrators/elliptic_branch_free.hpp>

#include "tests/bodies.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Uniform;
using Exactly = Mpfr<512>;

/// Bit for bit; a NaN is a NaN.
template <class T>
bool same(T const& a, T const& b) {
  using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b) || (std::isnan(a) && std::isnan(b));
}
template <class T>
bool same(DoubleDouble<T> const& a, DoubleDouble<T> const& b) {
  return same(a.high(), b.high()) && (same(a.low(), b.low()) || std::isnan(a.high()));
}

template <class T>
bool normalised(DoubleDouble<T> const& a) {
  return a.high() == a.high() + a.low();
}

/// Operands that double-double arithmetic has trouble with: high parts beside powers of two and halves of them, low parts
/// of either sign, close to half an ulp, a power of two, small or zero; sums that cancel.
template <class T>
class Hostile {
 public:
  explicit Hostile(std::uint64_t seed) : uniform_(seed) {}

  DoubleDouble<T> number(int spread = 20) { return with_low(std::ldexp(high_part(), integer(-spread, spread))); }

  /// A partner of a: one of another size, or one that leaves only low parts of a + b, or little more.
  DoubleDouble<T> partner(DoubleDouble<T> const& a) {
    switch (integer(0, 3)) {
      case 0:
        return number(20);
      case 1:
        return with_low(sign() * a.high() * std::ldexp(T(1) + T(integer(-4, 4)) * epsilon<T>(), integer(-2, 2)));
      case 2:
        return with_low(-a.high() * (T(1) + T(integer(-4, 4)) * epsilon<T>()));
      default:
        return with_low(-a.high() * (T(1) + std::ldexp(T(uniform_(-1, 1)), -integer(1, digits))));
    }
  }

  T plain() { return std::ldexp(high_part(), integer(-20, 20)); }

 private:
  static constexpr int digits = std::numeric_limits<T>::digits;

  int integer(int low, int high) { return static_cast<int>(std::floor(uniform_(low, high + 1))); }
  T sign() { return uniform_(0, 1) < 0.5 ? T(-1) : T(1); }

  T high_part() {
    switch (integer(0, 2)) {
      case 0:
        return sign() * (T(1) + T(uniform_(0, 1)));
      case 1:
        return sign() * (T(1) + T(integer(-8, 8)) * epsilon<T>());
      default:
        return sign() * (T(1) + std::ldexp(T(1), -integer(1, digits - 1)) + T(integer(-4, 4)) * epsilon<T>());
    }
  }

  DoubleDouble<T> with_low(T const& high) {
    int exponent = 0;
    std::frexp(high, &exponent);
    T const half_ulp = std::ldexp(T(1), exponent - 1 - digits);
    return DoubleDouble<T>(fast_two_sum(high, sign() * half_ulp * low_share() + T(0)));
  }
  T low_share() {
    switch (integer(0, 4)) {
      case 0:
        return T(0);
      case 1:
        return std::ldexp(T(1), -integer(0, digits));
      case 2:
        return T(1) - T(integer(0, 8)) * epsilon<T>();
      case 3:
        return T(1) - T(uniform_(0, 0.1));
      default:
        return T(uniform_(0, 1));
    }
  }

  Uniform uniform_;
};

// --- accuracy ---------------------------------------------------------------------------------------------------------

template <class T>
struct DoubleDoubleErrors : testing::Test {
  using Number = DoubleDouble<T>;
  static constexpr int samples = 100'000;

  /// Over operands from `draw`, the largest |f − exact|/|exact| in units of u²; results are normalised.
  template <class Draw, class F, class E>
  static double worst(Draw draw, F f, E exact) {
    double worst = 0;
    for (int i = 0; i < samples; ++i) {
      auto const [a, b] = draw();
      Number const computed = f(a, b);
      EXPECT_TRUE(normalised(computed)) << computed << " of " << a << " and " << b;
      Exactly const right = exact(Exactly(a), Exactly(b)), wrong = Exactly(computed) - right;
      if (right == 0)
        EXPECT_EQ(computed, Number(0));
      else
        worst = std::max(worst, static_cast<double>(Exactly(ldexp(abs(Exactly(wrong / right)), 2 * digits))));
    }
    return worst;
  }

  static constexpr int digits = std::numeric_limits<T>::digits;
  static double u() { return std::ldexp(1.0, -digits); }

  Hostile<T> hostile{42};
  auto pairs() {
    return [this] {
      Number const a = hostile.number();
      return std::pair(a, hostile.partner(a));
    };
  }
  auto with_plain() {
    return [this] { return std::pair(hostile.number(), hostile.plain()); };
  }
};
using Parts = testing::Types<double, float>;
TYPED_TEST_SUITE(DoubleDoubleErrors, Parts);

// Lower bounds of the worst error: a test that samples too kindly, or a bound that is too generous, fails too.
TYPED_TEST(DoubleDoubleErrors, OfASumAndADifference) {
  double const sum = this->worst(
      this->pairs(), [](auto a, auto b) { return a + b; }, [](auto a, auto b) { return Exactly(a + b); });
  double const difference = this->worst(
      this->pairs(), [](auto a, auto b) { return a - b; }, [](auto a, auto b) { return Exactly(a - b); });
  for (double const worst : {sum, difference}) {
    EXPECT_LT(worst, 3 + 13 * this->u());
    EXPECT_GT(worst, 1.9);
  }
}

TYPED_TEST(DoubleDoubleErrors, OfAProduct) {
  double const worst = this->worst(
      this->pairs(), [](auto a, auto b) { return a * b; }, [](auto a, auto b) { return Exactly(a * b); });
  EXPECT_LT(worst, 5);
  EXPECT_GT(worst, 2.8);
}

TYPED_TEST(DoubleDoubleErrors, OfAQuotient) {
  double const worst = this->worst(
      this->pairs(), [](auto a, auto b) { return a / b; }, [](auto a, auto b) { return Exactly(a / b); });
  EXPECT_LT(worst, 11 + 60 * this->u());
  EXPECT_GT(worst, 4.4);
}

TYPED_TEST(DoubleDoubleErrors, OfASquareAndASquareRoot) {
  double const square = this->worst(
      this->pairs(), [](auto a, auto) { return squared(a); }, [](auto a, auto) { return Exactly(a * a); });
  EXPECT_LT(square, 3 + 20 * this->u());
  EXPECT_GT(square, 2);
  double const root = this->worst(
      this->pairs(), [](auto a, auto) { return sqrt(abs(a)); }, [](auto a, auto) { return Exactly(sqrt(abs(a))); });
  EXPECT_LT(root, 25 / 8.);
  EXPECT_GT(root, 1.6);
}

TYPED_TEST(DoubleDoubleErrors, OfOperationsWithAPlainNumber) {
  double const sum = this->worst(
      this->with_plain(), [](auto a, auto b) { return a + b; }, [](auto a, auto b) { return Exactly(a + b); });
  double const product = this->worst(
      this->with_plain(), [](auto a, auto b) { return a * b; }, [](auto a, auto b) { return Exactly(a * b); });
  double const quotient = this->worst(
      this->with_plain(), [](auto a, auto b) { return a / b; }, [](auto a, auto b) { return Exactly(a / b); });
  EXPECT_LT(sum, 2);
  EXPECT_LT(product, 2);
  EXPECT_LT(quotient, 3);
  EXPECT_GT(sum, 0.8);
  EXPECT_GT(product, 1.4);
  EXPECT_GT(quotient, 1.8);
}

TYPED_TEST(DoubleDoubleErrors, AreNoneWhereTheResultFits) {
  using D = DoubleDouble<TypeParam>;
  D const third = D(1) / D(3);
  EXPECT_EQ(D(6) / D(3), D(2));
  EXPECT_EQ(third * D(8), ldexp(third, 3));
  EXPECT_EQ((D(1) + ldexp(D(1), -100)) - D(1), ldexp(D(1), -100));
  EXPECT_EQ(squared(D(1) + epsilon<TypeParam>()), D(1) + 2 * epsilon<TypeParam>() + D(squared(epsilon<TypeParam>())));
  EXPECT_EQ(sqrt(D(49)), D(7));
  EXPECT_EQ(sqrt(D(0)), D(0));
  EXPECT_EQ(third - third, D(0));
  EXPECT_EQ(D(0) / D(3), D(0));
}

TYPED_TEST(DoubleDoubleErrors, OfPlainOperandsAreThoseOfDoubleDoubles) {
  using D = DoubleDouble<TypeParam>;
  for (int i = 0; i < 10'000; ++i) {
    D const a = this->hostile.number();
    TypeParam const b = this->hostile.plain();
    ASSERT_TRUE(same(D(a + b), D(a + D(b))) && same(D(b + a), D(D(b) + a)));
    ASSERT_TRUE(same(D(a - b), D(a - D(b))) && same(D(b - a), D(D(b) - a)));
    ASSERT_TRUE(same(D(a / b), D(a / D(b))));
    ASSERT_TRUE(same(D(1 + a), D(D(1) + a)) && same(D(2 * a), D(D(2) * a)) && same(D(a / 7), D(a / D(7))));
    ASSERT_TRUE(same(D(a - a * b), D(a + -(a * b))));
  }
}

// --- functions --------------------------------------------------------------------------------------------------------

using D = DoubleDouble<double>;

TEST(DoubleDoubleFunctions, AreAccurateToTheLastBits) {
  using J = Mpfr<256>;
  Hostile<double> hostile(7);
  for (int i = 0; i < 1000; ++i) {
    D const a = hostile.number(4), b = hostile.number(4);
    J const x(a), y(b);
    auto const expect_close = [](D const& computed, J const& right) {
      EXPECT_TRUE(normalised(computed));
      EXPECT_LT(static_cast<double>(J(abs(J(J(computed) / right - 1)))), 0x1p-105);
    };
    expect_close(sin(a), J(sin(x)));
    expect_close(cos(a), J(cos(x)));
    expect_close(cosh(a), J(cosh(x)));
    expect_close(tanh(a), J(tanh(x)));
    expect_close(atan2(a, b), J(atan2(x, y)));
    expect_close(pow(abs(a), b), J(pow(J(abs(x)), y)));
    EXPECT_EQ(J(abs(a)), J(abs(x)));
    EXPECT_EQ(J(floor(a)), J(floor(x)));
    EXPECT_EQ(J(ldexp(a, -37)), J(ldexp(x, -37)));
    EXPECT_EQ(J(copysign(a, b)), J(copysign(x, y)));
  }
}

TEST(DoubleDoubleFunctions, FloorLooksAtTheLowPartOfAWholeHighPart) {
  EXPECT_EQ(floor(D(5) - epsilon<D>()), D(4));
  EXPECT_EQ(floor(D(5) + epsilon<D>()), D(5));
  EXPECT_EQ(floor(D(0x1p80) + 2.5), D(0x1p80) + 2);
}

// --- comparisons, conversions, limits ---------------------------------------------------------------------------------

TEST(DoubleDoubleComparisons, LookAtBothParts) {
  D const one(1), above = one + epsilon<D>(), below = one - epsilon<D>();
  EXPECT_TRUE(below < one && one < above && below < above);
  EXPECT_TRUE(below <= one && one <= one && above >= one && above > below);
  EXPECT_FALSE(above < one || above <= one || below >= one || one < one || one > one);
  EXPECT_TRUE(one == one && one != above && !(one == below) && !(one != one));
  EXPECT_EQ(larger(one, above), above);
  EXPECT_EQ(larger(above, below), above);
  EXPECT_EQ(abs(-above), above);
  EXPECT_EQ(abs(below), below);
}

TEST(DoubleDoubleComparisons, WithNanAreFalse) {
  D const nan = std::numeric_limits<D>::quiet_NaN();
  for (D const& a : {nan, D(1), D(std::numeric_limits<double>::infinity())}) {
    EXPECT_FALSE(a < nan || a > nan || a <= nan || a >= nan || a == nan);
    EXPECT_TRUE(a != nan);
  }
}

TEST(DoubleDoubleNumbers, ThatOverflowOrAreNoNumbersEndAsNan) {
  double const inf = std::numeric_limits<double>::infinity();
  auto const no_number = [](D const& a) { return std::isnan(a.high()); };
  D const large = std::numeric_limits<D>::max();
  EXPECT_TRUE(no_number(large * large) && no_number(large + large) && no_number(squared(large)));
  EXPECT_TRUE(no_number(D(1) / D(0)) && no_number(D(0) / D(0)) && no_number(sqrt(D(-1))));
  EXPECT_TRUE(no_number(D(inf) + D(1)) && no_number(D(inf) * D(2)) && no_number(D(inf) - D(inf)));
  EXPECT_TRUE(D(inf) > large && -D(inf) < large);
  EXPECT_EQ(D(Float128(inf)), D(inf));
  EXPECT_TRUE(no_number(D(std::numeric_limits<Float128>::quiet_NaN())));
}

TEST(DoubleDoubleConversions, ReturnUnchanged) {
  Hostile<double> hostile(3);
  for (int i = 0; i < 10'000; ++i) {
    D const a = hostile.number(200);
    ASSERT_TRUE(same(D(Mpfr<256>(a)), a)) << a;
    ASSERT_TRUE(same(rounded<D>(Wider<D>(a)), a)) << a;
    ASSERT_EQ(static_cast<double>(a), static_cast<double>(Mpfr<256>(a)));
    ASSERT_EQ(static_cast<long double>(a), static_cast<long double>(Mpfr<256>(a)));
    ASSERT_EQ(static_cast<Float128>(a), Float128(a.high()) + Float128(a.low()));
    DoubleDouble<float> const narrow(static_cast<double>(a) * 0x1p-200);
    ASSERT_LE(std::abs(static_cast<double>(narrow) - static_cast<double>(a) * 0x1p-200),
              std::abs(static_cast<double>(a) * 0x1p-200) * 0x1p-49 + 0x1p-149);
  }
}

TEST(DoubleDoubleConversions, AreNormalisedWhereTheRestRoundsUpToHalfAnUlp) {
  // 1 + ε is odd; what lies just below half an ulp above it rounds to half an ulp, which belongs to 1 + 2ε
  Mpfr<256> const x = Mpfr<256>(1) + ldexp(Mpfr<256>(1), -52) + ldexp(Mpfr<256>(1), -53) - ldexp(Mpfr<256>(1), -200);
  D const a(x);
  EXPECT_TRUE(normalised(a));
  EXPECT_EQ(a.high(), 1 + 0x1p-51);
  EXPECT_EQ(a.low(), -0x1p-53);
}

TEST(DoubleDoubleConversions, OfIntegersAreExact) {
  for (std::int64_t const i : {std::int64_t{1'234'567'890'123'456'789}, std::numeric_limits<std::int64_t>::max(),
                               std::numeric_limits<std::int64_t>::min(), std::int64_t{-1}, std::int64_t{0}})
    EXPECT_EQ(Mpfr<256>(D(i)), Mpfr<256>(i));
  EXPECT_EQ(Mpfr<256>(D(std::numeric_limits<std::uint64_t>::max())), ldexp(Mpfr<256>(1), 64) - 1);
  EXPECT_EQ(Mpfr<256>(DoubleDouble<float>(123'456'789)), Mpfr<256>(123'456'789));
}

TEST(DoubleDoubleConversions, ToIntegersTruncate) {
  EXPECT_EQ(static_cast<int>(D(3)), 3);
  EXPECT_EQ(static_cast<int>(D(3) - epsilon<D>()), 2);
  EXPECT_EQ(static_cast<int>(-D(3) + epsilon<D>()), -2);
  EXPECT_EQ(static_cast<std::int64_t>(D(std::int64_t{1'234'567'890'123'456'789})), 1'234'567'890'123'456'789);
}

TEST(DoubleDoubleLimits, AreThoseOfTwiceTheBits) {
  using Limits = std::numeric_limits<D>;
  EXPECT_EQ(Limits::digits, 106);
  EXPECT_EQ(Limits::digits10, 31);
  EXPECT_EQ(Limits::epsilon(), ldexp(D(1), 1 - 106));
  EXPECT_TRUE(normalised(Limits::max()) && normalised(Limits::min()));
  EXPECT_TRUE(std::isnan((Limits::max() + Limits::max() * Limits::epsilon()).high()));
  // the smallest number whose last of 106 bits is a normal double's
  EXPECT_EQ(Limits::min().high() * 0x1p-53, std::numeric_limits<double>::min());
  EXPECT_EQ(DoubleDouble<float>(1) + std::numeric_limits<DoubleDouble<float>>::epsilon(),
            DoubleDouble<float>(Float128(1) + ldexp(Float128(1), -47)));
}

// --- lanes ------------------------------------------------------------------------------------------------------------

template <class P>
struct DoubleDoubleLanes : testing::Test {};
using Packs = testing::Types<Pack<double, 2>, Pack<double, 4>, Pack<double, 8>, Pack<double, 16>, Pack<double, 3>,
                             Pack<float, 8>>;
TYPED_TEST_SUITE(DoubleDoubleLanes, Packs);

TYPED_TEST(DoubleDoubleLanes, AreBitForBitTheScalars) {
  using Wide = DoubleDouble<TypeParam>;
  using T = Element<TypeParam>;
  using Number = DoubleDouble<T>;
  static_assert(std::same_as<Element<Wide>, Number> && lanes<Wide> == lanes<TypeParam> && Real<Wide>);
  using L = std::numeric_limits<T>;
  std::vector<Number> operands{Number(0),
                               -Number(0),
                               Number(1),
                               L::infinity(),
                               -L::infinity(),
                               L::quiet_NaN(),
                               L::denorm_min(),
                               -L::min(),
                               std::numeric_limits<Number>::max(),
                               std::numeric_limits<Number>::min()};
  Hostile<T> hostile(11);
  while (operands.size() < 2000) {
    operands.push_back(hostile.number());
    operands.push_back(hostile.partner(operands.back()));
  }
  Uniform uniform(12);
  auto const pick = [&](int) { return operands[static_cast<std::size_t>(uniform(0, 1) * double(operands.size()))]; };

  Wide a, b;
  auto const expect_equal = [&](char const* name, auto f) {
    Wide const c = f(a, b);
    for (int i = 0; i < lanes<Wide>; ++i)
      ASSERT_TRUE(same(lane(c, i), Number(f(lane(a, i), lane(b, i)))))
          << name << " of " << lane(a, i) << " and " << lane(b, i);
  };
  auto const expect_equal_mask = [&](char const* name, auto f) {
    auto const mask = f(a, b);
    for (int i = 0; i < lanes<Wide>; ++i)
      ASSERT_EQ(mask[i], f(lane(a, i), lane(b, i))) << name << " of " << lane(a, i) << " and " << lane(b, i);
  };
  for (int n = 0; n < 20'000; ++n) {
    a = from_lanes<Wide>(pick);
    b = from_lanes<Wide>(pick);
    expect_equal("+", [](auto x, auto y) { return x + y; });
    expect_equal("-", [](auto x, auto y) { return x - y; });
    expect_equal("*", [](auto x, auto y) { return x * y; });
    expect_equal("/", [](auto x, auto y) { return x / y; });
    expect_equal("negation", [](auto x, auto) { return -x; });
    expect_equal("+ high", [](auto x, auto y) { return x + y.high(); });
    expect_equal("high -", [](auto x, auto y) { return y.high() - x; });
    expect_equal("* high", [](auto x, auto y) { return x * y.high(); });
    expect_equal("/ high", [](auto x, auto y) { return x / y.high(); });
    expect_equal("2 *", [](auto x, auto) { return 2 * x; });
    expect_equal("1 +", [](auto x, auto) { return 1 + x; });
    expect_equal("squared", [](auto x, auto) { return squared(x); });
    expect_equal("sqrt", [](auto x, auto) { return sqrt(x); });
    expect_equal("abs", [](auto x, auto) { return abs(x); });
    expect_equal("floor", [](auto x, auto) { return floor(x); });
    expect_equal("ldexp", [](auto x, auto) { return ldexp(x, -3); });
    expect_equal("select", [](auto x, auto y) { return select(x < y, x, -y); });
    expect_equal("larger", [](auto x, auto y) { return larger(x, y); });
    expect_equal_mask("<", [](auto x, auto y) { return x < y; });
    expect_equal_mask("<=", [](auto x, auto y) { return x <= y; });
    expect_equal_mask(">", [](auto x, auto y) { return x > y; });
    expect_equal_mask(">=", [](auto x, auto y) { return x >= y; });
    expect_equal_mask("==", [](auto x, auto y) { return x == y; });
    expect_equal_mask("!=", [](auto x, auto y) { return x != y; });
    if (n % 50 != 0) continue;  // slow
    expect_equal("sin", [](auto x, auto) { return sin(x); });
    expect_equal("cos", [](auto x, auto) { return cos(x); });
    expect_equal("cosh", [](auto x, auto) { return cosh(x); });
    expect_equal("tanh", [](auto x, auto) { return tanh(x); });
    expect_equal("atan2", [](auto x, auto y) { return atan2(x, y); });
    expect_equal("pow", [](auto x, auto y) { return pow(x, y); });
  }
}

TYPED_TEST(DoubleDoubleLanes, ConvertLaneByLane) {
  using Wide = DoubleDouble<TypeParam>;
  using Number = Element<Wide>;
  constexpr int N = lanes<Wide>;
  Hostile<Element<TypeParam>> hostile(5);
  Wide const a = from_lanes<Wide>([&](int) { return hostile.number(); });
  Wider<Wide> const wider(a);
  Pack<Float128, N> const quad(a);
  TypeParam const high(a);
  Wide const back = rounded<Wide>(wider), from_quad(quad), from_high(high), broadcast(lane(a, 0));
  for (int i = 0; i < N; ++i) {
    EXPECT_EQ(wider[i], Wider<Number>(lane(a, i)));
    EXPECT_EQ(quad[i], static_cast<Float128>(lane(a, i)));
    EXPECT_EQ(high[i], lane(a, i).high());
    EXPECT_TRUE(same(lane(back, i), lane(a, i)));
    EXPECT_TRUE(same(lane(from_quad, i), Number(quad[i])));
    EXPECT_TRUE(same(lane(from_high, i), Number(high[i])));
    EXPECT_TRUE(same(lane(broadcast, i), lane(a, 0)));
    EXPECT_TRUE(same(lane(Wide(3), i), Number(3)));
    EXPECT_TRUE(same(lane(Wide(Mpfr<256>(1) / 3), i), Number(Mpfr<256>(1) / 3)));
    EXPECT_TRUE(same(lane(epsilon<Wide>(), i), epsilon<Number>()));
  }
}

// --- integration ------------------------------------------------------------------------------------------------------

using Body = testing_support::BodyCase;

template <class T>
Setup<RigidBody<T>> setup_of(Body const& body) {
  return {body.body<T>(), T(1) / T(100), body.start<T>()};
}

/// Largest difference of a component from the judge's run over 1000 steps from the same decimals.
template <template <class> class S>
double error_after_1000_steps(Body const& body) {
  using J = Mpfr<256>;
  brouwer::Setup<RigidBody<D>> const ours = setup_of<D>(body);
  auto const wide = [](auto const& state) {
    auto const in = [](D const& a) { return J(a); };
    auto const& y = state.momentum;
    auto const& q = state.attitude;
    return RigidBodyState<J>{{in(y[0]), in(y[1]), in(y[2])}, {in(q.w()), in(q.x()), in(q.y()), in(q.z())}};
  };
  brouwer::Setup<RigidBody<J>> const judge{ours.system.in<J>(), J(ours.step), wide(ours.start)};
  auto state = ours.start;
  auto right = judge.start;
  advance(S<D>(ours), state, 1000);
  advance(S<J>(judge), right, 1000);
  double worst = 0;
  auto computed = wide(state);
  for_components([&](J const& a, J const& b) { worst = std::max(worst, static_cast<double>(J(abs(J(a - b))))); },
                 computed, right);
  return worst;
}

TEST(DoubleDoubleIntegration, FollowsTheJudgeToThirtyDigits) {
  for (auto const& body : testing_support::generic_bodies()) {
    EXPECT_LT(error_after_1000_steps<Dmv2>(body), 1e-29) << body.name;
    EXPECT_LT(error_after_1000_steps<EllipticIncrement>(body), 1e-29) << body.name;
  }
}

TEST(DoubleDoubleIntegration, LanesAreTheScalarRuns) {
  using Wide = DoubleDouble<Pack<double, 8>>;
  auto const bodies = testing_support::generic_bodies();
  auto const body_of = [&](int i) {
    Body body = bodies[static_cast<std::size_t>(i) % bodies.size()];
    body.momentum[0] += 0.01 * i;
    return body;
  };
  auto const lane_of = [&](auto component) {
    return from_lanes<Wide>([&](int i) { return component(setup_of<D>(body_of(i))); });
  };
  auto const inertia = [&](int j) { return lane_of([j](auto const& setup) { return setup.system.inertia()[j]; }); };
  auto const y = [&](int j) { return lane_of([j](auto const& setup) { return setup.start.momentum[j]; }); };
  auto const q = [&](int j) { return lane_of([j](auto const& setup) { return setup.start.attitude.coeffs()[j]; }); };
  brouwer::Setup<RigidBody<Wide>> const setup{RigidBody<Wide>(Vector3<Wide>{inertia(0), inertia(1), inertia(2)}),
                                              Wide(1) / Wide(100),
                                              {{y(0), y(1), y(2)}, {q(3), q(0), q(1), q(2)}}};
  auto together = setup.start;
  advance(Dmv2<Wide>(setup), together, 300);
  for (int i = 0; i < 8; ++i) {
    auto const alone = setup_of<D>(body_of(i));
    auto state = alone.start;
    advance(Dmv2<D>(alone), state, 300);
    for_components([&](D const& a, Wide const& b) { EXPECT_TRUE(same(a, lane(b, i))) << a << ", not " << lane(b, i); },
                   state, together);
  }
}

TEST(DoubleDoubleIntegration, EndsWhereThereIsNoNumber) {
  auto setup = setup_of<D>(testing_support::generic_bodies()[0]);
  setup.start.momentum[1] = std::numeric_limits<D>::quiet_NaN();
  Dmv2<D> const step(setup);
  EXPECT_LE(step.blind_turns(), 1);
  auto state = setup.start;
  take_step(step, state);
  EXPECT_TRUE(std::isnan(state.momentum[0].high()));
}

TEST(DoubleDoubleIntegration, CompensationStillCarriesWhatRoundingCosts) {
  using State = RigidBodyState<D>;
  Hostile<double> hostile(17);
  State plain = setup_of<D>(testing_support::generic_bodies()[0]).start;
  Compensated<State> compensated(plain);
  Mpfr<256> exact(plain.momentum[0]);
  for (int i = 0; i < 10'000; ++i) {
    D const d = abs(hostile.number(2)) / 1000;
    State const increment{{d, D(0), D(0)}, {D(0), D(0), D(0), D(0)}};
    plain = sum(plain, increment);
    compensated.add(increment);
    exact += Mpfr<256>(d);
  }
  auto const error = [&](Mpfr<256> const& a) { return static_cast<double>(Mpfr<256>(abs(Mpfr<256>(a / exact - 1)))); };
  Mpfr<256> const meant = Mpfr<256>(compensated.value.momentum[0]) + Mpfr<256>(compensated.residue.momentum[0]);
  EXPECT_GT(error(Mpfr<256>(plain.momentum[0])), 0x1p-106);
  EXPECT_LT(error(meant), 0x1p-104);
  EXPECT_LT(error(meant), error(Mpfr<256>(plain.momentum[0])) / 10);
}

}  // namespace
}  // namespace brouwer
