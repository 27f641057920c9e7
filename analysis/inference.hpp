#pragma once
#include <brouwer/store/results.hpp>

#include "analysis/estimates.hpp"

namespace brouwer {

/// The law of growth of one quantity of one cell, in closed form, with a verdict.
///
/// Model: eᵢ(t) = (β + bᵢ) t + σ Wᵢ(t), bᵢ ~ N(0, τ²), W a Brownian motion, for M members at t₁ < … < t_J; eᵢ(0) = 0.
/// With the increments Δᵢⱼ over δⱼ = tⱼ − tⱼ₋₁ and the slopes sᵢ = eᵢ(t_J)/t_J, exactly under the model:
///
///     σ̂² = Σᵢⱼ (Δᵢⱼ − δⱼsᵢ)²/δⱼ / (M(J−1))     σ̂²·M(J−1)/σ² ~ χ²(M(J−1)): the interval of σ
///     β̂  = mean sᵢ                              t = β̂ √M / sd(sᵢ) ~ t(M−1) for β = 0: test and interval of β
///     F  = t_J var(sᵢ)/σ̂²                       F(M−1, M(J−1)) for τ = 0
///     τ̂² = max(0, var(sᵢ) − σ̂²/t_J)
///
/// Smallest visible drift: sd(sᵢ)/√M · (t_{a/2}(M−1) + t_{b}(M−1)), the upper quantiles of Student's t with a =
/// levels.test, 1 − b = levels.power. Normal quantiles would promise too much to small ensembles: at M = 16, a = 0.001
/// the chance of seeing that drift would be 0.68 instead of 0.9. It uses the total spread of the slopes, so
/// it holds with persistent slopes, too.
///
/// What is not defined is NaN: with one member the spread of slopes, t, F and their intervals; with one sample time σ,
/// F and the growth exponent; with all slopes equal and zero, t. With all slopes equal and not zero, t is infinite.
/// Independent of units: all errors are multiplied by a power of two first (exact), so that no square over- or
/// underflows.
///
/// @param ensemble  errors: members × times; times increasing and > 0; per_step of the result is per unit of `times`
/// @throws InputError if there is no member or no sample time
Estimates estimate(Ensemble const& ensemble, Levels const& levels);

}  // namespace brouwer
