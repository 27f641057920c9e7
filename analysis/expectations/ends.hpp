#pragma once
#include <brouwer/store/record.hpp>
#include <vector>

namespace brouwer {

/// Where one member began and where it ended, as doubles.
struct MemberEnds {
  std::vector<double> parameters;    ///< that are no part of the state: inertia, masses
  std::vector<double> start, final;  ///< components of the state, in the same order
  std::vector<double> masses;        ///< of the bodies, where the state is their places and velocities; else empty

  /// The largest change of a component, and the largest component.
  double distance() const;
  double size() const;

  /// How far Σ mᵢqᵢ / Σ mᵢ has moved, over the largest distance of a body from it at the start; 0 without masses.
  double barycentre_shift() const;

  /// All that tells one member from another.
  std::vector<double> both() const;
};

/// Those members of a unit that came through; it must have been read with its ends.
std::vector<MemberEnds> members_of(UnitRecord const& unit);

template <class F>
void for_members(std::vector<UnitRecord> const& units, F of) {
  for (auto const& unit : units)
    for (auto const& member : members_of(unit)) of(member);
}

}  // namespace brouwer
