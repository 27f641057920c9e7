#pragma once
#include <vector>

#include "analysis/causes/explanation.hpp"
#include "analysis/causes/remainder.hpp"

namespace brouwer {

/// What a cell has otherwise than the nominal one, as a question about the cause.
enum class Change {
  higher_precision,
  nearest_for_directed,    ///< rounding to nearest in place of up, down or toward zero
  constants,               ///< exact ones
  unbiased_rounding,       ///< stochastic
  constants_and_rounding,  ///< both of these
  coefficients,            ///< any other level
  functions,               ///< any other
  sum,
  products
};

/// The compared cells of an explanation, asked for what is left of its subject.
class Evidence {
 public:
  Evidence(Explanation const& explanation, Subject subject) : explanation_(explanation), subject_(subject) {}

  /// Of this change; gone where it is gone in one of the cells that make it. Unknown where there is none.
  Remainder remainder(Change change) const;
  /// The cell that shows it; none where no cell makes this change.
  ComparedCell const* cell(Change change) const;

 private:
  Explanation const& explanation_;
  Subject subject_;
};

}  // namespace brouwer
