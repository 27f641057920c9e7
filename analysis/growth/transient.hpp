#pragma once
#include <optional>

#include "analysis/units.hpp"

namespace brouwer {

/// Where the mean of the members does not begin as it goes on.
///
/// For every sample t_k up to half the time, dᵢ = eᵢ(t_k)/t_k − (eᵢ(t_J) − eᵢ(t_k))/(t_J − t_k), the slope before less
/// the slope after: its mean over members is 0 under every law of growth of the model, with a variance that the members
/// themselves tell, so that d̄√M/sd(d) ~ t(M−1) for normal errors, whatever τ, σ and ν are. A p below a/K in one of the
/// K places (Bonferroni) is a mean that is not straight. The first sample from which on the same scan of what is left
/// finds nothing at 0.01 ends the transient (bisection). There is no transient but another law, or an oscillation, and
/// nothing is returned, if none does in the first quarter of the time and with three samples before the last to come; or
/// if the mean swings: on its way to the line that it follows from there on, it leaves the ground between that line and
/// the parallel through 0, at some sample at the level a. False alarms at a = 0.05, measured with 4 to 256
/// members at 16 times: 3.3 to 4.4 % of random walks, 2.6 to 3.8 % with t(5) increments, as the places depend on one
/// another.
std::optional<Transient> transient_of(Ensemble const& ensemble, Units const& units, Levels const& levels);

}  // namespace brouwer
