// Elliptic functions and integrals against 77 digits, against Boost.Math at 77 digits, and at their limits.
#include <brouwer/special/elliptic.hpp>
#include <brouwer/special/elliptic_variants.hpp>

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::absolute_ulps;
using testing_support::Judge;
using testing_support::relative_ulps;
using testing_support::Uniform;

/// Moduli: three quarters uniform in (0, 1), one quarter log-uniform towards 1 down to 1 − k = 10⁻¹⁵.
double random_modulus(Uniform& uniform, int i) {
  return i % 4 != 0 ? uniform(0, 1) : 1 - std::pow(10.0, uniform(-15, -1));
}

TEST(JacobiEllipticInMpfr, AgreesWithBoostTo55Digits) {
  Uniform uniform(1);
  for (int i = 0; i < 40; ++i) {
    Judge const k = random_modulus(uniform, i), u = uniform(-8, 8);
    auto const ours = jacobi_elliptic(u, k), boosts = BoostElliptic::jacobi(u, k);
    // Boost loses digits near k = 1; 55 of 77 remain over these moduli
    Judge const bound("1e-55");
    EXPECT_LT(abs(Judge(ours.sn - boosts.sn)), bound) << "u = " << u << ", k = " << k;
    EXPECT_LT(abs(Judge(ours.cn - boosts.cn)), bound);
    EXPECT_LT(abs(Judge(ours.dn - boosts.dn)), bound);
  }
}

TEST(JacobiEllipticInMpfr, SatisfiesItsDifferentialEquation) {
  // sn' = cn dn, by a central difference at 77 digits with step 10⁻²⁵: error 10⁻⁵⁰
  Uniform uniform(2);
  Judge const step("1e-25");
  for (int i = 0; i < 20; ++i) {
    Judge const k = random_modulus(uniform, i), u = uniform(-5, 5);
    auto const now = jacobi_elliptic(u, k);
    Judge const slope = (jacobi_elliptic(Judge(u + step), k).sn - jacobi_elliptic(Judge(u - step), k).sn) / (2 * step);
    EXPECT_LT(abs(Judge(slope - now.cn * now.dn)), Judge("1e-48")) << "u = " << u << ", k = " << k;
  }
}

TEST(JacobiEllipticInDouble, ErrsByAtMost12UlpOfOne) {
  Uniform uniform(3);
  double worst_sn = 0, worst_cn = 0, worst_dn = 0;
  for (int i = 0; i < 4000; ++i) {
    double const k = random_modulus(uniform, i), u = uniform(-10, 10) * (i % 7 == 0 ? 1e-9 : 1);
    auto const ours = jacobi_elliptic(u, k);
    auto const exact = jacobi_elliptic(Judge(u), Judge(k));
    worst_sn = std::max(worst_sn, absolute_ulps(ours.sn, exact.sn));
    worst_cn = std::max(worst_cn, absolute_ulps(ours.cn, exact.cn));
    worst_dn = std::max(worst_dn, absolute_ulps(ours.dn, exact.dn));
  }
  EXPECT_LT(worst_sn, 12);
  EXPECT_LT(worst_cn, 12);
  EXPECT_LT(worst_dn, 12);
  RecordProperty("worst", std::to_string(std::max({worst_sn, worst_cn, worst_dn})));
}

TEST(JacobiElliptic, OfSmallArgumentsKeepsRelativeAccuracy) {
  for (double u : {1e-300, 1e-30, 1e-9, 1e-7, 1e-4}) {
    auto const exact = jacobi_elliptic(Judge(u), Judge(0.7));
    EXPECT_LT(relative_ulps(jacobi_elliptic(u, 0.7).sn, exact.sn), 4) << u;
  }
}

TEST(JacobiElliptic, IsTrigonometricForZeroModulusAndHyperbolicForOne) {
  for (double u : {-3.0, -0.5, 0.0, 1e-8, 2.0, 30.0}) {
    auto const circular = jacobi_elliptic(u, 0.0), hyperbolic = jacobi_elliptic(u, 1.0);
    EXPECT_NEAR(circular.sn, std::sin(u), 4e-16);
    EXPECT_NEAR(circular.cn, std::cos(u), 4e-16);
    EXPECT_EQ(circular.dn, 1);
    EXPECT_NEAR(hyperbolic.sn, std::tanh(u), 4e-16);
    EXPECT_NEAR(hyperbolic.cn, 1 / std::cosh(u), 4e-16);
    EXPECT_NEAR(hyperbolic.dn, 1 / std::cosh(u), 4e-16);
  }
}

TEST(JacobiElliptic, ReturnsAfterAPeriod) {
  Judge const k("0.6"), period = 4 * complete_elliptic_k(k), u("0.3");
  auto const now = jacobi_elliptic(u, k), later = jacobi_elliptic(Judge(u + period), k);
  EXPECT_LT(abs(Judge(now.sn - later.sn)), Judge("1e-75"));
  EXPECT_LT(abs(Judge(now.dn - later.dn)), Judge("1e-75"));
}

TEST(EllipticF, InvertsSnAndAgreesWithBoostTo55Digits) {
  Uniform uniform(4);
  for (int i = 0; i < 40; ++i) {
    Judge const k = random_modulus(uniform, i), phi = uniform(-3.1, 3.1);
    Judge const f = elliptic_f(phi, k);
    EXPECT_LT(abs(Judge(jacobi_elliptic(f, k).sn - sin(phi))), Judge("1e-74"));
    // Boost forms 1 − k² sin²φ and loses what cancels there
    EXPECT_LT(abs(Judge(f / BoostElliptic::f(phi, k) - 1)), Judge("1e-55"));
  }
}

TEST(EllipticF, AgreesWithCarlsonsIntegral) {
  Uniform uniform(7);
  for (int i = 0; i < 200; ++i) {
    Judge const k = random_modulus(uniform, i), phi = uniform(-1.57, 1.57) * std::pow(10.0, i % 3 == 0 ? -i / 10 : 0);
    Judge const s = sin(phi), c2 = squared(Judge(cos(phi)));
    Judge const exact = s * carlson_rf(c2, Judge(c2 + complementary_parameter(k) * s * s), Judge(1));
    EXPECT_LT(abs(Judge(elliptic_f(phi, k) / exact - 1)), Judge("1e-75")) << "phi = " << phi << ", k = " << k;
  }
}

TEST(EllipticF, OfModulusOneIsTheInverseGudermannianAndInfiniteBeyond) {
  for (double phi : {-1.5, -0.3, 0.0, 1e-12, 1.2}) EXPECT_NEAR(elliptic_f(phi, 1.0), std::asinh(std::tan(phi)), 2e-15);
  EXPECT_EQ(elliptic_f(2.0, 1.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(elliptic_f(-2.0, 1.0), -std::numeric_limits<double>::infinity());
}

TEST(JacobiAdvanced, GoesOnFromAPointOfEveryQuadrantAndOnTheSeparatrix) {
  Uniform uniform(8);
  for (int i = 0; i < 400; ++i) {
    double const k = i % 5 == 0 ? 1 : random_modulus(uniform, i), u = uniform(-3, 3), v = uniform(-1, 1);
    double const scale = uniform(0.1, 10), side = i % 2 == 0 ? 1 : -1;  // half a period: sn and cn change sign
    auto const now = jacobi_elliptic(Judge(u), Judge(k)), later = jacobi_elliptic(Judge(Judge(u) + v), Judge(k));
    if (abs(now.cn) < 1e-3) continue;  // rounding sn : cn would decide
    auto const ours =
        jacobi_advanced(scale * side * static_cast<double>(now.sn), scale * side * static_cast<double>(now.cn), v, k);
    EXPECT_LT(absolute_ulps(ours.sn, Judge(side * later.sn)), 400) << "u = " << u << ", k = " << k;
    EXPECT_LT(absolute_ulps(ours.cn, Judge(side * later.cn)), 400) << "u = " << u << ", k = " << k;
    EXPECT_LT(absolute_ulps(ours.dn, later.dn), 400) << "u = " << u << ", k = " << k;
  }
}

TEST(EllipticF, ErrsByAtMost4UlpInDouble) {
  Uniform uniform(5);
  double worst = 0;
  for (int i = 0; i < 4000; ++i) {
    double const k = random_modulus(uniform, i), phi = uniform(-3.14, 3.14);
    worst = std::max(worst, relative_ulps(elliptic_f(phi, k), elliptic_f(Judge(phi), Judge(k))));
  }
  EXPECT_LT(worst, 4);
}

TEST(CompleteEllipticK, HasItsClosedFormValueAndErrsByAtMost4Ulp) {
  // K(1/√2) = Γ(1/4)² / (4√π)
  Judge const k = 1 / sqrt(Judge(2)), gamma = boost::math::tgamma(Judge(Judge(1) / 4));
  Judge const pi = boost::math::constants::pi<Judge>();
  EXPECT_LT(abs(Judge(complete_elliptic_k(k) - gamma * gamma / (4 * sqrt(pi)))), Judge("1e-75"));
  Uniform uniform(6);
  for (int i = 0; i < 2000; ++i) {
    double const modulus = random_modulus(uniform, i);
    ASSERT_LT(relative_ulps(complete_elliptic_k(modulus), complete_elliptic_k(Judge(modulus))), 4) << modulus;
  }
}

TEST(CarlsonRf, IsHomogeneousSymmetricAndKnowsTheLogarithm) {
  Judge const x("0.3"), y("1.7"), z("4");
  Judge const value = carlson_rf(x, y, z);
  EXPECT_LT(abs(Judge(carlson_rf(z, x, y) - value)), Judge("1e-76"));
  EXPECT_LT(abs(Judge(carlson_rf(Judge(4 * x), Judge(4 * y), Judge(4 * z)) - value / 2)), Judge("1e-76"));
  // R_F(x, y, y) = R_C(x, y) = arctan √((y−x)/x) / √(y−x) [DLMF 19.6.7, 19.2.18]
  Judge const degenerate = atan(sqrt(Judge((y - x) / x))) / sqrt(Judge(y - x));
  EXPECT_LT(abs(Judge(carlson_rf(x, y, y) - degenerate)), Judge("1e-76"));
}

TEST(EllipticVariants, AgreeWithOneAnotherInDouble) {
  for (double k : {0.1, 0.4, 0.9})
    for (double u : {-2.5, 0.2, 1.4}) {
      auto const own = OwnElliptic::jacobi(u, k), gsl = GslElliptic::jacobi(u, k), boost = BoostElliptic::jacobi(u, k);
      EXPECT_NEAR(own.sn, gsl.sn, 2e-15);
      EXPECT_NEAR(own.dn, gsl.dn, 2e-15);
      EXPECT_NEAR(own.sn, boost.sn, 1e-12);
      EXPECT_NEAR(OwnElliptic::f(u, k), GslElliptic::f(u, k), 2e-15);
      EXPECT_NEAR(OwnElliptic::f(u, k), BoostElliptic::f(u, k), 2e-15);
    }
}

TEST(EllipticVariants, NeitherThrowNorAbortOutsideTheDomain) {
  for (double k : {-0.5, 1.0 + 1e-15, 1.5, std::numeric_limits<double>::quiet_NaN()})
    for (double u : {0.0, 0.3, 1.57, 1e300}) {
      EXPECT_NO_THROW(OwnElliptic::jacobi(u, k));
      EXPECT_NO_THROW(OwnElliptic::f(u, k));
      EXPECT_NO_THROW(GslElliptic::jacobi(u, k));
      EXPECT_NO_THROW(GslElliptic::f(u, k));
      EXPECT_NO_THROW(BoostElliptic::jacobi(u, k));
      EXPECT_NO_THROW(BoostElliptic::f(u, k));
    }
  EXPECT_TRUE(std::isnan(GslElliptic::jacobi(0.3, 1.5).sn));
}

}  // namespace
}  // namespace brouwer
