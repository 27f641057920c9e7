#pragma once
#include <brouwer/store/results.hpp>
#include <functional>
#include <optional>

#include "analysis/causes/explanation.hpp"

namespace brouwer {

/// The cells of a design around a nominal one, all with the same starts, samples and steps.
struct Design {
  struct Cell {
    CellLabels labels;
    int bits = 0;  ///< of the significands of its arithmetic
  };
  std::vector<Cell> cells;                        ///< the nominal one first
  std::function<Ensemble(std::size_t)> ensemble;  ///< of one quantity of one cell: they are loaded one at a time
};

/// Compares every cell with the nominal one, member by member, and names the cause (causes.hpp).
///
/// Compared are the members that came through in every cell and are set aside in none (far_off.hpp). A cell that lost
/// more than half of the nominal cell's members is left out; of fewer bits, one that lost a tenth, or in which all members are
/// the same (their starts differ by less than it holds). All of it is said.
///
/// The factorial is that over `constants`, `rounding` (nominal or stochastic) and `sum`, as far as all its cells are there.
/// @return nothing of a count, which has no law of growth
/// @throws InputError where the design has other times in one cell than in another
std::optional<Explanation> explain(Design const& design, Levels const& levels);

/// The rounding that the factorial sets against the nominal one: stochastic, which has no bias; against that, nearest.
std::string other_rounding(std::string const& nominal);

}  // namespace brouwer
