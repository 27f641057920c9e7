#pragma once
#include <vector>

#include "analysis/units.hpp"

namespace brouwer {

/// Rows of members that lie far from all others, in the error at the end or in their own σᵢ² (from what is left of the
/// path without the line to its end).
///
/// Distances are in units of the median of distances from the median, and bounds are those of Student's t(5): at the
/// level 0.005 for all members together (Bonferroni) of the error at the end, and for all their increments together of
/// the largest increment that a σᵢ² may hold. So heavy tails alone are no wildness. Measured false alarms (J from 1 to
/// 32): of t(5) increments 1.3 to 2.8 % for 8 members, 0.5 to 1.3 % from 64 on; of normal ones 0.8 % for 8 members,
/// none in 6000 from 64 on. Where the median distance is 0, or of fewer than 8 members, nobody is far off.
std::vector<Eigen::Index> far_off_members(Ensemble const& ensemble, Units const& units);

/// As many of `members` are few: one, or up to 10 in 100. More are a population of their own.
bool are_few(std::size_t far_off, Eigen::Index members);

/// Of the members in these rows.
std::vector<std::string> names_of(Ensemble const& ensemble, std::vector<Eigen::Index> const& rows);

/// The ensemble without these rows, which are in ascending order.
Ensemble without(Ensemble const& ensemble, std::vector<Eigen::Index> const& rows);

}  // namespace brouwer
