#pragma once
#include <brouwer/scalar/wider.hpp>

namespace brouwer {

/// A constant of a vector field as the sum of two T, for products in twice the bits. A constant that is rounded to T is
/// another system's, the same in every step and of every member: states then part from the reference in proportion to
/// time, however well the steps are rounded, and where several such constants contradict one another the energy drifts.
/// What is left here of that is below ε²; the error of a product is another one for every x, at most ε|cx|. Two more
/// operations than a product, and cheaper than a division by a parameter.
template <Real T>
class ConstantInTwoParts {
 public:
  explicit ConstantInTwoParts(Wider<T> const& c)
      : high_(rounded<T>(c)), low_(rounded<T>(Wider<T>(c - Wider<T>(high_)))) {}

  /// 3 operations.
  friend T operator*(ConstantInTwoParts const& c, T const& x) { return c.high_ * x + c.low_ * x; }

 private:
  T high_, low_;
};

}  // namespace brouwer
