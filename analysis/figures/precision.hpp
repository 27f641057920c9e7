#pragma once
#include <string>
#include <vector>

#include "analysis/figures/figure_family.hpp"

namespace brouwer {

/// What one step size gave: the error at the end and what it cost.
struct PrecisionPoint {
  double steps = 0;
  double error = 0;        ///< √(Σ RMS²) over the components: the Euclidean norm's RMS over members
  double cpu_seconds = 0;  ///< of a member; NaN where not known
};

/// Cells that differ in their step h alone, and therefore in their number of steps, by number of steps.
struct PrecisionLine {
  CellLabels cell;  ///< without step and steps
  std::vector<PrecisionPoint> points;
};

/// Error against work for the runs of one family that end at one time.
struct WorkPrecision {
  double time = 0;  ///< at which they end, in the system's unit
  std::vector<PrecisionLine> lines;

  bool has_cpu_seconds() const;
};

/// The time is the one at which most cells end; those that end within one step h of it belong to it (with `until`, h
/// decides how much is left over). Cells that end elsewhere are left out, and so is what has no error greater than 0.
/// No lines where no method ran with at least two steps, or where the family is a count.
WorkPrecision work_precision(Family const& family);

/// "dmv" of "dmv-2" and "dmv-10": methods whose names differ in their numbers alone are one series, by order or stages.
std::string series_of(std::string const& method);

}  // namespace brouwer
