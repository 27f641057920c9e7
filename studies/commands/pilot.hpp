#pragma once
#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/ensemble/study.hpp>
#include <vector>

#include "analysis/estimates.hpp"

namespace brouwer {

/// What a moment's trial of one cell says of the whole.
struct Pilot {
  double seconds_per_step = 0;      ///< of one member on one thread, without its reference
  double seconds_of_reference = 0;  ///< of one member's reference, over the whole length of the cell
  std::vector<Estimates> rows;      ///< of the trial; per step, so that σ speaks of the whole
};

/// Tries at most 16 members over at most 1000 steps of a cell, for at most about half a second.
Pilot try_cell(Study const& study, Catalogue const& catalogue, CellLabels const& cell, Levels const& levels);

/// The drift per step that `members` members over `steps` steps would see, for a random walk of σ per √step:
/// σ/√(M N) times the noncentrality that the t-test sees at the given level and power. NaN for one member.
double smallest_visible_drift(double diffusion, std::int64_t members, std::int64_t steps, Levels const& levels);

}  // namespace brouwer
