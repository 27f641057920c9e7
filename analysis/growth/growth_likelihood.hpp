#pragma once
#include "analysis/growth/growth_statistics.hpp"

namespace brouwer {

/// A law of growth in scaled units, and its restricted deviance −2 log L (up to a constant of the data).
struct GrowthFit {
  double deviance = 0;
  double rho = 0;             ///< ν²/σ²; ∞ where there is no walk
  double scale = 0;           ///< σ², or ν² where there is no walk
  double slope_variance = 0;  ///< v: of a member's weighted slope, τ² + scale/a
  double tau2 = 0;            ///< τ²
  double slope = 0;           ///< β̂

  double sigma2() const { return std::isinf(rho) ? 0 : scale; }
  double nu2() const { return std::isinf(rho) ? scale : rho * scale; }
};

/// Restricted maximum likelihood of the law of growth (sufficient statistics: growth_statistics.hpp).
///
/// With a, R and s̄ of d = 1 + ρλ as there, each member's slope sᵢ ~ N(β, v), v = τ² + scale/a, is independent of its
/// rest; β integrated out,
///
///     −2 log L = M(Σ log(1 + ρλⱼ) + log a + (J−1) log scale) + R/scale + (M−1) log v + Σ(sᵢ − s̄)²/v
///
/// (M − 1 in place of the first M where the course of the mean is free), whose minimum in scale and v is known in closed form, with τ > 0 and with τ = 0 alike. So all six laws
/// (with or without walk, slopes, noise) need a search in the one variable ρ: a scan, then Brent's minimiser.
class GrowthLikelihood {
 public:
  explicit GrowthLikelihood(GrowthStatistics const& statistics) : statistics_(statistics) {}

  GrowthStatistics const& statistics() const { return statistics_; }

  /// The best scale and slopes at this ρ. @param slopes  false: τ = 0
  GrowthFit at(double rho, bool slopes) const;

  /// The best ρ as well, 0 < ρ < ∞.
  GrowthFit best(bool slopes) const;

  /// −2 log L of given values at what `reduced` says of a ρ.
  double deviance(Reduced const& reduced, double scale, double slope_variance) const;

  /// The smallest deviance with σ², ν² or τ² held at `value`, over what remains of a law like `fit`.
  double with_sigma2(double value, GrowthFit const& fit, bool slopes) const;
  double with_nu2(double value, GrowthFit const& fit, bool slopes) const;
  double with_tau2(double value, GrowthFit const& fit) const;

 private:
  double held(double rho, double scale, bool slopes) const;

  GrowthStatistics const& statistics_;
};

}  // namespace brouwer
