#pragma once
#include <brouwer/store/results.hpp>

#include "analysis/estimates.hpp"

namespace brouwer {

/// The law of growth of one quantity of one cell, with a verdict.
///
/// Model: eᵢ(t) = (β + bᵢ) t + σ Wᵢ(t), bᵢ ~ N(0, τ²), W a Brownian motion, for M members at t₁ < … < t_J; eᵢ(0) = 0.
/// With the increments Δᵢⱼ over δⱼ = tⱼ − tⱼ₋₁ and the slopes sᵢ = eᵢ(t_J)/t_J, exactly under the model:
///
///     σ̂² = Σᵢⱼ (Δᵢⱼ − δⱼsᵢ)²/δⱼ / (M(J−1))     σ̂²·M(J−1)/σ² ~ χ²(M(J−1)): the interval of σ
///     β̂  = mean sᵢ                              t = β̂ √M / sd(sᵢ) ~ t(M−1) for β = 0: test and interval of β
///     F  = t_J var(sᵢ)/σ̂²                       F(M−1, M(J−1)) for τ = 0
///     τ̂² = max(0, var(sᵢ) − σ̂²/t_J)
///
/// Smallest visible drift: sd(sᵢ)/√M · δ, with δ the noncentrality at which the t test of M−1 degrees of freedom sees a
/// drift at the level a = levels.test with the chance levels.power = 1 − b [Abramowitz & Stegun 26.7.10]:
///
///     δ = t_{a/2} (1 − 1/(4(M−1))) + z_b √(1 + t²_{a/2}/(2(M−1)))            → z_{a/2} + z_b for large M
///
/// Chance with which that drift is seen, by the exact noncentral t: 0.898 to 0.902 for all M ≥ 2 and a from 0.001 to
/// 0.05. z_{a/2} + z_b in its place would promise too much to small ensembles: 0.36 at M = 8, 0.68 at 16, 0.86 at 64.
/// It uses the total spread of the slopes, so it holds with persistent slopes, too.
///
/// Beside the closed form, each with its own rules and measured error rates:
///
///     growth_model.hpp  noise ν that does not grow: where the data ask for it and agree with it (noise_in_force in
///                       verdict.hpp), β, τ, σ and their intervals are of restricted maximum likelihood; otherwise the
///                       closed form stands bit for bit. τ's interval is always by likelihood
///     tails.hpp         increments that are not normal: σ's interval and p of F
///     transient.hpp     a mean that begins otherwise than it goes on: β is of what follows
///     shared_course.hpp a mean that is no straight line (p_course below levels.test): β's error allows for what all
///                       members share. σ, τ, ν are then of the members about their mean, with M − 1 rests in place of M
///     far_off.hpp       a few members far from all others: set aside and named, the estimates are of the rest
///
/// What is not defined is NaN: with one member the spread of slopes, t, F and their intervals; with one sample time σ,
/// F and the growth exponent; with all slopes equal and zero, t. With all slopes equal and not zero, t is infinite.
/// Independent of units: all errors are multiplied by a power of two first (exact), so that no square over- or
/// underflows.
///
/// What the increments say of these assumptions stands beside it (increments.hpp).
///
/// Of a count (ensemble.count) the mean and the range are told and no law is estimated: what belongs to it is NaN.
/// Where every member failed, all numbers are NaN, the verdict is `not resolved` and the sentence says why they failed.
///
/// @param ensemble  errors: members × times; times increasing and > 0; per_step of the result is per unit of `times`
/// @throws InputError if there is no member or no sample time
Estimates estimate(Ensemble const& ensemble, Levels const& levels);

/// The noncentrality at which |t| exceeds its critical value with the chance `power`: Student's noncentral t in the
/// normal approximation [Abramowitz & Stegun 26.7.10], solved for it; the δ above, of M−1 = `dof`.
double visible_noncentrality(double dof, Levels const& levels);

}  // namespace brouwer
