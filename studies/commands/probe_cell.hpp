#pragma once
#include <brouwer/ensemble/probe.hpp>

#include "analysis/estimates.hpp"

namespace brouwer {

/// A probe whose windows are made four times as long while σ still changes with their length, as long as they fit into the
/// steps covered and the method conserves the first integrals, so that a longer window costs little.
Probe probe_cell(Study const& study, Catalogue const& catalogue, CellLabels const& cell, ProbeDesign design,
                 RunOptions const& options, Levels const& levels);

}  // namespace brouwer
