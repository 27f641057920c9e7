#pragma once
#include <brouwer/store/record.hpp>
#include <span>
#include <string>
#include <vector>

#include "analysis/estimates.hpp"

namespace brouwer {

/// A factor of a study, as people read it. Levels that say nothing (no system, no special functions) are "".
struct Factor {
  char const* name;                            ///< "special functions": a column's head
  std::string (*level)(CellLabels const&);     ///< "gsl"
  std::string (*in_words)(CellLabels const&);  ///< "gsl functions": part of a sentence
};

using Factors = std::vector<Factor const*>;

/// system, method, arithmetic, special functions, coefficients, compensation, rounding, constants, contraction, step, steps.
std::span<Factor const> all_factors();

/// The cell of each row.
std::vector<CellLabels> cells_of(std::vector<Estimates> const& rows);

/// The factors that take more than one level in these cells. `steps` is left out where h decides it.
Factors varying_factors(std::vector<CellLabels> const& cells);

/// Those that take one level everywhere, if that level says something.
Factors constant_factors(std::vector<CellLabels> const& cells);

/// "elliptic-naive, double, h = 0.01": the levels of these factors, in words.
std::string describe(CellLabels const& cell, Factors const& factors);

/// All that there is to say of a cell; "ensemble" where nothing is known (an ensemble from a csv).
std::string describe(CellLabels const& cell);

/// Where a claim was made, in few words: without system and steps, and without what is usual (own functions,
/// coefficients per step, plain sum).
std::string brief(CellLabels const& cell, bool with_step = true);

/// What tells the cells apart; where there is one only, what it is.
std::string short_label(CellLabels const& cell, Factors const& varying);

}  // namespace brouwer
