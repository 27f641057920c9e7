#pragma once
#include "analysis/causes/explanation.hpp"

namespace brouwer {

/// Fills subject, cause and sentence of an explanation from its compared cells.
///
/// The subject is the drift where one is seen, else the persistent slopes, else the size of the error where that is the
/// method's own. Of it each cell has more than half, or less (remainder.hpp); the intervals that prove it hold for all cells of
/// one explanation together, so at most so many of them name a cause falsely. The first line that applies:
///
///     truncation              there in higher precision
///     rounding mode           nominal rounding is directed, and it is gone with nearest
///     constants or rounding   gone with exact constants, and gone with stochastic rounding: it takes both
///     constants               gone with exact constants, there with stochastic rounding
///     repeated rounding       there with exact constants, gone with stochastic rounding
///     needs constants         gone with exact constants; with stochastic rounding not resolved, or not asked
///     needs rounding          the other way round
///     constants and rounding  there with either, gone with both: each makes one of its own
///     coefficients, functions, summation, contraction     gone with another level of that factor alone
///     unnamed                 there with either and with both, gone in higher precision
///     round-off               gone in higher precision
///     not resolved            otherwise
///
/// Cells of higher precision may have the standard operations and our own functions: of those it has no others.
void name_cause(Explanation& explanation);

/// β/β₀, τ²/τ₀² or the ratio of sizes, as the subject has it.
Share const& left_of(ComparedCell const& cell, Subject subject);

}  // namespace brouwer
