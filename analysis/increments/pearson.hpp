#pragma once

namespace brouwer {

/// P(X ≤ x) and P(X ≥ x).
struct BothTails {
  double lower, upper;
};

/// The tails of a law of mean 0, variance 1 and this skewness γ and excess kurtosis at z. Below a gamma variable's
/// kurtosis, 3γ²/2, Pearson's type I (beta) of the same four moments [N. L. Johnson, S. Kotz, N. Balakrishnan, Continuous
/// Univariate Distributions 1 (1994), 12.4.1]; from it on the gamma variable of the same kurtosis, as H. Liu, Y. Tang &
/// H. H. Zhang (Comput. Stat. Data Anal. 53 (2009) 853) have it for sums of χ²; the normal law where both are 0.
BothTails pearson_tails(double z, double skewness, double excess);

}  // namespace brouwer
