#pragma once
#include <Eigen/Core>
#include <brouwer/store/results.hpp>

namespace brouwer {

/// The increments of a member's error without its slope, standardised, and independent.
///
/// The residuals Δⱼ − δⱼs of a straight line to the end, which σ̂ is made of, are those of a bridge: over √δⱼ their
/// covariance is σ²(1 − uuᵀ), uⱼ = √(δⱼ/t_J), and they correlate although the increments do not. Taking from each
/// increment the slope so far, in place of the slope to the end, leaves
///
///     wⱼ = (Δⱼ − δⱼ e(tⱼ₋₁)/tⱼ₋₁) √(tⱼ₋₁/(δⱼ tⱼ)),   j = 2 … J,
///
/// the recursive residuals of the regression on a slope [R. L. Brown, J. Durbin, J. M. Evans, J. R. Stat. Soc. B 37
/// (1975) 149]: under e(t) = (β + b)t + σW(t) independent N(0, σ²), exactly, for all β and b and all times, and
/// Σ wⱼ² = Σ (Δⱼ − δⱼs)²/δⱼ. (They are the increments of e(t)/t, which turns W upside down in time.)
///
/// What they dilute: of the increment itself wⱼ holds the share tⱼ₋₁/tⱼ in variance, of earlier ones the rest. On
/// log-spaced samples a departure from normality is therefore seen weakened.
class FreeIncrements {
 public:
  /// @param times  increasing, > 0; at least two
  explicit FreeIncrements(Eigen::ArrayXd const& times);

  Eigen::Index count() const { return weight_.size(); }  ///< J − 1

  /// w of one member's errors at the times, each times `scale`.
  template <class Row>
  Eigen::ArrayXd operator()(Row const& errors, double scale) const {
    auto const now = scale * errors.tail(count()).array().transpose();
    auto const before = scale * errors.head(count()).array().transpose();
    return weight_ * ((now - before) - relative_ * before);
  }

 private:
  Eigen::ArrayXd relative_, weight_;  // δⱼ/tⱼ₋₁ and √(tⱼ₋₁/(δⱼtⱼ))
};

}  // namespace brouwer
