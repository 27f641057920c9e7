#pragma once
#include <array>

#include "analysis/growth/growth_likelihood.hpp"

namespace brouwer {

/// The laws among which is chosen, each with a drift; Fits in the same order.
constexpr std::array<LawTerms, 6> growth_laws = {{{true, false, false},
                                                  {true, true, false},
                                                  {true, false, true},
                                                  {true, true, true},
                                                  {false, false, true},
                                                  {false, true, true}}};
using GrowthFits = std::array<GrowthFit, growth_laws.size()>;

std::size_t place_of(LawTerms const& terms);

/// What twice a log-likelihood ratio is measured by.
struct Yardstick {
  double inflation = 1;  ///< how much more uncertain variances are than those of normal increments
  double dof = 0;        ///< of the inflation, where it is estimated; 0: normal increments

  double p(double twice_ratio) const;
};

Yardstick yardstick(Tails const& tails, double members);

/// What the choice goes by beside the likelihoods, which a few wild increments raise as well.
struct ChoiceGrounds {
  Levels levels;
  Yardstick yardstick;
  double p_signs = 1;        ///< of slopes, from the signs of increments at doubling times
  double end_inflation = 1;  ///< how much more uncertain the spread at the end is than that of normal errors
};

ChoiceGrounds grounds_of(Ensemble const& ensemble, Units const& units, Levels const& levels, Tails const& tails);

/// The terms of the law, and whether slopes that it has not are seen at 1 − confidence, though not at the level.
struct LawChoice {
  LawTerms terms;
  bool slopes_open = false;
};

/// Sets model.p_noise, p_walk and p_slopes, which at first is that of F: it decides where there is no noise.
LawChoice choose_law(GrowthFits const& fits, GrowthStatistics const& statistics, ChoiceGrounds const& grounds,
                     FullModel& model);

/// Of the variance of the errors at the end, T²Σ(sᵢ⁰ − s̄⁰)²/(M−1), against what the law says.
/// @param inflation  of the variance of that variance over the one of normal errors
double end_p(GrowthStatistics const& statistics, GrowthFit const& fit, double inflation = 1);

/// P(½χ²(0) + ½χ²(1) ≥ x): of twice a log-likelihood ratio with one variance at its boundary. 1 for x ≤ 0.
double boundary_p(double twice_ratio);

}  // namespace brouwer
