#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <brouwer/store/record.hpp>
#include <brouwer/store/results.hpp>

namespace brouwer {

/// What became of one member: the step at which it had no next state, or −1, and why.
struct Fate {
  std::int64_t failed_at = -1;
  std::string reason;
};

/// Of a unit's first members; all came through as far as is recorded where nothing is.
std::vector<Fate> fates_of(UnitRecord const& header, std::int64_t members);

/// Cuts off the members that failed, and those of which an error is not finite; the others keep their order.
/// @param errors  members × samples
/// @param fates   of the same members
/// @param names   of the same members, of which those that are cut off are cut off as well
/// @return who was cut off, by reason, those of most members first; "" is the reason of those of whom none is recorded
std::vector<Failures> drop_failed(ErrorMatrix& errors, std::span<Fate const> fates, std::vector<std::string>& names);

}  // namespace brouwer
