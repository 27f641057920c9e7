// The test of normality, against its definition in 50 digits and its tables; and the histogram beside it.
#include "analysis/increments/normality.hpp"

#include <gmock/gmock.h>

#include <boost/math/distributions/normal.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "analysis/increments/histogram.hpp"
#include "tests/analysis/simulated.hpp"
#include "tests/analysis/simulated_increments.hpp"

namespace brouwer {
namespace {

/// The definition in 50 digits with another library's normal law.
double anderson_darling_in_50_digits(std::vector<double> x) {
  using Real = boost::multiprecision::cpp_bin_float_50;
  std::sort(x.begin(), x.end());
  Real const n = x.size();
  Real mean = 0, squares = 0, sum = 0;
  for (double const value : x) mean += value / n;
  for (double const value : x) squares += (value - mean) * (value - mean);
  boost::math::normal_distribution<Real> const law(mean, sqrt(squares / (n - 1)));
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += (2 * Real(i) + 1) * (log(cdf(law, Real(x[i]))) + log(cdf(complement(law, Real(x[x.size() - 1 - i])))));
  return static_cast<double>((-n - sum / n) * (1 + 0.75 / n + 2.25 / (n * n)));
}

TEST(Normality, IsAndersonAndDarlings) {
  Increments next(3);
  std::vector<double> x;
  for (int k = 0; k < 40; ++k) x.push_back(next.skewed());
  EXPECT_NEAR(normality(x, {}).anderson_darling, anderson_darling_in_50_digits(x), 1e-11);
}

/// Critical values of A*² as they are tabulated for both parameters estimated [D'Agostino & Stephens 1986, table 4.7].
TEST(Normality, HasTheTabulatedCriticalValues) {
  struct Row {
    double level, critical;
  };
  Normal normal(5);
  std::vector<double> found;
  for (int k = 0; k < 20000; ++k) {
    std::vector<double> x(50);
    for (auto& value : x) value = normal();
    found.push_back(normality(x, {}).p);
  }
  std::sort(found.begin(), found.end());
  for (double const level : {0.15, 0.1, 0.05, 0.025, 0.01, 0.005}) {
    auto const below = std::lower_bound(found.begin(), found.end(), level) - found.begin();
    EXPECT_NEAR(static_cast<double>(below) / 20000, level, 4 * std::sqrt(level / 20000)) << level;
  }
}

TEST(Normality, MeasuresTheShape) {
  PowerSums sums;
  for (double const x : {1., 2., 2., 3., 7.}) sums += {1, x, x * x, x * x * x, x * x * x * x};
  EXPECT_NEAR(sums.skewness(), 10.8 / std::pow(4.4, 1.5), 1e-12);  // about 3: −2, −1, −1, 0, 4
  EXPECT_NEAR(sums.excess_kurtosis(), 54.8 / (4.4 * 4.4) - 3, 1e-12);
}

TEST(Normality, OfFewOrEqualValuesIsNotTested) {
  EXPECT_TRUE(std::isnan(normality({1, 2, 3, 4, 5, 6, 7}, {}).p));
  EXPECT_TRUE(std::isnan(normality(std::vector<double>(9, 1.), {}).p));
}

TEST(Histogram, CountsEverythingOnce) {
  Histogram histogram(1000);
  for (int k = 0; k < 1000; ++k) histogram.add(-6 + 0.012 * k);
  histogram.add(std::nan(""));
  double area = 0;
  for (double const height : histogram.density()) area += height * histogram.width();
  EXPECT_NEAR(area, 1, 1e-12);
  EXPECT_EQ(histogram.bins() % 2, 1u);
  EXPECT_NEAR(histogram.centre(histogram.bins() / 2), 0, 1e-12);
  EXPECT_EQ(Histogram(5).density(), std::vector<double>(9, 0.0));
}

}  // namespace
}  // namespace brouwer
