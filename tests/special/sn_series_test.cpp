// The double power series of sn(v)/v, and the quadrature that uses it.
#include <brouwer/special/elliptic.hpp>
#include <brouwer/special/gauss_legendre.hpp>
#include <brouwer/special/sn_series.hpp>

#include <gtest/gtest.h>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Judge;

TEST(SnSeriesIntegers, AreThoseOfTheMaclaurinSeries) {
  // sn u = u − (1 + k²) u³/3! + (1 + 14k² + k⁴) u⁵/5! − … [DLMF 22.10.1]; 1 + 14k² + k⁴ = σ² + 12π
  auto const c = detail::sn_series_integers();
  EXPECT_EQ(c[1][0], -1);
  EXPECT_EQ(c[2][0], 1);
  EXPECT_EQ(c[2][1], 12);
  EXPECT_EQ(c[3][0], -1);
  EXPECT_EQ(c[3][1], -132);  // 135 − 3
}

template <class T>
struct SnSeriesIn : testing::Test {};
using Scalars = testing::Types<float, double, long double, Float128, Judge>;
TYPED_TEST_SUITE(SnSeriesIn, Scalars);

TYPED_TEST(SnSeriesIn, HasFullPrecisionWithAsManyTermsAsItAsksFor) {
  using E = Mpfr<512>;
  for (double v : {1e-4, 0.003, 0.01, 0.1, 0.3})
    for (double k : {0.0, 0.3, 0.9, 1.0}) {
      int const terms = SnSeries<TypeParam>::terms_needed((1 + k * k) * v * v * 1.0000001);
      if (terms > SnSeries<TypeParam>::most_terms) continue;  // then the step is halved
      TypeParam const A = TypeParam(v) * TypeParam(v), B = TypeParam(k) * TypeParam(k) * A;
      auto const exact = jacobi_elliptic(E(v), E(k));
      auto const error = [&](int n) {  // the larger of both functions'
        auto const values = SnSeries<TypeParam>(n)(A + B, A * B);
        E const of_g = abs(E(E(values.g) - exact.sn / E(v)));
        E const of_slope = abs(E(E(values.slope_less_one) - (exact.cn * exact.dn - 1)));
        return static_cast<double>(E(larger(of_g, of_slope) / E(epsilon<TypeParam>())));
      };
      EXPECT_LT(error(terms), 1.0) << "v " << v << " k " << k;
      // one term less would not do: the count is not just large enough, it is needed
      if (terms > 2) {
        EXPECT_GT(error(terms - 1), 1e-3) << "v " << v << " k " << k;
      }
    }
}

TEST(GaussLegendre, IsExactForPolynomialsOfDegree2nMinus1) {
  for (int n : {1, 2, 5, 12}) {
    GaussLegendre<Judge> const rule(n);
    Judge sum = 0, above = 0;
    for (auto const& [x, weight] : rule.nodes()) {
      sum += weight * pow(x, 2 * n - 1);
      above += weight * pow(x, 2 * n);
    }
    EXPECT_LT(abs(Judge(sum - Judge(1) / (2 * n))), Judge("1e-75")) << n;
    EXPECT_GT(abs(Judge(above - Judge(1) / (2 * n + 1))), Judge("1e-30")) << n << ": degree 2n must not be exact";
  }
}

TEST(GaussLegendre, NodesNeededGivesFullPrecision) {
  // ∫₀¹ dx / (1 + x²) = π/4, nearest singularity 1 off the axis of an interval of length 1
  auto const f = [](Judge const& x) { return Judge(1 / (1 + x * x)); };
  GaussLegendre<Judge> const rule(GaussLegendre<Judge>::nodes_needed(1, 0.86));
  Judge sum = 0;
  for (auto const& [x, weight] : rule.nodes()) sum += weight * f(x);
  EXPECT_LT(abs(Judge(sum - boost::math::constants::pi<Judge>() / 4)), Judge("1e-75"));
}

}  // namespace
}  // namespace brouwer
