#pragma once
#include <string>
#include <vector>

#include <brouwer/ensemble/study.hpp>
#include <brouwer/scalar/operation_rule.hpp>
#include <brouwer/store/record.hpp>

namespace brouwer {

/// "nearest, up, down, toward-zero, stochastic" and "rounded, exact": the levels of the factors `rounding` and
/// `constants`, the standard first.
std::vector<std::string> const& rounding_levels();
std::vector<std::string> const& constants_levels();

/// What the levels of a cell ask of every operation of a step.
/// @throws InputError "there is no rounding 'upp'; did you mean 'up'?"
OperationRule operation_rule(CellLabels const& cell);

/// Why a cell's rule does not exist there, or "": other rules than the processor's are of float and double alone, and of
/// operations that pass through the scalar, which GSL's and Boost's functions do not.
std::string no_such_operations(CellLabels const& cell);

/// The same cell as the processor computes it.
CellLabels with_standard_operations(CellLabels cell);

/// The cells that differ from `cell` in these factors: one for each combination of their levels.
std::vector<CellLabels> crossed_operations(Study const& study, CellLabels const& cell);

}  // namespace brouwer
