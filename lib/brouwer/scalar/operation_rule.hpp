#pragma once

namespace brouwer {

/// Which of its two neighbours a number takes that the arithmetic does not hold.
enum class Rounding {
  nearest,      ///< ties to even, as every processor does
  up,           ///< towards +∞
  down,         ///< towards −∞
  toward_zero,  ///< cut off
  stochastic,   ///< either, the nearer one with the greater chance, so that the mean of the error is 0
};

/// How the operations of a step are carried out.
struct OperationRule {
  Rounding rounding = Rounding::nearest;
  bool exact_constants = false;  ///< the method's constants are held in two numbers each
  bool contraction = false;      ///< the product in a·b ± c is not rounded by itself

  bool operator==(OperationRule const&) const = default;
  /// What a processor does unasked.
  bool standard() const { return *this == OperationRule{}; }
};

}  // namespace brouwer
