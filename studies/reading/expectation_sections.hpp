#pragma once
#include <brouwer/ensemble/catalogue.hpp>
#include <vector>

#include "analysis/expectations/expectation.hpp"
#include "studies/reading/section.hpp"

namespace brouwer {

/// Reads every [[expect]]; complains of names and values that no study of this system could have, and of
/// expectations that claim nothing. Whether this study can judge them is another question (reach.hpp).
/// @param level  of those that do not say their own
std::vector<Expectation> read_expectations(Section& root, Reading& reading, Catalogue const& catalogue,
                                           std::string const& system, std::optional<double> level);

}  // namespace brouwer
