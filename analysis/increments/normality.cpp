#include "analysis/increments/normality.hpp"

#include <gsl/gsl_sf_erf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace brouwer {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// log Φ(z), also where Φ underflows.
double log_normal(double z) { return gsl_sf_log_erfc(-z / std::numbers::sqrt2) - std::numbers::ln2; }

/// In ascending order, less their mean and over their deviation.
void standardise(std::vector<double>& values) {
  auto const n = static_cast<double>(values.size());
  std::sort(values.begin(), values.end());
  double const mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (double const x : values) squares += (x - mean) * (x - mean);
  double const deviation = std::sqrt(squares / (n - 1));
  for (auto& x : values) x = (x - mean) / deviation;
}

double anderson_darling(std::vector<double> const& z) {
  auto const n = static_cast<double>(z.size());
  double sum = 0;
  for (std::size_t i = 0; i < z.size(); ++i)
    sum += (2 * static_cast<double>(i) + 1) * (log_normal(z[i]) + log_normal(-z[z.size() - 1 - i]));
  return (-n - sum / n) * (1 + 0.75 / n + 2.25 / (n * n));
}

/// exp(c₀ + c₁A + c₂A²), or one less it, for A below `until`.
struct Piece {
  double until;
  bool complement;
  double c0, c1, c2;
};
constexpr Piece pieces[] = {{0.2, true, -13.436, 101.14, -223.73},
                            {0.34, true, -8.318, 42.796, -59.938},
                            {0.6, false, 0.9177, -4.279, -1.38},
                            {std::numeric_limits<double>::infinity(), false, 1.2937, -5.709, 0.0186}};

double p_value(double statistic) {
  if (std::isnan(statistic)) return undefined;
  double const A = std::min(statistic, 10.0);
  auto const piece = std::find_if(std::begin(pieces), std::end(pieces), [&](Piece const& p) { return A < p.until; });
  double const value = std::exp(piece->c0 + A * (piece->c1 + A * piece->c2));
  return piece->complement ? 1 - value : value;
}

}  // namespace

PowerSums& PowerSums::operator+=(PowerSums const& other) {
  count += other.count;
  first += other.first;
  second += other.second;
  third += other.third;
  fourth += other.fourth;
  return *this;
}

double PowerSums::variance() const { return second / count - mean() * mean(); }

double PowerSums::skewness() const {
  double const m = mean();
  return (third / count - 3 * m * second / count + 2 * m * m * m) / std::pow(variance(), 1.5);
}

double PowerSums::excess_kurtosis() const {
  double const m = mean(), v = variance();
  return (fourth / count - 4 * m * third / count + 6 * m * m * second / count - 3 * m * m * m * m) / (v * v) - 3;
}

Normality normality(std::vector<double> values, PowerSums const& moments) {
  Normality found{moments.skewness(), moments.excess_kurtosis(), undefined, std::ssize(values), undefined};
  if (values.size() < fewest_for_normality) return found;
  standardise(values);
  found.anderson_darling = anderson_darling(values);
  found.p = p_value(found.anderson_darling);
  return found;
}

}  // namespace brouwer
