#pragma once
#include <brouwer/special/trigonometric.hpp>
#include <brouwer/systems/phase_errors.hpp>
#include <brouwer/systems/system.hpp>

namespace brouwer {

/// Lengths, masses and gravity of a double pendulum.
template <Real T>
struct DoublePendulumParameters {
  std::array<T, 2> length, mass;
  T gravity;
};

/// Two mass points on massless rods, the second hanging from the first, in the canonical coordinates of the angles q₁, q₂
/// from the vertical. With Δ = q₁ − q₂ and D = m₁ + m₂ sin²Δ
///     q̇₁ = (l₂p₁ − l₁p₂ cos Δ) / (l₁²l₂D)    q̇₂ = (m₁ l₁p₂ + m₂ (l₁p₂ − l₂p₁ cos Δ)) / (m₂l₁l₂²D)
///     H = ½(q̇₁p₁ + q̇₂p₂) − (m₁ + m₂) g l₁ cos q₁ − m₂ g l₂ cos q₂
/// so that H is not separable; ∂H/∂Δ at constant momenta is −∂L/∂Δ at constant velocities, m₂l₁l₂q̇₁q̇₂ sin Δ. From the
/// Lagrangian in L. D. Landau, E. M. Lifshitz, Mechanics, section 5, problem 1, by Legendre's transformation.
///
/// No constant is formed from the parameters alone: each is multiplied with what depends on the state. A rounded
/// (m₁ + m₂) g or 1/l₁ would be another pendulum's, the same in every step, and several of them one that has no energy.
template <Real T>
class DoublePendulum {
 public:
  using Scalar = T;
  using State = PhaseState<T, 2>;
  using Part = typename State::Part;
  template <Real U>
  using In = DoublePendulum<U>;

  static constexpr int first_integral_count = 1;  ///< H
  static constexpr int state_error_count = 5;     ///< q, p, phase

  explicit DoublePendulum(DoublePendulumParameters<T> const& parameters) : parameters_(parameters) {}
  explicit DoublePendulum(std::span<T const> p) : parameters_{{p[0], p[1]}, {p[2], p[3]}, p[4]} {}

  template <Real U>
  DoublePendulum<U> in() const {
    auto const& [l, m, g] = parameters_;
    return DoublePendulum<U>(DoublePendulumParameters<U>{{U(l[0]), U(l[1])}, {U(m[0]), U(m[1])}, U(g)});
  }

  /// 41 operations, of them two divisions, and two sine_cosine.
  State rate(State const& y) const {
    auto const first = sine_cosine(y.q[0]), second = sine_cosine(y.q[1]);
    T const sine = first.sin * second.cos - first.cos * second.sin;
    auto const w = velocities(y.p, T(first.cos * second.cos + first.sin * second.sin), sine);
    auto const& [l, m, g] = parameters_;
    T const coupling = m[1] * ((l[0] * w[0]) * ((l[1] * w[1]) * sine));
    auto const weight = weights(first.sin, second.sin);
    return {w, {-(coupling + weight[0]), coupling - weight[1]}};
  }

  T energy(State const& y) const {
    auto const weight = weights(sine_cosine(y.q[0]).cos, sine_cosine(y.q[1]).cos);
    return inner_product(rate(y).q, y.p) / T(2) - weight[0] - weight[1];
  }

  std::array<T, first_integral_count> first_integrals(State const& y) const { return {energy(y)}; }

  /// The start's energy over that of the pendulum that hangs at rest.
  std::array<T, first_integral_count> first_integral_scales(State const& start) const {
    auto const rest = weights(T(1), T(1));
    return {or_one(T(energy(start) + rest[0] + rest[1]))};
  }

  std::array<T, state_error_count> state_errors(State const& y, State const& reference) const {
    return phase_space_errors(*this, y, reference);
  }

 private:
  /// q̇₁, q̇₂
  Part velocities(Part const& p, T const& cosine, T const& sine) const {
    auto const& [l, m, g] = parameters_;
    T const a = l[1] * p[0], b = l[0] * p[1];
    T const below = l[0] * (l[1] * (m[0] + m[1] * (sine * sine)));
    return {(a - b * cosine) / (l[0] * below), (m[0] * b + m[1] * (b - a * cosine)) / (m[1] * (l[1] * below))};
  }

  /// (m₁ + m₂) g l₁ x₁ and m₂ g l₂ x₂: torques of sines, potential energies of cosines.
  Part weights(T const& x1, T const& x2) const {
    auto const& [l, m, g] = parameters_;
    T const upper = g * (l[0] * x1);
    return {m[0] * upper + m[1] * upper, m[1] * (g * (l[1] * x2))};
  }

  DoublePendulumParameters<T> parameters_;
};

inline std::optional<std::string> double_pendulum_complaint(FieldValues const& values) {
  if (auto complaint = finite_complaint(values)) return complaint;
  for (char const* name : {"length", "mass"})
    for (double number : values.at(name))
      if (!(number > 0)) return std::string(name) + " must be two positive numbers";
  if (!(values.at("gravity")[0] >= 0)) return "gravity must not be negative";
  return std::nullopt;
}

/// As data. The orbit of the standard start is regular (nearby orbits part in proportion to time, by a factor 0.03 t up to
/// t = 1800, measured) and its numbers are binary; with the angles (2, 1) it is chaotic, with a Lyapunov exponent of 0.34.
inline SystemDescription describe_double_pendulum() {
  return {"double_pendulum",
          "double pendulum: angles q from the vertical and their canonical momenta p",
          {{"length", 2, true, "length", "of the rods, > 0", {1, 1}},
           {"mass", 2, true, "mass", "of the points, > 0", {1, 1}},
           {"gravity", 1, true, "length / time^2", "free fall, >= 0", {1}},
           {"position", 2, false, "rad", "angles from the vertical, 0 at rest", {0.75, 0.5}},
           {"momentum", 2, false, "mass length^2 / time", "canonical momenta, 0 where nothing moves", {0, 0}}},
          {energy_quantity("H; error relative to H(0) less the energy of the pendulum at rest"),
           state_quantity(2, "rad; mass length^2 / time"), phase_quantity()},
          {"q1", "q2", "p1", "p2"},
          4,
          false,
          double_pendulum_complaint};
}

}  // namespace brouwer
