#pragma once
#include "analysis/units.hpp"

namespace brouwer {

/// One-sided p of the hypothesis that there is no bounded noise beside walk, slopes and drift, that heavy tails do not
/// mislead: Rao's score of ν² at ν = 0, member by member,
///
///     gᵢ = ½(|Cᵀrᵢ|² − c|rᵢ|²)/σ̂² + (sᵢ − s̄)·uᵀBrᵢ/(t_J v̂)        c = (tr B − 1/t_J)/(J−1)
///
/// (notation of growth_statistics.hpp; rᵢ less the mean of the members), whose mean is 0 whatever the law of independent
/// increments of equal size is, against its own spread: ḡ√M/sd(g) ~ t(M−1). g is skew to the right, where t then errs
/// to the safe side. What all members share does not count.
/// @param ensemble  M ≥ 2 members that differ at J ≥ 3 times
double noise_score_p(Ensemble const& ensemble, Units const& units);

}  // namespace brouwer
