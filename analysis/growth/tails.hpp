#pragma once
#include "analysis/units.hpp"

namespace brouwer {

/// What holds of σ and F whatever the law of the increments is, from the members themselves.
struct TailInference {
  Tails tails;
  double log_error = 0;  ///< standard error of log σ̂
  double p_signs = 1;    ///< of no positive correlation between increments: no persistent slopes
};

/// χ² intervals of σ and the F test take the increments for normal. t(5)-distributed ones, or members of which each has
/// its own σᵢ, make σ̂² several times as uncertain. Both show in the ensemble, as excess kurtosis of the increments
/// over √δ (time by time, and of all together), or as spread of the members' own σᵢ² (`dispersion`): where either is
/// larger than normal increments explain at the level 0.05, each, and M ≥ 4,
///
///     log σ̂² ± t(M−1) s          s² = max(var(σᵢ²)/(Mσ̂⁴), 2(1 + kurtosis/2)/(M(J−1))), the larger kurtosis
///     Σᵢ (Σⱼ uⱼxᵢⱼ)² − Σⱼ δⱼxᵢⱼ²      beside F: 0 in the mean for independent increments xᵢⱼ over √δⱼ
///                                 (less their means over members)
///
/// the latter against its law when the sign of every xᵢⱼ is thrown anew, exact in the first three moments, with
/// Pearson's type III law through them; p of persistent slopes is then the larger one of F's and of this: F takes heavy
/// tails for slopes, the other does not, but it also answers where late increments are smaller than early ones.
/// Otherwise the closed form stands.
///
/// Measured with log-spaced times up to 10⁵: coverage of σ's 95 % interval, false alarms of F at the level 0.05, in %:
///
///     M                                   8     16     64    256
///     σ covered, normal                94.9   94.8   94.8   95.0
///     σ covered, t(5)                  90.1   92.8   95.0   94.9
///     σ covered, σᵢ = σ·e^(0.4 N)      83.5   89.7   91.9   93.6
///     F raised, normal                  5.0    5.1    4.7    4.0
///     F raised, t(5)                    3.9    2.4    2.3    2.1
///     F raised, σᵢ = σ·e^(0.4 N)        4.2    3.5    3.4    3.1
///
/// (16 times, 4000 ensembles, ±0.4, of 8 and 16 members, 1500, ±0.6, of 64 and 256; the χ² interval covers σ in 72 to
/// 80 % under t(5).) What is left of few members is that their spread does not tell of tails that they have not yet
/// shown.
TailInference tails_of(Ensemble const& ensemble, Units const& units);

/// p_signs at the times t_J, about t_J/2, t_J/4 … alone: bounded noise makes neighbouring increments differ in sign,
/// and hides slopes the more the more increments there are.
double doubling_signs_p(Ensemble const& ensemble, Units const& units);

}  // namespace brouwer
