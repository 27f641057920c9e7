#pragma once
#include <cstddef>
#include <vector>

#include "analysis/increment_tests.hpp"

namespace brouwer {

/// Power sums of values, for their moments.
struct PowerSums {
  double count = 0, first = 0, second = 0, third = 0, fourth = 0;

  PowerSums& operator+=(PowerSums const& other);
  double mean() const { return first / count; }
  double variance() const;  ///< over count
  double skewness() const;
  double excess_kurtosis() const;
};

constexpr std::size_t fewest_for_normality = 8;      ///< of which the law of A² below is known
constexpr std::size_t most_for_normality = 100'000;  ///< values that are sorted; more are sampled

/// The test of T. W. Anderson & D. A. Darling (J. Am. Stat. Assoc. 49 (1954) 765) for a normal law whose mean and
/// variance are estimated: with z₍₁₎ ≤ … ≤ z₍ₙ₎ standardised by the sample's own mean and deviation (n − 1),
///
///     A² = −n − Σᵢ (2i − 1)/n · (log Φ(z₍ᵢ₎) + log Φ(−z₍ₙ₊₁₋ᵢ₎)),     A*² = A² (1 + 0.75/n + 2.25/n²),
///
/// and p of A*² as R. B. D'Agostino & M. A. Stephens, Goodness-of-Fit Techniques (1986), table 4.9, have fitted it;
/// from A*² = 10 on, p = 3.8e-24 is a bound. NaN for fewer than 8 values, or where all are equal.
/// @param values   their order is lost
/// @param moments  of all values, of which `values` may be a sample
Normality normality(std::vector<double> values, PowerSums const& moments);

}  // namespace brouwer
