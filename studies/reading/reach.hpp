#pragma once
#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/ensemble/study.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/expectations/expectation.hpp"

namespace brouwer {

/// Why a study cannot judge an expectation: it does not observe the quantity, does not run the levels, or sweeps too
/// few steps h for a step exponent. Nothing where it can.
/// @param cells  what the study runs
std::optional<std::string> out_of_reach(Expectation const& expectation, Study const& study, Catalogue const& catalogue,
                                        std::vector<CellLabels> const& cells);

}  // namespace brouwer
