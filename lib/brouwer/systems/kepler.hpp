#pragma once
#include <limits>

#include <brouwer/systems/phase_errors.hpp>
#include <brouwer/systems/system.hpp>

namespace brouwer {

/// Two bodies in their plane: H = ½|p|² − 1/|q|, with the centre's attraction GM = 1.
///
/// Nearer to the centre than `collision_distance` the force is NaN: a method with a fixed step jumps over the pole of the
/// force with a velocity that means nothing, and goes on with finite numbers. Which distance is too near depends on the
/// step (free fall over r takes about r^{3/2}); the parameter is there to be set, and only has to exclude what no step of
/// the study resolves.
template <Real T>
class Kepler {
 public:
  using Scalar = T;
  using State = PhaseState<T, 2>;
  using Part = typename State::Part;
  template <Real U>
  using In = Kepler<U>;

  static constexpr int first_integral_count = 4;  ///< H, L, A₁, A₂
  static constexpr int state_error_count = 5;     ///< q, p, phase

  explicit Kepler(T const& collision_distance) : collision_distance_(collision_distance) {}
  explicit Kepler(std::span<T const> parameters) : collision_distance_(parameters[0]) {}

  template <Real U>
  Kepler<U> in() const {
    return Kepler<U>(U(collision_distance_));
  }

  Part velocity(Part const& p) const { return p; }

  /// −q/|q|³. 8 operations, of them a root and a division.
  Part force(Part const& q) const {
    using math::sqrt;
    T const r2 = q[0] * q[0] + q[1] * q[1], r = sqrt(r2);
    T const factor = select(r > collision_distance_, T(T(-1) / (r2 * r)), T(std::numeric_limits<T>::quiet_NaN()));
    return {factor * q[0], factor * q[1]};
  }

  State rate(State const& y) const { return {y.p, force(y.q)}; }

  T distance(State const& y) const {
    using math::sqrt;
    return sqrt(y.q[0] * y.q[0] + y.q[1] * y.q[1]);
  }
  /// H = ½|p|² − 1/|q|
  T energy(State const& y) const { return (y.p[0] * y.p[0] + y.p[1] * y.p[1]) / T(2) - T(1) / distance(y); }
  /// L = q₁p₂ − q₂p₁
  T angular_momentum(State const& y) const { return y.q[0] * y.p[1] - y.q[1] * y.p[0]; }

  /// H, L and the Laplace–Runge–Lenz vector A = p × L − q/|q|, which points to the pericentre and is as long as the orbit
  /// is eccentric.
  std::array<T, first_integral_count> first_integrals(State const& y) const {
    T const momentum = angular_momentum(y), r = distance(y);
    return {energy(y), momentum, y.p[1] * momentum - y.q[0] / r, -(y.p[0] * momentum) - y.q[1] / r};
  }

  /// |H| and |L| of the start, or 1 where they are 0; A is an eccentricity, and taken as it is.
  std::array<T, first_integral_count> first_integral_scales(State const& start) const {
    using math::abs;
    return {or_one(T(abs(energy(start)))), or_one(T(abs(angular_momentum(start)))), T(1), T(1)};
  }

  /// q − q*, p − p*, and the phase along the orbit, ⟨q − q*, q̇*⟩ / |q̇*|².
  std::array<T, state_error_count> state_errors(State const& y, State const& reference) const {
    auto const dq = difference(y.q, reference.q), dp = difference(y.p, reference.p);
    auto const& speed = reference.p;
    return {dq[0], dq[1], dp[0], dp[1], time_ahead(inner_product(dq, speed), inner_product(speed, speed))};
  }

  Failure failure(State const& y, int l) const {
    return is_set(distance(y) <= collision_distance_, l) ? Failure::collision : Failure::none;
  }

 private:
  T collision_distance_;
};

inline std::optional<std::string> kepler_complaint(FieldValues const& values) {
  if (auto complaint = finite_complaint(values)) return complaint;
  double const nearest = values.at("collision-distance")[0];
  if (!(nearest >= 0)) return "collision-distance must not be negative";
  auto const& q = values.at("position");
  if (!(std::hypot(q[0], q[1]) > nearest)) return "position must be farther from the centre than collision-distance";
  return std::nullopt;
}

/// As data. The standard start is the pericentre of an orbit with the eccentricity e = 0.6, the semi-major axis 1 and the
/// period 2π: q = (1 − e, 0), p = (0, √((1 + e)/(1 − e))).
inline SystemDescription describe_kepler() {
  using Kind = Quantity::Kind;
  auto phase = phase_quantity();
  phase.help = "by how much time the body runs ahead along its orbit, <q - q*, q*'> / |q*'|^2";
  return {
      "kepler",
      "Kepler's problem in the plane: H = |p|^2/2 - 1/|q|",
      {{"collision-distance", 1, true, "length", "nearer to the centre a member has collided: it ends there", {1e-4}},
       {"position", 2, false, "length", "q, from the centre", {0.4, 0}},
       {"momentum", 2, false, "length / time", "p = q'", {0, 2}}},
      {energy_quantity("H; error relative to |H(0)|"),
       {"angular-momentum",
        {"angular-momentum"},
        "relative",
        Kind::integral,
        false,
        "L = q1 p2 - q2 p1; error relative to |L(0)|"},
       {"laplace-runge-lenz",
        {"laplace-runge-lenz-1", "laplace-runge-lenz-2"},
        "absolute",
        Kind::integral,
        false,
        "A = p x L - q/|q|, of the length e: to the pericentre; along A an error of e, across it e times an angle"},
       state_quantity(2, "length; length / time"),
       phase},
      {"q1", "q2", "p1", "p2"},
      4,
      true,
      kepler_complaint};
}

}  // namespace brouwer
