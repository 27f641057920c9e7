#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <brouwer/store/record.hpp>

namespace brouwer {

struct FinishedUnit;  // results.hpp

/// Where the members of one cell were, at the start and at the samples: for pictures of phase space.
struct Orbits {
  CellLabels cell;
  std::vector<std::string> names;  ///< state components
  std::vector<double> times;       ///< in steps, the first is 0
  std::size_t members = 0;
  std::vector<double> states = {};  ///< [member][time][names], rounded to double; NaN once a member has failed

  double at(std::size_t member, std::size_t time, std::size_t component) const {
    return states[(member * times.size() + time) * names.size() + component];
  }
};

/// Of those units that hold states; no members where none does.
/// @throws RunError if a unit is damaged
Orbits orbits_of(std::vector<FinishedUnit> const& units);

}  // namespace brouwer
