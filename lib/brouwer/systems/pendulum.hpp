#pragma once
#include <brouwer/special/trigonometric.hpp>
#include <brouwer/systems/one_degree_of_freedom.hpp>

namespace brouwer {

/// V = −ω² cos q, q in radians from the lowest point. ω² is never formed: a rounded ω² would be another pendulum's, the same
/// in every step.
template <Real T>
class PendulumPotential {
 public:
  using Scalar = T;

  explicit PendulumPotential(std::span<T const> parameters) : frequency_(parameters[0]) {}
  explicit PendulumPotential(T const& frequency) : frequency_(frequency) {}
  template <Real U>
  PendulumPotential<U> in() const {
    return PendulumPotential<U>(U(frequency_));
  }

  /// −V′ = −ω(ω sin q). 3 operations and a sine.
  T force(T const& q) const { return -(frequency_ * (frequency_ * sine_cosine(q).sin)); }

  PotentialDerivatives<T> derivatives(T const& q) const {
    auto const [s, c] = sine_cosine(q);
    T const sine = frequency_ * (frequency_ * s), cosine = frequency_ * (frequency_ * c);
    return {-cosine, sine, cosine, -sine, -cosine};
  }

  /// ω²: V is −ω² at rest.
  T offset() const { return frequency_ * frequency_; }

 private:
  T frequency_;
};

/// H = ½p² − ω² cos q, the mathematical pendulum.
template <Real T>
using Pendulum = OneDegreeOfFreedom<T, PendulumPotential>;

/// As data. The standard start swings by 2 rad (115°) to either side: far from harmonic, far from the separatrix.
inline SystemDescription describe_pendulum() {
  return {"pendulum",
          "pendulum: H = p^2/2 - frequency^2 cos q",
          {{"frequency", 1, true, "rad / time", "of small oscillations, > 0", {1}},
           {"position", 1, false, "rad", "angle q from the lowest point", {2}},
           {"momentum", 1, false, "rad / time", "p = q'", {0}}},
          quantities_of_one_degree("H(0) + frequency^2, the start's energy over the lowest point's", "rad; rad / time"),
          {"q", "p"},
          2,
          false,
          [](FieldValues const& values) -> std::optional<std::string> {
            if (!(values.at("frequency")[0] > 0)) return "frequency must be positive";
            return finite_complaint(values);
          }};
}

}  // namespace brouwer
