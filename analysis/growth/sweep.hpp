#pragma once
#include <brouwer/store/results.hpp>
#include <cstddef>
#include <vector>

#include "analysis/estimates.hpp"

namespace brouwer {

/// RMS = amplitude · hᵖ · t^q over cells that differ in their step h alone; t = steps · h, the system's time.
/// Round-off without compensation: p = −½, q = ½; in increment form with compensation: p = q = ½ (inference.hpp).
struct SweepLaw {
  double step_exponent = 0;  ///< p
  Interval step_interval;
  double time_exponent = 0;  ///< q
  Interval time_interval;
  double amplitude = 0;  ///< a, in the unit of the errors
  std::size_t cells = 0;
};

/// Ordinary least squares of log RMS on log h and log t over all cells and sample times; sample times of a cell at
/// which every error is zero are left out. Members share their starts across the cells, so the cells are not
/// independent: the same members are resampled in all cells together (see power_law.hpp for the intervals). Rows of the
/// matrices are taken as the same members; where cells have different numbers of members, the first that all cells have
/// are used. A single power law is assumed: where a law changes along t (a walk turning into a drift), the intervals do
/// not say so.
/// @throws InputError with fewer than three distinct steps, cells that differ in something else, fewer than two
/// members,
///         or non-zero errors at too few places to determine p and q
SweepLaw fit_sweep(std::vector<Ensemble> const& cells, Levels const& levels);

}  // namespace brouwer
