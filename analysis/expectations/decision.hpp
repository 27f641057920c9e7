#pragma once
#include <vector>

#include "analysis/estimates.hpp"

namespace brouwer {

// The error rates of the decision between a walk and a drift, by the t test of an ensemble's M slopes.
// A walk is called a drift with the chance levels.test, whatever its σ, τ and M are: this is what the level means.

/// Standard error of β̂; NaN where it is not known (one member).
double standard_error(Estimates const& e);

/// With which chance a drift of this size is called one; 1 − it is the chance of missing it. levels.test for 0.
/// P(|T| > t_{a/2}), T of Student's noncentral law of M − 1 degrees of freedom and noncentrality drift/standard error
/// [N. L. Johnson, S. Kotz, N. Balakrishnan, Continuous Univariate Distributions 2 (1995), ch. 31]. Exact under the
/// model for this standard error; the ensemble's own estimate of it is known as well as M allows.
double chance_to_see(double drift, Estimates const& e);

/// The drift that is seen with this chance by visible_noncentrality: the chance is off by at most 0.006 from 16 members
/// on, 0.03 for 4 (0.5 to 0.99 at 0.001). For levels.power the estimate's own smallest_visible_drift.
double drift_seen_with(double chance, Estimates const& e);

/// chance_to_see over multiples of the smallest visible drift, from 0 to twice it; empty where there is none.
struct PowerCurve {
  std::vector<double> drifts, chances;
};
PowerCurve power_curve(Estimates const& e);

/// Is |β| < δ? Two one-sided t tests, of β ≤ −δ and of β ≥ δ, each at the level a, must both reject [D. J. Schuirmann,
/// J. Pharmacokin. Biopharm. 15 (1987) 657]: so that |β| < δ is said with a chance of at most a where it is wrong, and
/// of a itself at |β| = δ where the ensemble can tell δ from −δ. It is the same as: the interval of confidence 1 − 2a
/// lies inside (−δ, δ).
struct Equivalence {
  double t_above = 0, t_below = 0;  ///< (β̂ + δ)/s and (δ − β̂)/s
  double p = 1;                     ///< the larger of the two
  Interval interval;                ///< of confidence 1 − 2a
  double provable = 0;              ///< the smallest δ of which |β| < δ is proven here: |β̂| + t_a s
};
Equivalence equivalence(Estimates const& e, double bound, double level);

/// Equivalence::provable at levels.test.
double smallest_provable_drift(Estimates const& e);

}  // namespace brouwer
