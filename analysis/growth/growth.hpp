#pragma once
#include <brouwer/store/results.hpp>

#include "analysis/estimates.hpp"

namespace brouwer {

/// q in RMS ∝ t^q: slope of ordinary least squares of log RMS against log t over the sample times, with an interval
/// by bootstrap over members (see power_law.hpp for its construction and measured coverage).
/// Sample times at which every member's error is zero are left out; with fewer than two others the exponent, and with
/// one member the interval, is NaN. Independent of units: errors from 1e-300 to 1e300 give the same exponent.
Growth growth_of(Ensemble const& ensemble, double confidence);

}  // namespace brouwer
