#pragma once
#include "analysis/explanation.hpp"

namespace brouwer {

/// Fills subject, cause and sentence of an explanation from its compared cells.
///
/// The subject is the drift where one is seen, else the persistent slopes, else the size of the error where that is the
/// method's own. Of it each cell has more than half, or less (fate.hpp), all of them at once at the confidence of the
/// explanation: a cause is named falsely in at most so many studies. The first line that applies:
///
///     truncation              there in higher precision
///     rounding mode           nominal rounding is directed, and it is gone with nearest
///     constants               gone with exact constants; there, or not known, with stochastic rounding
///     repeated rounding       gone with stochastic rounding; there, or not known, with exact constants
///     constants or rounding   gone with either: both are needed to make it
///     constants and rounding  there with either, gone with both: each makes one of its own
///     coefficients, functions, summation, contraction     gone with another level of that factor alone
///     unnamed                 there in every cell
///     not resolved            otherwise
void name_cause(Explanation& explanation);

/// β/β₀, τ²/τ₀² or the ratio of sizes, as the subject has it.
Share const& left_of(ComparedCell const& cell, Subject subject);

}  // namespace brouwer
