// Carlson's R_C and R_J against Boost.Math at 77 digits, closed forms, ulps in double, and lanes. (R_F: elliptic_test.cpp)
#include <brouwer/special/carlson.hpp>

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_rc.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>

#include "tests/lanes.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Judge;
using testing_support::packed;
using testing_support::relative_ulps;
using testing_support::same_bits;
using testing_support::Uniform;

Judge relative(Judge const& a, Judge const& b) { return abs(Judge(a / b - 1)); }

/// 10⁻⁶ … 10⁶
double any_size(Uniform& uniform) { return std::pow(10.0, uniform(-6, 6)); }

TEST(CarlsonRc, AgreesWithBoostTo70Digits) {
  Uniform uniform(1);
  for (int i = 0; i < 40; ++i) {
    Judge const x = i % 10 == 0 ? 0 : any_size(uniform), y = any_size(uniform) * (i % 3 == 1 && x > 0 ? -1 : 1);
    EXPECT_LT(relative(carlson_rc(x, y), boost::math::ellint_rc(x, y)), Judge("1e-70")) << x << ' ' << y;
  }
  EXPECT_EQ(carlson_rc(Judge(0), Judge(-2)), 0);
}

TEST(CarlsonRc, IsAnArcTangentAndALogarithm) {
  // [DLMF 19.2.18, 19.2.19]
  Judge const x("0.3"), y("1.7");
  EXPECT_LT(relative(carlson_rc(x, y), atan(sqrt(Judge((y - x) / x))) / sqrt(Judge(y - x))), Judge("1e-75"));
  EXPECT_LT(relative(carlson_rc(y, x), log(Judge((sqrt(y) + sqrt(Judge(y - x))) / sqrt(x))) / sqrt(Judge(y - x))),
            Judge("1e-75"));
  EXPECT_LT(relative(carlson_rc(Judge(0), Judge(Judge(1) / 4)), boost::math::constants::pi<Judge>()), Judge("1e-75"));
  EXPECT_LT(relative(carlson_rc(y, y), 1 / sqrt(y)), Judge("1e-75"));
  EXPECT_LT(relative(carlson_rc(x, y), carlson_rf(x, y, y)), Judge("1e-75"));
}

TEST(CarlsonRj, AgreesWithBoostTo65Digits) {
  Uniform uniform(2);
  for (int i = 0; i < 40; ++i) {
    Judge const x = i % 5 == 0 ? 0 : any_size(uniform), y = any_size(uniform), z = any_size(uniform);
    Judge const p = any_size(uniform);
    EXPECT_LT(relative(carlson_rj(x, y, z, p), boost::math::ellint_rj(x, y, z, p)), Judge("1e-65"))
        << x << ' ' << y << ' ' << z << ' ' << p;
  }
}

TEST(CarlsonRj, HasItsClosedFormsAndIsHomogeneousAndSymmetric) {
  Judge const x("0.3"), y("1.7"), z("4"), p("0.9");
  Judge const value = carlson_rj(x, y, z, p);
  EXPECT_LT(relative(carlson_rj(z, x, y, p), value), Judge("1e-75"));
  EXPECT_LT(relative(carlson_rj(Judge(4 * x), Judge(4 * y), Judge(4 * z), Judge(4 * p)), value / 8), Judge("1e-75"));
  // [DLMF 19.20.6 … 19.20.8]
  EXPECT_LT(relative(carlson_rj(x, x, x, x), 1 / (x * sqrt(x))), Judge("1e-75"));
  EXPECT_LT(relative(carlson_rj(x, x, x, p), 3 / (x - p) * (carlson_rc(x, p) - 1 / sqrt(x))), Judge("1e-74"));
  EXPECT_LT(relative(carlson_rj(x, y, y, p), 3 / (p - y) * (carlson_rc(x, y) - carlson_rc(x, p))), Judge("1e-74"));
  // R_J(0, y, y, p) = 3π / (2 (y√p + p√y))
  Judge const pi = boost::math::constants::pi<Judge>();
  EXPECT_LT(relative(carlson_rj(Judge(0), y, y, p), 3 * pi / (2 * (y * sqrt(p) + p * sqrt(y)))), Judge("1e-75"));
}

TEST(CarlsonRj, AgreesWithPublishedValues) {
  // B. C. Carlson, Numer. Algorithms 10 (1995) 13, section 3
  EXPECT_NEAR(carlson_rj(0.0, 1.0, 2.0, 3.0), 0.77688623778582, 1e-14);
  EXPECT_NEAR(carlson_rj(2.0, 3.0, 4.0, 5.0), 0.14297579667157, 1e-14);
  EXPECT_NEAR(carlson_rc(0.0, 0.25), 3.1415926535898, 1e-13);
  EXPECT_NEAR(carlson_rc(2.25, 2.0), 0.69314718055995, 1e-14);
  EXPECT_NEAR(carlson_rc(0.25, -2.0), 0.23104906018665, 1e-14);
}

TEST(CarlsonRj, ErrsByLittleInEveryArithmetic) {
  auto const worst = [](auto zero, int count) {
    using T = decltype(zero);
    Uniform uniform(3);
    double rc = 0, rj = 0;
    for (int i = 0; i < count; ++i) {
      auto const draw = [&] { return static_cast<T>(any_size(uniform)); };
      T const x = i % 7 == 0 ? T(0) : draw(), y = draw(), z = draw(), p = draw();
      rc = std::max(rc, relative_ulps(carlson_rc(x, y), carlson_rc(Judge(x), Judge(y))));
      rj = std::max(rj, relative_ulps(carlson_rj(x, y, z, p), carlson_rj(Judge(x), Judge(y), Judge(z), Judge(p))));
    }
    return std::pair{rc, rj};
  };
  auto const in_float = worst(0.0F, 500), in_double = worst(0.0, 2000), in_quadruple = worst(Float128(0), 200);
  for (auto const& [name, errors] : {std::pair{"float", in_float}, {"double", in_double}, {"float128", in_quadruple}}) {
    RecordProperty(std::string(name) + "_rc", std::to_string(errors.first));
    RecordProperty(std::string(name) + "_rj", std::to_string(errors.second));
    EXPECT_LT(errors.first, 2.5) << name;
    EXPECT_LT(errors.second, 5) << name;
  }
}

template <class T>
struct CarlsonLanes : testing::Test {
  static std::vector<T> numbers(std::uint64_t seed) {
    using E = Element<T>;
    Uniform uniform(seed);
    std::vector<E> all(4000);
    for (auto& a : all) a = static_cast<E>(any_size(uniform));
    for (std::size_t i = 0; i < all.size(); i += 9) all[i] = 0;
    return packed<T>(all);
  }
};
using Packs = testing::Types<Pack<double, 2>, Pack<double, 4>, Pack<double, 8>, Pack<float, 4>, Pack<float, 8>>;
TYPED_TEST_SUITE(CarlsonLanes, Packs);

TYPED_TEST(CarlsonLanes, EqualTheScalarBitForBit) {
  using E = Element<TypeParam>;
  auto const xs = this->numbers(5), ys = this->numbers(6), zs = this->numbers(7), ps = this->numbers(8);
  int differing = 0;
  for (std::size_t n = 0; n < xs.size(); ++n) {
    TypeParam const y = ys[n] + TypeParam(1), z = zs[n] + TypeParam(1), p = ps[n] + TypeParam(1);
    auto const rc = carlson_rc(xs[n], TypeParam(y - TypeParam(2))), rj = carlson_rj(xs[n], y, z, p);
    for (int i = 0; i < lanes<TypeParam>; ++i) {
      differing += !same_bits(rc[i], carlson_rc(E(xs[n][i]), E(y[i] - E(2))));
      differing += !same_bits(rj[i], carlson_rj(E(xs[n][i]), E(y[i]), E(z[i]), E(p[i])));
    }
  }
  EXPECT_EQ(differing, 0);
}

}  // namespace
}  // namespace brouwer
