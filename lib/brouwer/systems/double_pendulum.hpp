#pragma once
#include <brouwer/special/trigonometric.hpp>
#include <brouwer/systems/constant_in_two_parts.hpp>
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
/// from the vertical. With Δ = q₁ − q₂, a = p₁/l₁, b = p₂/l₂ the velocities l₁q̇₁ = u, l₂q̇₂ = v along and H are
///     u = (a − b cos Δ)/D    v = ((m₁/m₂) b + b − a cos Δ)/D    D = m₁ + m₂ sin²Δ
///     H = ½(q̇₁p₁ + q̇₂p₂) − (m₁ + m₂) g l₁ cos q₁ − m₂ g l₂ cos q₂
/// so that H is not separable; and ∂H/∂Δ at constant momenta is −∂L/∂Δ at constant velocities, m₂uv sin Δ. From the
/// Lagrangian in L. D. Landau, E. M. Lifshitz, Mechanics, section 5, problem 1, by Legendre's transformation.
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

  explicit DoublePendulum(DoublePendulumParameters<T> const& parameters)
      : parameters_(parameters), constants_(converted<Wider<T>>(parameters)) {}
  explicit DoublePendulum(std::span<T const> p) : DoublePendulum({{p[0], p[1]}, {p[2], p[3]}, p[4]}) {}

  template <Real U>
  DoublePendulum<U> in() const {
    return DoublePendulum<U>(converted<U>(parameters_));
  }

  /// 44 operations, of them one division, and two sine_cosine.
  State rate(State const& y) const {
    auto const first = sine_cosine(y.q[0]), second = sine_cosine(y.q[1]);
    T const sine = first.sin * second.cos - first.cos * second.sin;
    auto const [u, v] = velocities(y.p, T(first.cos * second.cos + first.sin * second.sin), sine);
    T const coupling = parameters_.mass[1] * ((u * v) * sine);
    return {{constants_.inverse_length1 * u, constants_.inverse_length2 * v},
            {-(coupling + constants_.weight1 * first.sin), coupling - constants_.weight2 * second.sin}};
  }

  T energy(State const& y) const {
    auto const first = sine_cosine(y.q[0]), second = sine_cosine(y.q[1]);
    auto const q_rate = rate(y).q;
    T const twice_kinetic = q_rate[0] * y.p[0] + q_rate[1] * y.p[1];
    return twice_kinetic / T(2) - constants_.weight1 * first.cos - constants_.weight2 * second.cos;
  }

  std::array<T, first_integral_count> first_integrals(State const& y) const { return {energy(y)}; }

  /// The start's energy over that of the pendulum that hangs at rest.
  std::array<T, first_integral_count> first_integral_scales(State const& start) const {
    return {or_one(T(energy(start) + (constants_.weight1 * T(1) + constants_.weight2 * T(1))))};
  }

  std::array<T, state_error_count> state_errors(State const& y, State const& reference) const {
    return phase_space_errors(*this, y, reference);
  }

 private:
  using Parameters = DoublePendulumParameters<T>;

  template <Real U>
  static DoublePendulumParameters<U> converted(Parameters const& p) {
    return {{U(p.length[0]), U(p.length[1])}, {U(p.mass[0]), U(p.mass[1])}, U(p.gravity)};
  }

  struct Constants {
    ConstantInTwoParts<T> inverse_length1, inverse_length2, mass_ratio;  ///< 1/l₁, 1/l₂, m₁/m₂
    ConstantInTwoParts<T> weight1, weight2;                              ///< (m₁ + m₂) g l₁, m₂ g l₂

    explicit Constants(DoublePendulumParameters<Wider<T>> const& p)
        : inverse_length1(Wider<T>(1) / p.length[0]),
          inverse_length2(Wider<T>(1) / p.length[1]),
          mass_ratio(p.mass[0] / p.mass[1]),
          weight1((p.mass[0] + p.mass[1]) * p.gravity * p.length[0]),
          weight2(p.mass[1] * p.gravity * p.length[1]) {}
  };

  /// u, v
  std::array<T, 2> velocities(Part const& p, T const& cosine, T const& sine) const {
    T const a = constants_.inverse_length1 * p[0], b = constants_.inverse_length2 * p[1];
    T const factor = T(1) / (parameters_.mass[0] + parameters_.mass[1] * (sine * sine));
    return {factor * (a - b * cosine), factor * (constants_.mass_ratio * b + (b - a * cosine))};
  }

  Parameters parameters_;
  Constants constants_;
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
           state_quantity(2, "rad; mass length^2 / time"), phase_quantity(), iterations_quantity()},
          {"q1", "q2", "p1", "p2"},
          4,
          false,
          double_pendulum_complaint};
}

}  // namespace brouwer
