// GSL's distributions, made safe, against Boost.Math in 113 bits.
#include "analysis/distributions.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>

namespace brouwer {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using StudentT = boost::math::students_t_distribution<Quad>;
using FisherF = boost::math::fisher_f_distribution<Quad>;
using ChiSquared = boost::math::chi_squared_distribution<Quad>;

constexpr double infinity = std::numeric_limits<double>::infinity();

double relative(double found, Quad expected) { return static_cast<double>(abs((found - expected) / expected)); }

TEST(Distributions, StudentTailsHoldElevenDigits) {
  for (double const dof : {1., 2., 15., 31., 63., 199., 200., 999., 99'999.})
    for (double const t : {0.01, 0.2, 1., 2.9, 3.1, 10., 30.})
      EXPECT_LT(relative(student_two_sided(t, dof), 2 * cdf(complement(StudentT(dof), t))), 1e-11) << dof << " " << t;
}

TEST(Distributions, StudentTailOfAHugeStatisticIsANumber) {
  EXPECT_LT(relative(student_two_sided(-457, 63), 2 * cdf(complement(StudentT(63), 457))), 1e-12);
  EXPECT_EQ(student_two_sided(-457, 1e5), 0);
  EXPECT_EQ(student_two_sided(infinity, 63), 0);
}

TEST(Distributions, StudentQuantilesHoldTwelveDigits) {
  for (double const dof : {1., 7., 63., 99'999.})
    for (double const tail : {0.0005, 0.025, 0.1})
      EXPECT_LT(relative(student_upper_quantile(tail, dof), quantile(complement(StudentT(dof), Quad(tail)))), 1e-12);
}

TEST(Distributions, FisherTailsHoldElevenDigitsEachInItsOwnTail) {
  for (double const m : {1., 15., 63., 999.})
    for (double const n : {2., 126., 4032., 199'000.})
      for (double const F : {0.1, 0.5, 1., 1.3, 3.}) {
        EXPECT_LT(relative(fisher_upper(F, m, n), cdf(complement(FisherF(m, n), F))), 1e-11)
            << m << " " << n << " " << F;
        EXPECT_LT(relative(fisher_lower(F, m, n), cdf(FisherF(m, n), F)), 1e-11) << m << " " << n << " " << F;
      }
}

TEST(Distributions, FisherKeepsItsDigitsForALargeEnsemble) {
  EXPECT_LT(relative(fisher_upper(1, 99'999, 1.99e7), cdf(complement(FisherF(99'999, 1.99e7), 1))), 1e-9);
}

TEST(Distributions, ChiSquaredQuantilesHoldTwelveDigits) {
  for (double const dof : {1., 63., 4032., 9999., 10'001., 1e5})
    for (double const p : {0.0005, 0.025, 0.975, 0.9995})
      EXPECT_LT(relative(chi_squared_quantile(p, dof), quantile(ChiSquared(dof), Quad(p))), 1e-12) << dof << " " << p;
}

TEST(Distributions, ChiSquaredQuantilesOfTwentyMillionDegreesAreNormal) {
  double const dof = 2e7, z = 1.959963984540054;
  EXPECT_NEAR((chi_squared_quantile(0.975, dof) - dof) / std::sqrt(2 * dof), z, 1e-3);
  EXPECT_NEAR((chi_squared_quantile(0.025, dof) - dof) / std::sqrt(2 * dof), -z, 1e-3);
}

TEST(Distributions, WhatIsNotDefinedIsNotANumber) {
  double const nan = std::numeric_limits<double>::quiet_NaN();
  for (double const p :
       {student_two_sided(nan, 3), student_two_sided(1, 0), student_upper_quantile(0.1, 0), fisher_upper(nan, 3, 3),
        fisher_upper(1, 0, 3), fisher_lower(1, 3, nan), chi_squared_quantile(0.1, nan)})
    EXPECT_TRUE(std::isnan(p));
  EXPECT_EQ(fisher_upper(infinity, 3, 3), 0);
  EXPECT_EQ(fisher_lower(infinity, 3, 3), 1);
}

}  // namespace
}  // namespace brouwer
