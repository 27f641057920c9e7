#pragma once
#include <brouwer/store/results.hpp>
#include <optional>

#include "analysis/estimates.hpp"

namespace brouwer {

/// What the increments of an ensemble say of the model, by which σ̂, F and their tests are right: are they uncorrelated
/// (autocorrelation.hpp), does their variance grow with the time (variance_ratio.hpp), are they normal (normality.hpp)?
/// All of it speaks of increments freed of the members' slopes and independent under the model (free_increments.hpp),
/// so that neither a drift nor persistent slopes disturb it.
///
/// Of more than 10⁵ increments every s-th is tested for normality, the least s that has no factor in common with J − 1:
/// every sample time then has its equal share. Moments and histogram are of all.
///
/// False alarms under the model, simulated (4000 ensembles each of 4, 8, 16 and 64 members with 8, 16 and 64 samples,
/// linear and log-spaced): 4.2 to 5.8 % at the level 0.05 and 0 to 0.25 % at 0.001 for every test, as the binomial law
/// has it for 0.05 and 0.001. Coverage of the 95 % intervals of ρ and V: 92 % for 4 members, 90 to 94 % for 8, 94 to 95 %
/// for 64. Increments with heavy tails (t of 5 degrees of freedom) or skewness (exponential) do not harm the tests of
/// correlation; variance ratios are then called false in 6 to 8 % at 0.05 and 0.1 to 0.5 % at 0.001.
/// Cost: 10⁵ members × 200 samples in 0.3 s on two cores; the same bits on any number of them.
///
/// @return nothing for one sample time, and where all increments are 0: there is nothing to test
std::optional<IncrementTests> increment_tests(Ensemble const& ensemble, Levels const& levels);

}  // namespace brouwer
