#pragma once
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/estimates.hpp"

namespace brouwer {

/// Which cells an expectation speaks of; an absent key matches every level.
struct Selector {
  // "= {}" lets {.method = "dmv-2"} be written without a warning for the rest
  std::optional<std::string> method = {}, arithmetic = {}, special_functions = {}, coefficients = {};
  std::optional<std::string> rounding = {}, constants = {};
  std::optional<bool> compensation = {}, contraction = {};
  std::optional<double> step = {};
  std::optional<Interval> step_range = {};  ///< low ≤ h ≤ high
  bool matches(CellLabels const& cell) const;
};

struct Around {
  double exponent = 0, within = 0;
};

/// One [[expect]] of a study: what must be true of a quantity in the selected cells. Several parts may be given; all
/// must hold.
struct Expectation {
  std::string of;  ///< component or quantity: "spatial-momentum" speaks of its three components
  Selector where;
  enum class DriftWanted { unsaid, none, band, smaller_than };
  DriftWanted drift = DriftWanted::unsaid;
  Interval drift_band;           ///< per step; the estimate must lie inside, and be significant unless the band holds 0
  double drift_bound = 0;        ///< per step; |β| below it is to be proven
  std::optional<Around> growth;  ///< exponent of t in every selected cell
  std::optional<Around> step_exponent;  ///< p in RMS = a·hᵖ·t^q fitted over the selected cells (at least three steps h)
  std::optional<bool> persistence;      ///< true: slopes must persist; false: they must not
  std::vector<std::string> verdict;         ///< any of these words
  std::optional<double> level;              ///< of the tests; otherwise Levels::test
  int line = 0;                             ///< in the study file, for messages
  std::optional<Interval> mean;             ///< the mean over members at the last sample lies inside
  std::optional<Interval> rms_final;        ///< so does the RMS over members at the last sample
  std::optional<std::int64_t> failed = {};  ///< at most so many members have failed
};

/// The test that an outcome rests on; it can be judged again by a p that is adjusted for the tests beside it.
struct ClaimTest {
  double p = 1, level = 0;
  bool significant = true;  ///< must it be, or must it not?
  bool besides = true;      ///< what else the claim says holds
  bool holds(double deciding_p) const {
    return besides && std::isfinite(deciding_p) && (deciding_p < level) == significant;
  }
};

/// What became of one expectation in one cell (or over a sweep, for step_exponent).
struct Outcome {
  bool passed = false;
  std::string claim;  ///< "energy, elliptic-naive, double, h = 0.01: drift between −3e-17 and −1.5e-17 per step"
  std::string found;  ///< "−2.3e-17 ± 0.1e-17 (t = −167); smallest visible drift 5e-19"
  std::optional<ClaimTest> test = {};
};

}  // namespace brouwer
