#pragma once

namespace brouwer {

// Where a preprocessed method takes its modified coefficients from. Such a method integrates the same system with
// parameters that are replaced by series in h, so that its order rises (for discrete Moser–Veselov: E. Hairer,
// G. Vilmart, J. Phys. A 39 (2006) 13225). The series depend on the state through first integrals alone: in exact
// arithmetic both ways are one method, in floating point they are two with different statistics of round-off. Hence
// this is a factor of a study, like the elliptic functions that a method calls, and no optimisation.

/// Anew from the current state in every step, as the published code does: rounding errors of the coefficients differ
/// from step to step, and the coefficients follow the first integrals as these wander.
struct PerStep {};

/// Once from the start, in the stepper's constructor: a member keeps one rounding error of the coefficients.
struct PerTrajectory {};

}  // namespace brouwer
