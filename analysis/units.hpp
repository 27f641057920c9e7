#pragma once
#include <brouwer/store/results.hpp>
#include <cmath>

#include "analysis/estimates.hpp"
#include "analysis/power_law.hpp"

namespace brouwer {

/// Powers of two that bring errors and times near 1, and the results back. Time's is a power of four: σ is per √time.
/// No square of what is multiplied over- or underflows, and results are the same bits in any unit of that kind.
struct Units {
  double error = 1, time = 1;  ///< what errors and times are multiplied by

  double size(double scaled) const { return scaled / error; }
  double rate(double scaled) const { return scaled * time / error; }
  double sqrt_rate(double scaled) const { return scaled * std::sqrt(time) / error; }
  Interval size(Interval i) const { return {size(i.low), size(i.high)}; }
  Interval rate(Interval i) const { return {rate(i.low), rate(i.high)}; }
  Drift rate(Drift d) const { return {rate(d.per_step), rate(d.interval), d.t, d.p, d.share}; }
  Interval sqrt_rate(Interval i) const { return {sqrt_rate(i.low), sqrt_rate(i.high)}; }
};

inline Units units_of(Ensemble const& ensemble) {
  int const half = std::ilogb(ensemble.times.back()) / 2;
  return {exact_scale(largest_magnitude(ensemble.errors)), std::ldexp(1, -2 * half)};
}

inline Eigen::ArrayXd scaled_times(Ensemble const& ensemble, Units const& units) {
  return units.time * Eigen::Map<Eigen::ArrayXd const>(ensemble.times.data(), std::ssize(ensemble.times));
}

}  // namespace brouwer
