#pragma once
#include <string>
#include <vector>

#include <brouwer/ensemble/plan.hpp>
#include <brouwer/ensemble/start.hpp>

namespace brouwer {

/// What a cell's reference runs: the same method with the step that the cell's arithmetic holds, in another arithmetic.
CellLabels reference_cell(CellLabels cell, std::string const& arithmetic);

/// Does anything that the study observes need a reference?
bool needs_reference(Study const& study, Catalogue const& catalogue);

/// How well a double-double reference stands in for one in mpfr-256.
struct ReferenceCheck {
  double worst = 0;          ///< largest (double-double − mpfr-256) / (working arithmetic − mpfr-256) of a state
  std::int64_t steps = 0;    ///< over how many steps
  std::int64_t members = 0;  ///< of how many members
  static constexpr double limit = 1e-6;
  bool passed() const { return worst <= limit; }
};

/// Runs the first members of a cell, its double-double reference and the same in mpfr-256, and compares their states at
/// the study's samples. Depends on the study alone.
ReferenceCheck check_reference(Study const& study, Catalogue const& catalogue, CellLabels const& cell);

/// Checks the reference of every cell where it is double-double; a cell that fails gets mpfr-256 instead.
/// @return a sentence for each that failed
std::vector<std::string> check_references(Study const& study, Catalogue const& catalogue, Plan& plan);

}  // namespace brouwer
