#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <brouwer/store/results.hpp>

namespace brouwer {

/// Errors of single steps of one scalar quantity of one cell: of some members, in windows of consecutive steps.
struct LocalErrors {
  CellLabels cell;
  std::string high_precision;  ///< the arithmetic of the steps that these are compared with
  std::string quantity;        ///< component name, e.g. "energy", "spatial-momentum-1"
  std::string family;          ///< the quantity it belongs to, e.g. "spatial-momentum"
  std::string unit;
  bool of_state =
      false;  ///< of a component of the state: later steps change it, so that no sum of it is a global error

  std::int64_t windows = 0;  ///< of each member
  std::int64_t length = 0;   ///< steps in a window
  std::int64_t judged = 0;   ///< steps of each window, from its first, that were made in high precision, too
  std::int64_t covered = 0;  ///< the windows lie in so many steps from the start

  /// Members × (windows · length), every entry finite: after the working step minus after the high-precision step from
  /// the same state, over the system's scale of the quantity. Of the state members × (windows · judged).
  ErrorMatrix rounding = {};
  /// Members × (windows · judged): what the high-precision step itself changes, the error of the method. No columns where
  /// the quantity is rounding alone, or of the state.
  ErrorMatrix truncation = {};

  std::int64_t failed = 0;              ///< members left out: no next state within `covered`, or an error not finite
  std::vector<Failures> failures = {};  ///< of these, by reason
};

}  // namespace brouwer
