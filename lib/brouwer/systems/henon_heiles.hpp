#pragma once
#include <brouwer/systems/phase_errors.hpp>
#include <brouwer/systems/system.hpp>

namespace brouwer {

/// A star in the plane of a galaxy, in the variables of the reduced problem:
///     H = ½(p₁² + p₂²) + V(q)    V = ½(q₁² + q₂²) + q₁²q₂ − q₂³/3
/// Bound in the triangle with the corners (0, 1), (±√3/2, −1/2) where H < 1/6. M. Hénon, C. Heiles, Astron. J. 69 (1964) 73.
template <Real T>
class HenonHeiles {
 public:
  using Scalar = T;
  using State = PhaseState<T, 2>;
  using Part = typename State::Part;
  template <Real U>
  using In = HenonHeiles<U>;

  static constexpr int first_integral_count = 1;  ///< H
  static constexpr int state_error_count = 5;     ///< q, p, phase

  explicit HenonHeiles(std::span<T const> = {}) {}

  template <Real U>
  HenonHeiles<U> in() const {
    return HenonHeiles<U>();
  }

  Part velocity(Part const& p) const { return p; }

  /// −∇V = (q₁(−1 − 2q₂), q₂² − q₁² − q₂). 7 operations, no constant but 1.
  Part force(Part const& q) const { return {q[0] * ((T(-1) - q[1]) - q[1]), (q[1] * q[1] - q[0] * q[0]) - q[1]}; }

  State rate(State const& y) const { return {y.p, force(y.q)}; }

  T energy(State const& y) const {
    T const x2 = y.q[0] * y.q[0], y2 = y.q[1] * y.q[1], kinetic = y.p[0] * y.p[0] + y.p[1] * y.p[1];
    return (kinetic + (x2 + y2)) / T(2) + y.q[1] * (x2 - y2 / T(3));
  }

  std::array<T, first_integral_count> first_integrals(State const& y) const { return {energy(y)}; }

  /// |H| of the start: 0 at the origin alone and, outside the triangle, where the cubic terms undo the others.
  std::array<T, first_integral_count> first_integral_scales(State const& start) const {
    using math::abs;
    return {or_one(T(abs(energy(start))))};
  }

  std::array<T, state_error_count> state_errors(State const& y, State const& reference) const {
    return phase_space_errors(*this, y, reference);
  }
};

/// As data. The standard start has H = 5/48 and exact binary numbers, and its orbit is regular: nearby orbits part in
/// proportion to time (by a factor 0.3 t up to t = 10⁵, measured), so that states can be compared with a reference for a
/// long time. q = (0, 0.3), p = (0.3714835124, 0.2), with H = 1/8, is chaotic: Lyapunov exponent 0.03.
inline SystemDescription describe_henon_heiles() {
  return {"henon_heiles",
          "Henon-Heiles: H = (|p|^2 + |q|^2)/2 + q1^2 q2 - q2^3/3",
          {{"position", 2, false, "1", "q; bound inside the triangle (0, 1), (+-sqrt(3)/2, -1/2)", {0, 0.25}},
           {"momentum", 2, false, "1", "p = q'; the orbit stays bound where H < 1/6", {0.375, 0.125}}},
          {energy_quantity("H; error relative to |H(0)|"), state_quantity(2, "1"), phase_quantity()},
          {"q1", "q2", "p1", "p2"},
          4,
          false,
          finite_complaint};
}

}  // namespace brouwer
