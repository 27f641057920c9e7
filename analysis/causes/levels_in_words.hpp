#pragma once
#include <string>
#include <vector>

#include <brouwer/store/record.hpp>

namespace brouwer {

/// Names of the factors (factors.hpp) of the arithmetic in which two cells differ: "arithmetic", "rounding" …
std::vector<std::string> changed_factors(CellLabels const& from, CellLabels const& to);

/// The level of such a factor with its noun, also where it is the usual one: "exact constants", "rounding to nearest",
/// "a plain sum", "double-double".
std::string level_in_words(std::string const& factor, CellLabels const& cell);

/// All levels that have changed: "exact constants and stochastic rounding".
std::string changes_in_words(std::vector<std::string> const& changed, CellLabels const& cell);

/// "a", "a and b", "a, b and c".
std::string enumerated(std::vector<std::string> const& words);

}  // namespace brouwer
