#pragma once
#include <string>

#include "analysis/estimates.hpp"

namespace brouwer {

/// "2 because the iteration did not converge (the first at step 1200), 1 because of a collision (at step 17)"; "" where
/// no reason is recorded.
std::string reasons(Estimates const& e);

/// ": " and the reasons; of a single one without its number, " because the iteration did not converge (the first at step
/// 1200)"; "" where no reason is recorded.
std::string and_why(Estimates const& e);

/// "3 of 64 members are left out" and why; where no reason is recorded, "3 of 64 members" and what `unrecorded` says of
/// them; "" where every member came through.
std::string left_out(Estimates const& e, std::string const& unrecorded = " failed and are left out");

}  // namespace brouwer
