#pragma once
#include <cstdint>
#include <vector>

#include "analysis/interval.hpp"

namespace brouwer {

/// ρ_k, the correlation of increments that are `lag` samples apart; 0 for a random walk.
struct Autocorrelation {
  std::int64_t lag = 1;
  double rho = 0;
  Interval interval;  ///< over members, which are independent whatever their increments are; NaN for one member
  double p = 1;       ///< two-sided, of no correlation
};

/// The walk at one scale: increments over longer and longer durations, and the single ones that they are made of.
struct VarianceRatio {
  double scale = 0;  ///< mean duration of the aggregated increments, in units of time
  double ratio = 1;  ///< their variance per unit of time over that of the single increments in them; 1 for a walk
  Interval interval;
  double p = 1;      ///< two-sided, of a ratio of 1
  double sigma = 0;  ///< σ of the walk at this scale, per √(unit of time)
  Interval sigma_interval;
};

/// Are the increments of a walk normal? Effect sizes, and a test.
struct Normality {
  double skewness = 0;
  double excess_kurtosis = 0;
  double anderson_darling = 0;  ///< A² with its correction for finite samples, mean and variance estimated
  std::int64_t tested = 0;      ///< values that A² has seen
  double p = 1;
};

/// What the increments of one quantity of one cell say of the model.
struct IncrementTests {
  std::int64_t count = 0;                         ///< M(J−1)
  std::vector<Autocorrelation> autocorrelations;  ///< lags 1, 2, …; none for fewer than three sample times
  std::vector<VarianceRatio> variance_ratios;     ///< scales from short to long, by factors of about 2
  double variance_ratio_p = 1;                    ///< of all ratios being 1: the smallest of Holm's; NaN where none
  Normality normality;
  std::vector<double> histogram_z, histogram_density;  ///< centres of equal bins, of increments over their σ
};

}  // namespace brouwer
