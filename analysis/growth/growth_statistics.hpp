#pragma once
#include <Eigen/Core>

#include "analysis/units.hpp"

namespace brouwer {

/// What the likelihood of the law of growth needs to know of an ensemble, at one ratio ρ = ν²/σ² of noise to walk, with
/// the scale of both taken out: dⱼ = 1 + ρλⱼ below (dⱼ = λⱼ for noise alone).
struct Reduced {
  double log_determinant = 0;  ///< Σⱼ log dⱼ
  double precision = 0;        ///< a = Σⱼ wⱼ²/dⱼ: a member's slope has the variance τ² + σ²/a
  double residual = 0;  ///< R = Σᵢ |rᵢ|² in the metric 1/d: what is left when each member's own line is removed
  double spread = 0;    ///< Σᵢ (sᵢ − s̄)² of the members' slopes by weighted least squares
  double slope = 0;     ///< s̄ = β̂
  double course = 0;    ///< M |r̄|² in the metric 1/d: how far the mean of all members is from a straight line
};

/// How the mean of all members goes: by the law, or as it likes.
enum class MeanCourse { straight, free };

/// Sufficient statistics of M members at J times for the law eᵢ(t) = (β + bᵢ)t + σWᵢ(t) + νεᵢ(t), eᵢ(0) = 0.
///
/// The increments over √δⱼ have the mean β√δⱼ and the covariance σ²I + τ²uuᵀ + ν²B, uⱼ = √δⱼ, B = CCᵀ with C the
/// bidiagonal matrix Cⱼⱼ = 1/uⱼ, Cⱼ,ⱼ₋₁ = −1/uⱼ. With B = QΛQᵀ, computed once, everything but the slopes is diagonal in
/// the coordinates Qᵀ, where u becomes w. Of each member the line to its end is removed first (sᵢ = eᵢ(t_J)/t_J), so
/// neither a large drift nor large slopes cost digits; kept are the sums over members of the rest r: r, rrᵀ, sr.
///
/// Cost: MJ²/2 multiplications once, J² for each ρ. More than `most_times` samples are thinned, evenly in their order
/// and with the last kept: the law holds at any choice of times, only information on ν is lost.
/// @throws nothing; J ≥ 2 and M ≥ 2 are the caller's care
class GrowthStatistics {
 public:
  static constexpr Eigen::Index most_times = 256;

  /// @param course  free: the mean of all members may take any way, which costs the rests of one member; members are
  ///                about it already (without_mean)
  GrowthStatistics(Ensemble const& ensemble, Units const& units, MeanCourse course = MeanCourse::straight);

  double members() const { return members_; }
  double rests() const { return rests_; }  ///< independent ones: M, or M − 1 about a free course
  double times() const { return static_cast<double>(eigenvalues_.size()); }
  double smallest_eigenvalue() const { return eigenvalues_[0]; }
  double largest_eigenvalue() const { return eigenvalues_[eigenvalues_.size() - 1]; }
  double duration() const { return duration_; }
  double slope_spread() const { return slope_spread_; }  ///< of the lines to the ends, about their mean

  /// @param rho  ν²/σ² in scaled units, 0 … ∞; ∞ is noise alone
  Reduced at(double rho) const;

  /// ε = (tr Σ)²/((J−1) tr Σ²), Σ the covariance of what is left of a member beside its slope, in the metric 1/d: 1 where it
  /// is as the law says, 1/(J−1) where it is one shape. Of the sample's traces the bias is taken out, exactly for normal
  /// errors [B. Lecoutre, J. Educ. Stat. 16 (1991) 371]; at most 1, and 1/(J−1) for two members, which
  /// tell nothing of it.
  double sphericity(double rho) const;

 private:
  Eigen::ArrayXd metric(double rho) const;

  double members_ = 0, rests_ = 0, duration_ = 0, mean_slope_ = 0, slope_spread_ = 0;
  Eigen::ArrayXd eigenvalues_, w_;             // Λ, Qᵀu
  Eigen::VectorXd mean_rest_, slope_by_rest_;  // r̄, Σ (sᵢ − s̄) rᵢ
  Eigen::MatrixXd scatter_;                    // Σ (rᵢ − r̄)(rᵢ − r̄)ᵀ
};

}  // namespace brouwer
