#pragma once
#include <cstddef>
#include <cstdint>
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

/// Came through, were set aside or failed.
std::int64_t members_run(Estimates const& e);

/// "100 members", or "39 of 100 members" where some were left out.
std::string members_in_words(Estimates const& e);

/// As many members were run, and as many of them are left out.
bool same_members(Estimates const& a, Estimates const& b);

/// "unfinished: 900 of 4200 members in 14 cells"; "" where all are finished.
/// @param finished  in all cells together
/// @param planned   in each cell
std::string unfinished_in_words(std::int64_t finished, std::int64_t planned, std::size_t cells);

}  // namespace brouwer
