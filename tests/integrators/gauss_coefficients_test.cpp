// Coefficients of implicit methods: their defining conditions at 50 digits, and what each form holds exactly.
#include <brouwer/integrators/gauss_coefficients.hpp>
#include <brouwer/scalar/double_double.hpp>

#include <gtest/gtest.h>

#include <string>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Judge;

double size(Judge const& a) { return static_cast<double>(abs(a)); }

Judge power(Judge const& a, std::size_t n) {
  Judge product = 1;
  for (std::size_t i = 0; i < n; ++i) product *= a;
  return product;
}

struct AGaussMethod : testing::TestWithParam<int> {
  std::size_t s = static_cast<std::size_t>(GetParam());
  ImplicitTableau<Judge> exact = gauss_tableau<Judge>(GetParam());

  Judge node(std::size_t i) const {
    Judge sum = 0;
    for (std::size_t j = 0; j < s; ++j) sum += exact.a[i][j];
    return sum;
  }
  template <class E>
  ImplicitCoefficients<E> const& in(CoefficientForm form) const {
    return implicit_coefficients<E>(implicit_methods()[s], form);
  }
};
INSTANTIATE_TEST_SUITE_P(OfStages, AGaussMethod, testing::Range(1, 9));

/// f(E{}) for every kind of arithmetic.
template <class F>
void in_every_arithmetic(F f) {
  f(0.0F);
  f(0.0);
  f(0.0L);
  f(DoubleDouble<double>(0));
  f(Float128(0));
  f(Mpfr<128>(0));
}

/// B(2s): Σ bᵢ cᵢᵏ⁻¹ = 1/k up to k = 2s
TEST_P(AGaussMethod, IntegratesPolynomialsOfDegree2sMinus1AndNoneOfTheNext) {
  auto const defect = [&](std::size_t k) {
    Judge sum = 0;
    for (std::size_t i = 0; i < s; ++i) sum += exact.b[i] * power(node(i), k - 1);
    return size(sum - Judge(1) / k);
  };
  for (std::size_t k = 1; k <= 2 * s; ++k) EXPECT_LT(defect(k), 1e-74) << k;
  EXPECT_GT(defect(2 * s + 1), 1e-12);
}

/// C(s): Σⱼ aᵢⱼ cⱼᵏ⁻¹ = cᵢᵏ/k up to k = s
TEST_P(AGaussMethod, Collocates) {
  for (std::size_t i = 0; i < s; ++i)
    for (std::size_t k = 1; k <= s; ++k) {
      Judge sum = 0;
      for (std::size_t j = 0; j < s; ++j) sum += exact.a[i][j] * power(node(j), k - 1);
      EXPECT_LT(size(sum - power(node(i), k) / k), 1e-74) << i << ' ' << k;
    }
}

/// bᵢaᵢⱼ + bⱼaⱼᵢ = bᵢbⱼ
TEST_P(AGaussMethod, IsSymplectic) {
  auto const& t = exact;
  for (std::size_t i = 0; i < s; ++i)
    for (std::size_t j = 0; j < s; ++j)
      EXPECT_LT(size(t.b[i] * t.a[i][j] + t.b[j] * t.a[j][i] - t.b[i] * t.b[j]), 1e-75) << i << ' ' << j;
}

TEST_P(AGaussMethod, HasAStandardFormThatIsRoundedOnce) {
  in_every_arithmetic([&](auto zero) {
    using E = decltype(zero);
    auto const& c = in<E>(CoefficientForm::standard);
    for (std::size_t i = 0; i < s; ++i) {
      EXPECT_EQ(c.v[i], rounded<E>(exact.b[i]));
      EXPECT_EQ(c.w[i], 1);
      for (std::size_t j = 0; j < s; ++j) EXPECT_EQ(c.m[i][j], rounded<E>(exact.a[i][j])) << i << ' ' << j;
    }
  });
}

/// One part is a multiple of 2⁻¹⁰; both are the coefficient to eleven bits more than one number could hold.
template <class E>
void expect_split(E const& leading, E const& rest, Judge const& whole) {
  Judge const in_units = Judge(leading) * 1024;
  EXPECT_EQ(in_units, floor(in_units));
  EXPECT_LE(abs(Judge(rest)), Judge(1) / 2048);
  EXPECT_LE(size(Judge(leading) + Judge(rest) - whole), std::ldexp(static_cast<double>(epsilon<E>()), -13));
}

TEST_P(AGaussMethod, HasASplitFormWithAShortLeadingPart) {
  in_every_arithmetic([&](auto zero) {
    using E = decltype(zero);
    auto const& c = in<E>(CoefficientForm::split);
    for (std::size_t i = 0; i < s; ++i) {
      expect_split(c.v[i], c.v_rest[i], exact.b[i]);
      for (std::size_t j = 0; j < s; ++j) expect_split(c.m[i][j], c.m_rest[i][j], exact.a[i][j]);
    }
  });
}

/// μᵢⱼ + μⱼᵢ = 1 without rounding, and in time's mirror μ is its transpose; bⱼμᵢⱼ is aᵢⱼ.
TEST_P(AGaussMethod, HasASymplecticFormThatIsSymplecticExactly) {
  in_every_arithmetic([&](auto zero) {
    using E = decltype(zero);
    auto const& c = in<E>(CoefficientForm::symplectic);
    for (std::size_t i = 0; i < s; ++i)
      for (std::size_t j = 0; j < s; ++j) {
        EXPECT_EQ(Judge(c.m[i][j]) + Judge(c.m[j][i]), 1) << i << ' ' << j;
        EXPECT_EQ(c.m[s - 1 - i][s - 1 - j], c.m[j][i]) << i << ' ' << j;
        EXPECT_LE(size(exact.b[j] * Judge(c.m[i][j]) - exact.a[i][j]), 0.5 * static_cast<double>(epsilon<E>()));
      }
  });
}

TEST_P(AGaussMethod, IsComputedOnce) {
  for (auto form : coefficient_forms)
    EXPECT_EQ(&in<double>(form), &implicit_coefficients<double>(implicit_methods()[s], form));
}

TEST(ImplicitMethods, AreNamedByTheirOrder) {
  for (auto const& m : implicit_methods()) {
    if (m.is_gauss()) {
      EXPECT_EQ(m.name, "gauss-" + std::to_string(m.order));
    }
    EXPECT_EQ(forms_of(m).size(), m.is_gauss() ? 3U : 1U);
  }
}

TEST(ImplicitMethods, EulersHasOneCoefficient) {
  for (auto form : coefficient_forms) {
    auto const& c = implicit_coefficients<double>(implicit_methods()[0], form);
    EXPECT_EQ(c.stages, 1U);
    EXPECT_EQ(c.m[0][0] + c.m_rest[0][0], 1);
    EXPECT_EQ(c.v[0] + c.v_rest[0], 1);
    EXPECT_EQ(c.w[0], 1);
  }
}

}  // namespace
}  // namespace brouwer
