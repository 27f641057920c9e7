// Every arithmetic of the house is a Real, holds the bits that its name says, and converts without loss to wider ones.
#include <brouwer/scalar/double_double.hpp>
#include <brouwer/scalar/real.hpp>
#include <brouwer/scalar/wider.hpp>

#include <gtest/gtest.h>

namespace brouwer {
namespace {

template <class T>
struct Arithmetic : testing::Test {};
using Scalars = testing::Types<float, double, long double, Float128, Mpfr<128>, Mpfr<256>, Mpfr<512>,
                               DoubleDouble<double>, DoubleDouble<float>>;
TYPED_TEST_SUITE(Arithmetic, Scalars);

/// Those with one significand; a double-double's parts may lie apart.
template <class T>
struct OneSignificand : testing::Test {};
using OneSignificandScalars = testing::Types<float, double, long double, Float128, Mpfr<128>, Mpfr<256>, Mpfr<512>>;
TYPED_TEST_SUITE(OneSignificand, OneSignificandScalars);

TYPED_TEST(Arithmetic, IsRealAndIsJudgedInAWiderOne) {
  static_assert(Real<TypeParam>);
  static_assert(Real<Wider<TypeParam>>);
  EXPECT_GE(significand_bits<Wider<TypeParam>>, 7 * significand_bits<TypeParam> / 4);
}

TYPED_TEST(Arithmetic, ReturnsFromTheWiderOneUnchanged) {
  TypeParam const third = TypeParam(1) / TypeParam(3);
  EXPECT_EQ(rounded<TypeParam>(Wider<TypeParam>(third)), third);
  EXPECT_EQ(static_cast<TypeParam>(Mpfr<1024>(third)), third);
}

TYPED_TEST(Arithmetic, EpsilonIsTheLastBitOfOne) {
  using std::ldexp;
  EXPECT_GT(TypeParam(1) + epsilon<TypeParam>(), TypeParam(1));
  EXPECT_EQ(epsilon<TypeParam>(), ldexp(TypeParam(1), 1 - significand_bits<TypeParam>));
}

TYPED_TEST(OneSignificand, HasNothingBelowTheLastBit) {
  EXPECT_EQ(TypeParam(1) + epsilon<TypeParam>() / TypeParam(4), TypeParam(1));
}

TYPED_TEST(Arithmetic, SelectsByMask) {
  TypeParam const one(1), two(2);
  EXPECT_EQ(select(one < two, one, two), one);
  EXPECT_EQ(select(two < one, one, two), two);
  EXPECT_EQ(larger(one, two), two);
  EXPECT_EQ(sign_of(TypeParam(0)), one);
  EXPECT_EQ(sign_of(TypeParam(-3)), -one);
  EXPECT_TRUE(any(one < two) && all(one < two) && !any(two < one));
}

TEST(MpfrBits, AreAtLeastThoseAskedFor) {
  EXPECT_EQ(significand_bits<Mpfr<128>>, 128);
  EXPECT_EQ(significand_bits<Mpfr<256>>, 257);  // Boost counts decimal digits
  EXPECT_EQ(significand_bits<Mpfr<512>>, 513);
}

TEST(MpfrNumbers, AreCorrectlyRounded) {
  // 1/3 in 257 bits is 0.0101…01₂ with an error below half an ulp
  Mpfr<1024> const exact = Mpfr<1024>(1) / 3, ours = Mpfr<1024>(Mpfr<256>(1) / 3);
  EXPECT_LT(abs(Mpfr<1024>(ours - exact)), ldexp(Mpfr<1024>(1), -257 - 2));
}

TEST(Rounding, HappensOnce) {
  // 1 + 2⁻⁵³ + 2⁻¹⁰⁰ lies above the middle of 1 and 1 + 2⁻⁵²: once to double gives the upper one, via 64 bits the lower
  Float128 const x = Float128(1) + ldexp(Float128(1), -53) + ldexp(Float128(1), -100);
  EXPECT_EQ(rounded<double>(x), 1 + 0x1p-52);
}

}  // namespace
}  // namespace brouwer
