#pragma once
#include <vector>

#include "analysis/pages/growth_table.hpp"

namespace brouwer {

/// What the increments of these estimates say of the model, for people: a line a quantity of a cell that has any, an
/// effect beside every p. Without rows where none has.
GrowthTable increments_table(std::vector<Estimates> const& rows, CellsAs layout);

/// What the decisions on drift are worth: drifts that are seen with chances of 50, 90 and 99 %, and the smallest of which
/// it is proven that β lies below. Rows without a test are left out.
GrowthTable decisions_table(std::vector<Estimates> const& rows, CellsAs layout);

}  // namespace brouwer
