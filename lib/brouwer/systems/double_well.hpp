#pragma once
#include <brouwer/systems/one_degree_of_freedom.hpp>

namespace brouwer {

/// V = (q² − 1)²: wells at q = ±1, and between them a hill of height 1.
template <Real T>
class DoubleWellPotential {
 public:
  using Scalar = T;

  explicit DoubleWellPotential(std::span<T const> = {}) {}
  template <Real U>
  DoubleWellPotential<U> in() const {
    return DoubleWellPotential<U>();
  }

  /// −V′ = 4q (1 − q²). 4 operations, no constant but 1 and 4.
  T force(T const& q) const { return (T(4) * q) * (T(1) - q * q); }

  PotentialDerivatives<T> derivatives(T const& q) const {
    T const q2 = q * q, q4 = T(4) * q, height = q2 - T(1);
    return {height * height, q4 * height, T(12) * q2 - T(4), T(6) * q4, T(24)};
  }

  T offset() const { return T(0); }
};

/// H = ½p² + (q² − 1)²
template <Real T>
using DoubleWell = OneDegreeOfFreedom<T, DoubleWellPotential>;

/// As data. The standard start, with H = 1.5625 and exact binary numbers, goes over the hill to the other well and back.
inline SystemDescription describe_double_well() {
  return {"double_well",
          "double well: H = p^2/2 + (q^2 - 1)^2",
          {{"position", 1, false, "1", "q; the wells are at -1 and 1", {1.5}},
           {"momentum", 1, false, "1", "p = q'; over the hill between the wells where H > 1", {0}}},
          quantities_of_one_degree("H(0)", "1"),
          {"q", "p"},
          2,
          false,
          finite_complaint};
}

}  // namespace brouwer
