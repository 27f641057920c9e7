#pragma once
#include "analysis/causes/explanation.hpp"
#include "analysis/causes/member_statistics.hpp"

namespace brouwer {

/// All main effects and interactions of a 2ᵏ factorial, main effects first [G. E. P. Box, W. G. Hunter & J. S. Hunter,
/// Statistics for Experimenters (1978), 10].
///
///     β     Student's t of each member's own contrast of slopes: exact, whatever cells have in common
///     τ²    the mean of the members' contrasts of slope_variances (cell_shares.hpp) with its standard error; of the
///           nominal τ²
///     σ     contrast of ln σ̂; its error from the members' influences σ̂ᵢ²/σ̂² − 1
///
/// p are those of each of the three questions over all effects, after Holm's correction; intervals are single ones.
/// @param cells  at place Σ bⱼ2ʲ the cell in which factor j is changed if bⱼ = 1; 2ᵏ of them, with the same members
/// @param names  of the k changes, in words
std::vector<FactorialEffect> factorial_effects(std::vector<MemberStatistics> const& cells,
                                               std::vector<std::string> const& names, double confidence);

}  // namespace brouwer
