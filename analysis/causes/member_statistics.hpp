#pragma once
#include <Eigen/Core>
#include <brouwer/store/results.hpp>

#include "analysis/estimates.hpp"

namespace brouwer {

/// Of each member what two cells are compared by, so that members which had the same start in both can be paired. In
/// units of `scale`, a power of two that brings errors near 1.
struct MemberStatistics {
  Eigen::ArrayXd slope;        ///< sᵢ = Σⱼ wⱼ eᵢ(tⱼ)
  Eigen::ArrayXd disturbance;  ///< what walk and noise contribute to the variance of sᵢ: it is τ² + their mean
  Eigen::ArrayXd walk;  ///< σ̂ᵢ² of the increments of eᵢ − ē about their line, unbiased; NaN for one sample time
  Eigen::ArrayXd square;  ///< eᵢ(t_J)²

  Eigen::Index members() const { return slope.size(); }
};

/// w of sᵢ = Σⱼ wⱼ eᵢ(tⱼ), Σⱼ wⱼtⱼ = 1: generalised least squares under the law of this estimate, σ²min(tⱼ, tₖ) + ν²δⱼₖ.
/// Without noise it is the slope to the end, w = (0, …, 0, 1/t_J).
Eigen::VectorXd slope_weights(Estimates const& estimates);

/// Of all members of an ensemble.
/// @param weights   of the nominal cell, the same for all: what they weigh is a slope under any law
/// @param estimates of this ensemble: its ν, where noise is in force
MemberStatistics member_statistics(Ensemble const& ensemble, Eigen::VectorXd const& weights, Estimates const& estimates,
                                   double scale);

/// Of some of them, in this order.
MemberStatistics of_members(MemberStatistics const& all, std::vector<Eigen::Index> const& rows);

}  // namespace brouwer
