#pragma once
#include <array>
#include <cmath>
#include <span>

#include <brouwer/scalar/wider.hpp>
#include <brouwer/systems/description.hpp>
#include <brouwer/systems/quaternion.hpp>

namespace brouwer {

/// Where a free rigid body is: its angular momentum in the body frame, and the rotation Q from the body frame to
/// space as a unit quaternion.
template <Real T>
struct RigidBodyState {
  using Scalar = T;
  Vector3<T> momentum;
  Quaternion<T> attitude;

  static RigidBodyState from_components(std::span<T const> c) { return {{c[0], c[1], c[2]}, {c[3], c[4], c[5], c[6]}}; }
};

template <class F, class S, class... Others>
requires(std::same_as<std::remove_const_t<S>, RigidBodyState<typename S::Scalar>>) void for_components(
    F f, S& a, Others&... others) {
  f(a.momentum[0], others.momentum[0]...);
  f(a.momentum[1], others.momentum[1]...);
  f(a.momentum[2], others.momentum[2]...);
  f(a.attitude.w(), others.attitude.w()...);
  f(a.attitude.x(), others.attitude.x()...);
  f(a.attitude.y(), others.attitude.y()...);
  f(a.attitude.z(), others.attitude.z()...);
}

/// The free rigid body: ẏ = y × (I⁻¹y), Q̇ = Q hat(I⁻¹y), with moments of inertia 0 < I₁ ≤ I₂ ≤ I₃ ≤ I₁ + I₂.
/// E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, VII.5.
template <Real T>
class RigidBody {
 public:
  using Scalar = T;
  using State = RigidBodyState<T>;
  template <Real U>
  using In = RigidBody<U>;

  static constexpr int first_integral_count = 6;  ///< H, C, (Qy)₁₂₃, |q|
  static constexpr int state_error_count = 7;     ///< momentum (3), attitude (3), phase

  explicit RigidBody(Vector3<T> const& inertia) : inertia_(inertia) {}
  explicit RigidBody(std::span<T const> inertia) : inertia_(inertia[0], inertia[1], inertia[2]) {}

  Vector3<T> const& inertia() const { return inertia_; }

  /// The same body in another arithmetic; exact towards a wider one.
  template <Real U>
  RigidBody<U> in() const {
    return RigidBody<U>(Vector3<U>{U(inertia_[0]), U(inertia_[1]), U(inertia_[2])});
  }

  Vector3<T> angular_velocity(Vector3<T> const& y) const {
    return {y[0] / inertia_[0], y[1] / inertia_[1], y[2] / inertia_[2]};
  }
  Vector3<T> momentum_rate(Vector3<T> const& y) const { return cross(y, angular_velocity(y)); }

  /// ẏ = y × ω and q̇ = ½ q ⊗ (0, ω), with one ω = I⁻¹y for both: then rounding ω moves neither |y| nor Qy. 36 operations.
  /// The three divisions stay: a rounded 1/Iⱼ is another body's, the same in every step, from which states part in proportion
  /// to time; and rounded 1/I₃ − 1/I₂ … do not add up to 0, which |y| would feel. A quotient errs to no side.
  State rate(State const& s) const {
    auto const omega = angular_velocity(s.momentum);
    auto const& q = s.attitude;
    T const half = T(1) / T(2), a = half * omega[0], b = half * omega[1], c = half * omega[2];
    return {cross(s.momentum, omega),
            {-(q.x() * a + q.y() * b + q.z() * c), q.w() * a + q.y() * c - q.z() * b, q.w() * b + q.z() * a - q.x() * c,
             q.w() * c + q.x() * b - q.y() * a}};
  }

  /// H = ½ Σ yⱼ²/Iⱼ
  T energy(Vector3<T> const& y) const {
    return (y[0] * y[0] / inertia_[0] + y[1] * y[1] / inertia_[1] + y[2] * y[2] / inertia_[2]) / T(2);
  }
  /// C = ½ |y|²
  T casimir(Vector3<T> const& y) const { return squared_norm(y) / T(2); }
  /// Q y, in space
  Vector3<T> spatial_momentum(State const& s) const { return rotated(s.attitude, s.momentum); }

  /// In the order of describe_rigid_body()'s quantities of this kind.
  std::array<T, first_integral_count> first_integrals(State const& s) const {
    using math::sqrt;
    auto const spatial = spatial_momentum(s);
    return {energy(s.momentum), casimir(s.momentum), spatial[0],
            spatial[1],         spatial[2],          sqrt(squared_norm(s.attitude))};
  }

  /// What errors of the first integrals are divided by: their size at the start (H, C, |y| and 1); 1 where that is 0.
  std::array<T, first_integral_count> first_integral_scales(State const& start) const {
    using math::sqrt;
    auto const or_one = [](T const& a) { return select(a > T(0), a, T(1)); };
    T const length = or_one(T(sqrt(squared_norm(start.momentum))));
    return {or_one(energy(start.momentum)), or_one(casimir(start.momentum)), length, length, length, T(1)};
  }

  /// In the order of describe_rigid_body().quantities that need a reference: y − y*, the rotation vector of q*⁻¹ ⊗ q in the
  /// body frame (radians), and the phase ⟨y − y*, ẏ*⟩ / |ẏ*|²: by how much time the body runs ahead.
  std::array<T, state_error_count> state_errors(State const& s, State const& reference) const {
    Vector3<T> const d{s.momentum[0] - reference.momentum[0], s.momentum[1] - reference.momentum[1],
                       s.momentum[2] - reference.momentum[2]};
    auto const turn = rotation_vector(hamilton_product(conjugate(reference.attitude), s.attitude));
    auto const rate = momentum_rate(reference.momentum);
    T const speed2 = squared_norm(rate);
    T const ahead = d[0] * rate[0] + d[1] * rate[1] + d[2] * rate[2];
    T const phase = select(speed2 > T(0), ahead / select(speed2 > T(0), speed2, T(1)), T(0));
    return {d[0], d[1], d[2], turn[0], turn[1], turn[2], phase};
  }

 private:
  Vector3<T> inertia_;
};

/// Why these moments of inertia are no body's, or nothing.
inline std::optional<std::string> inertia_complaint(std::vector<double> const& I) {
  for (double moment : I)
    if (!(std::isfinite(moment) && moment > 0)) return "inertia must be three positive finite numbers";
  if (!(I[0] <= I[1] && I[1] <= I[2])) return "inertia must be sorted, I1 <= I2 <= I3";
  // I₃ = I₁ + I₂ is a flat body; decimal input may miss it by a rounding error
  if (I[2] > (I[0] + I[1]) * (1 + 4e-16)) return "inertia is of no real body: I3 may not exceed I1 + I2";
  return std::nullopt;
}

inline std::optional<std::string> rigid_body_complaint(FieldValues const& values) {
  if (auto complaint = inertia_complaint(values.at("inertia"))) return complaint;
  auto const& q = values.at("attitude");
  double const n = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (!(std::abs(n - 1) <= 1e-6)) return "attitude must be a unit quaternion (q0, q1, q2, q3)";
  for (double component : values.at("momentum"))
    if (!std::isfinite(component)) return "momentum must be finite numbers";
  return std::nullopt;
}

/// A perturbed attitude back to length 1, as well as doubles can.
inline void normalise_attitude(FieldValues& values) {
  auto& q = values.at("attitude");
  double const n = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (n > 0)
    for (double& component : q) component /= n;
}

/// The rigid body as data. The standard values are the test of E. Hairer, G. Vilmart, J. Phys. A 39 (2006) 13225.
inline SystemDescription describe_rigid_body() {
  using Kind = Quantity::Kind;
  return {
      "rigid_body",
      "free rigid body: angular momentum y in the body frame and attitude q (unit quaternion)",
      {{"inertia", 3, true, "mass length^2", "moments of inertia, 0 < I1 <= I2 <= I3 <= I1 + I2", {0.6, 0.8, 1.0}},
       {"momentum", 3, false, "mass length^2 / time", "angular momentum in the body frame", {1.8, 0.4, -0.9}},
       {"attitude", 4, false, "1", "unit quaternion (q0, q1, q2, q3), body to space", {1, 0, 0, 0}}},
      {{"energy", {"energy"}, "relative", Kind::integral, false, "H = 1/2 sum y_j^2 / I_j; error relative to H(0)"},
       {"casimir", {"casimir"}, "relative", Kind::integral, false, "C = 1/2 |y|^2; error relative to C(0)"},
       {"spatial-momentum",
        {"spatial-momentum-1", "spatial-momentum-2", "spatial-momentum-3"},
        "relative",
        Kind::integral,
        true,
        "Q y, constant in space; error relative to |y(0)|"},
       {"attitude-norm", {"attitude-norm"}, "absolute", Kind::integral, true, "|q|, which is 1"},
       {"state",
        {"momentum-1", "momentum-2", "momentum-3", "attitude-1", "attitude-2", "attitude-3"},
        "momentum; rad",
        Kind::state,
        true,
        "y - y*, and the rotation vector of q*^-1 q in the body frame (radians)"},
       {"phase", {"phase"}, "time", Kind::state, false, "by how much time the momentum runs ahead of the reference"},
       iterations_quantity()},
      {"y1", "y2", "y3", "q0", "q1", "q2", "q3"},
      3,
      true,
      rigid_body_complaint,
      normalise_attitude};
}

}  // namespace brouwer
