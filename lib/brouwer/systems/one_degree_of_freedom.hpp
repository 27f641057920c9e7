#pragma once
#include <brouwer/systems/phase_errors.hpp>
#include <brouwer/systems/system.hpp>

namespace brouwer {

/// V, V′, V″, V‴, V⁗ at a point.
template <Real T>
using PotentialDerivatives = std::array<T, 5>;

/// V(q) of one degree of freedom, made from the numbers of its description's parameters. The force −V′(q) is given for
/// itself, because it decides speed. `offset` is the number by which V lies below an energy that is positive: the size of
/// errors must not hang on where zero is.
template <class V>
concept Potential = Real<typename V::Scalar> && std::constructible_from<V, std::span<typename V::Scalar const>> &&
    requires(V const v, typename V::Scalar const q) {
  { v.template in<typename V::Scalar>() } -> std::same_as<V>;
  { v.force(q) } -> std::same_as<typename V::Scalar>;
  { v.derivatives(q) } -> std::same_as<PotentialDerivatives<typename V::Scalar>>;
  { v.offset() } -> std::same_as<typename V::Scalar>;
};

/// H = ½p² + V(q), and the modified Hamiltonians of Störmer–Verlet (half kick, drift, half kick) with step h,
///     H̃ = H + h² (p²V″/12 − V′²/24) + h⁴ (−p⁴V⁗/720 + p²V′V‴/120 + p²V″²/60 − V″V′²/240) + O(h⁶)
/// cut after h² and after h⁴: over very long times H oscillates by O(h²), H̃₂ by O(h⁴), H̃₄ by O(h⁶).
/// E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, IX.
template <Real T, template <class> class V>
requires Potential<V<T>>
class OneDegreeOfFreedom {
 public:
  using Scalar = T;
  using State = PhaseState<T, 1>;
  using Part = typename State::Part;
  template <Real U>
  using In = OneDegreeOfFreedom<U, V>;

  static constexpr int first_integral_count = 3;  ///< H, H̃₂, H̃₄
  static constexpr int state_error_count = 3;     ///< q, p, phase

  explicit OneDegreeOfFreedom(V<T> const& potential) : potential_(potential) {}
  explicit OneDegreeOfFreedom(std::span<T const> parameters) : potential_(parameters) {}

  template <Real U>
  In<U> in() const {
    return In<U>(potential_.template in<U>());
  }

  Part velocity(Part const& p) const { return p; }
  Part force(Part const& q) const { return {potential_.force(q[0])}; }
  State rate(State const& y) const { return {y.p, force(y.q)}; }

  T energy(State const& y) const { return y.p[0] * y.p[0] / T(2) + potential_.derivatives(y.q[0])[0]; }

  /// @param h  the step of the method, 0 for the flow: then all three are H
  std::array<T, first_integral_count> first_integrals(State const& y, T const& h) const {
    auto const [v, v1, v2, v3, v4] = potential_.derivatives(y.q[0]);
    T const p2 = y.p[0] * y.p[0], slope2 = v1 * v1, h2 = h * h;
    T const second = (p2 * v2 - slope2 / T(2)) / T(12);
    T const fourth = (p2 * (v1 * v3 / T(2) + v2 * v2) - (p2 * p2 * v4 / T(3) + v2 * slope2) / T(4)) / T(60);
    T const energy = p2 / T(2) + v, with_second = energy + h2 * second;
    return {energy, with_second, with_second + h2 * h2 * fourth};
  }

  /// The start's energy over the potential's floor, for all three.
  std::array<T, first_integral_count> first_integral_scales(State const& start) const {
    T const scale = or_one(T(energy(start) + potential_.offset()));
    return {scale, scale, scale};
  }

  std::array<T, state_error_count> state_errors(State const& y, State const& reference) const {
    return phase_space_errors(*this, y, reference);
  }

 private:
  V<T> potential_;
};

/// Energy and modified energies, in the order of first_integrals().
/// @param scale  what their errors are relative to, in words
inline std::vector<Quantity> energies_of_one_degree(std::string const& scale) {
  auto const modified = [&](std::string const& order, std::string const& what) {
    return Quantity{
        "energy-modified-" + order,
        {"energy-modified-" + order},
        "relative",
        Quantity::Kind::integral,
        false,
        "modified Hamiltonian of Stoermer-Verlet (kick, drift, kick) " + what + "; error relative to " + scale};
  };
  return {energy_quantity("H; error relative to " + scale), modified("2", "up to h^2"), modified("4", "up to h^4")};
}

/// All that is observed of one degree of freedom.
inline std::vector<Quantity> quantities_of_one_degree(std::string const& scale, std::string const& unit) {
  auto quantities = energies_of_one_degree(scale);
  quantities.insert(quantities.end(), {state_quantity(1, unit), phase_quantity()});
  return quantities;
}

}  // namespace brouwer
