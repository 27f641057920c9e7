#pragma once
#include <brouwer/ensemble/run.hpp>
#include <vector>

#include "analysis/estimates.hpp"

namespace brouwer {

/// Estimates from a moment's trial of one cell, per step, so that σ speaks of the whole: at most 64 members over at most
/// 1000 steps, for about a tenth of a second.
std::vector<Estimates> try_cell(Study const& study, Catalogue const& catalogue, CellLabels const& cell,
                                RunOptions const& options, Levels const& levels);

/// The drift per step that `members` members over `steps` steps would see, for a random walk of σ per √step:
/// σ/√(M N) times the noncentrality that the t-test sees at the given level and power. NaN for one member.
double smallest_visible_drift(double diffusion, std::int64_t members, std::int64_t steps, Levels const& levels);

/// The member-steps M·N with which M members would see a drift per step: (σ × that noncentrality / drift)².
double member_steps_to_see(double drift, double diffusion, std::int64_t members, Levels const& levels);

}  // namespace brouwer
