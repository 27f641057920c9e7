#pragma once
#include <optional>

#include "analysis/growth/growth_statistics.hpp"

namespace brouwer {

/// The law of growth that the data support, by restricted maximum likelihood (growth_likelihood.hpp), among
///
///     walk, walk + slopes, walk + noise, walk + slopes + noise, noise, noise + slopes     (each with a drift)
///
/// Choice, each test at the level a = levels.test, with 2Δ = twice the difference of log-likelihoods against the
/// mixture ½χ²(0) + ½χ²(1), because the smaller law lies at the boundary [Self & Liang, J. Amer. Statist. Assoc. 82
/// (1987) 605]:
///
///     noise    walk + slopes + noise against walk + slopes
///     slopes   if there is noise: the same against walk + noise, and where the walk is needed as well (against noise +
///              slopes) the signs (doubling_signs_p) must agree or the spread at the end contradict walk + noise, with
///              a variance as uncertain as the kurtosis of the errors at the end makes it; without noise: the F test,
///              whose p is given. If only for normal errors the spread at the end contradicts walk + noise, slopes are
///              in the law but not seen: p_slopes stays at least a
///     walk     if there is noise: needed beside slopes if there are such, otherwise walk + noise against noise
///
/// (Slopes are never held against noise alone: of few late samples above noise a walk looks like slopes.)
///
/// Where the tails are not normal (tails.hpp), 2Δ is divided by max(1, dispersion, 1 + kurtosis/2), which is how much
/// more uncertain variances are, and √2Δ held against t(M−1) in place of the normal law. Measured (8, 16, 64, 256
/// members, 16 log-spaced times up to 10⁵): a walk raises a false alarm of noise at the level 0.05 in 4.3, 4.6, 4.5,
/// 5.6 % of ensembles, with t(5) increments in 6.1, 5.0, 3.9, 3.1 %; at 0.001 in at most 0.13 %. Beside noise, walk is
/// seen falsely in 0.1 % and slopes in 1 %: both are cautious.
///
/// Intervals: β̂ ± t(M−1)·√(v̂/M) with v̂ the members' spread about β̂, which is the closed form where there is no
/// noise; σ, τ, ν by profile likelihood: where −2 log L exceeds its minimum by less than the χ²(1) quantile, inflated
/// likewise (and by 1 + 1/(3(M−1)) for τ, the Bartlett factor of a variance of M−1 degrees of freedom). 0 belongs to
/// them as long as that holds there: at the boundary they cover more than they say. Measured coverage of the 95 %
/// intervals of β, τ, σ, ν together in one law: 94.4, 96.1, 93.1, 96.2 % for 8 members, 94.8, 96.6, 95.4, 95.4 % for
/// 256 (±0.7, ±1.0); of τ without noise 94.9 % for 8 members, and 98 % where τ = 0.
///
/// p_course: of M|r̄|²/d ~ (J−1)F(J−1, (M−1)(J−1)) against the rest of the members' spread, exact for given ρ where
/// members' increments are independent; else both degrees × ε (GrowthStatistics::sphericity; G. E. P. Box, Ann. Math.
/// Stat. 25 (1954) 484), so that a phase, whose increments have one shape, is not called bent. A mean
/// that leaves the straight line further than independent members' means do is shared by them. p_end: of the variance
/// at the end over what the law says it is, χ²(M−1)/(M−1), two-sided. A law that either contradicts is not used.
///
/// @param slopes_p  of F, for the choice without noise
/// @param course    free: of members about their mean (without_mean); what is said of β and the course is then empty
/// @return nothing where there is no choice: M < 2, J < 3, members that do not differ, a rest that is zero
/// Cost: MJ²/2 multiplications and about 5000 J²: docs/statistics.md has the time of 10⁵ members at 200 times.
std::optional<FullModel> growth_model(Ensemble const& ensemble, Units const& units, Levels const& levels,
                                      Tails const& tails, double slopes_p, MeanCourse course = MeanCourse::straight);

}  // namespace brouwer
