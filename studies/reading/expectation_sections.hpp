#pragma once
#include <vector>

#include "analysis/expectation.hpp"
#include "studies/reading/section.hpp"

namespace brouwer {

struct Study;
class Catalogue;

/// Reads every [[expect]]. Complains also of those that could never be judged: of a quantity that is not observed,
/// of levels that the study does not run, and those that claim nothing.
/// @param cells  what the study runs
std::vector<Expectation> read_expectations(toml::table const& file, Reading& reading, Catalogue const& catalogue,
                                           Study const& study, std::vector<CellLabels> const& cells);

}  // namespace brouwer
