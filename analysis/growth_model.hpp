#pragma once
#include <optional>

#include "analysis/tails.hpp"

namespace brouwer {

/// The law of growth that the data support, by restricted maximum likelihood (growth_likelihood.hpp), among
///
///     walk, walk + slopes, walk + noise, walk + slopes + noise, noise, noise + slopes     (each with a drift)
///
/// Choice, each test at the level a = levels.test, with 2Δ = twice the difference of log-likelihoods against the mixture
/// ½χ²(0) + ½χ²(1), because the smaller law lies at the boundary [Self & Liang, J. Amer. Statist. Assoc. 82 (1987) 605]:
///
///     noise    walk + slopes + noise against walk + slopes
///     walk     if there is noise: the same against noise + slopes
///     slopes   if there is noise: the chosen one against itself without, and beside a walk its signs (doubling_signs_p) must
///              agree; without noise: the F test, whose p is given
///
/// Where the tails are not normal (tails.hpp), 2Δ is divided by max(1, dispersion, 1 + kurtosis/2), which is how much more
/// uncertain variances are, and √2Δ held against t(M−1) in place of the normal law. False alarms of noise, measured for
/// M = 8, 16, 64, 256 members at 16 times, at the level 0.05 and 0.001: NOISE_TABLE
///
/// Intervals: β̂ ± t(M−1)·√(v̂/M) with v̂ the members' spread about β̂, which is the closed form where there is no noise; σ,
/// τ, ν by profile likelihood: where −2 log L exceeds its minimum by less than the χ²(1) quantile times max(1,
/// dispersion, 1 + kurtosis/2) where the tails are not normal (and 1 + 1/(3(M−1)) for τ, the Bartlett factor of a variance of M−1 degrees of freedom). 0
/// belongs to them as long as that holds there: at the boundary they cover more than they say.
///
/// p_course: of M|r̄|²/d ~ (J−1)F(J−1, (M−1)(J−1)) against the rest of the members' spread, exact for given ρ: a mean
/// that leaves the straight line further than independent members' means do is shared by them. p_end: of the variance at
/// the end over what the law says it is, χ²(M−1)/(M−1), two-sided. A law that either contradicts is not used.
///
/// @param slopes_p  of F, for the choice without noise
/// @return nothing where there is no choice: M < 2, J < 3, members that do not differ, a rest that is zero
/// Cost: MJ²/2 multiplications and about 5000 J²; 10⁵ members at 200 times: see docs/statistics.md.
std::optional<FullModel> growth_model(Ensemble const& ensemble, Units const& units, Levels const& levels,
                                      Tails const& tails, double slopes_p);

/// P(½χ²(0) + ½χ²(1) ≥ x): of twice a log-likelihood ratio with one variance at its boundary. 1 for x ≤ 0.
double boundary_p(double twice_ratio);

}  // namespace brouwer
