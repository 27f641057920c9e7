#pragma once
#include "analysis/growth/growth_likelihood.hpp"

namespace brouwer {

/// In scaled units; [0, 0] of a part that the law does not have.
struct ProfileIntervals {
  Interval sigma, tau, nu;
};

/// Where the deviance, minimised over everything else, exceeds its minimum by less than the χ²(1) quantile × inflation.
/// τ's is said also where τ is not in the law: the largest slopes that the data allow.
/// @param inflation  ≥ 1: how much more uncertain scales are than normal increments make them
ProfileIntervals profile_intervals(GrowthLikelihood const& likelihood, GrowthFit const& fit, LawTerms const& terms,
                                   double confidence, double inflation);

}  // namespace brouwer
