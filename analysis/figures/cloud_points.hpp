#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "analysis/estimates.hpp"
#include "analysis/figures/cloud.hpp"

namespace brouwer {

/// The members of one cell in the plane of the picture.
struct CloudPoints {
  Orbits const* of;
  std::size_t x, y;                  // components
  std::vector<std::size_t> members;  // that are drawn
  std::vector<std::string> colours;  // of these

  double px(std::size_t member, std::size_t time) const { return of->at(member, time, x); }
  double py(std::size_t member, std::size_t time) const { return of->at(member, time, y); }
  /// It has failed by then.
  bool ended(std::size_t member, std::size_t time) const {
    return std::isnan(px(member, time)) || std::isnan(py(member, time));
  }
};

/// At most so many members, evenly chosen, each with the colour of its start.
/// @throws InputError for a component that the state does not have
CloudPoints points_of(Orbits const& cell, Plane const& plane, std::size_t most);

/// The axes of one picture of all clouds: they hold every cloud, but what runs away (a cloud several times larger than
/// the tamer ones, a member several times further than half of its cloud) only as far as the others keep their room, and
/// the start of every member of a tame cloud. No side is shorter than 3/4 of the other.
struct CloudAxes {
  Interval x, y;
};
CloudAxes axes_of(std::vector<CloudPoints> const& clouds);

}  // namespace brouwer
