#pragma once
#include <cmath>
#include <limits>
#include <sstream>

#include <brouwer/scalar/float128.hpp>
#include <brouwer/systems/description.hpp>

namespace brouwer {

// The outer solar system of 1994-09-05, 0h, and its frame. Astronomical units, days, masses of the Sun.
// E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, table I.2.2; the same numbers, with their source, in
// data/outer_solar_system.toml.

inline constexpr std::size_t outer_bodies = 6;
inline constexpr std::array<char const*, outer_bodies> outer_body_names = {"sun",    "jupiter", "saturn",
                                                                           "uranus", "neptune", "pluto"};
inline constexpr double outer_gravitational_constant = 2.95912208286e-4;
/// The inner planets belong to the Sun; Pluto's mass is 1/(1.3·10⁸).
inline constexpr std::array<double, outer_bodies> outer_masses = {
    1.00000597682, 0.000954786104043, 0.000285583733151, 0.0000437273164546, 0.0000517759138449, 1 / 1.3e8};
// clang-format off
inline constexpr std::array<double, 3 * outer_bodies> outer_positions = {
      0,            0,            0,
     -3.5023653,   -3.8169847,   -1.5507963,
      9.0755314,   -3.0458353,   -1.6483708,
      8.3101420,  -16.2901086,   -7.2521278,
     11.4707666,  -25.7294829,  -10.8169456,
    -15.5387357,  -25.2225594,   -3.1902382};
inline constexpr std::array<double, 3 * outer_bodies> outer_velocities = {
      0,            0,            0,
      0.00565429,  -0.00412490,  -0.00190589,
      0.00168318,   0.00483525,   0.00192462,
      0.00354178,   0.00137102,   0.00055029,
      0.00288930,   0.00114527,   0.00039677,
      0.00276725,  -0.00170702,  -0.00136504};
// clang-format on

/// Σ mᵢxᵢ / Σ mᵢ of positions or velocities.
inline std::array<Float128, 3> barycentre_of(std::vector<double> const& masses, std::vector<double> const& x) {
  Float128 total = 0;
  std::array<Float128, 3> sum{};
  for (std::size_t i = 0; i < outer_bodies; ++i) {
    total += Float128(masses[i]);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += Float128(masses[i]) * Float128(x[3 * i + c]);
  }
  for (auto& component : sum) component /= total;
  return sum;
}

/// Positions or velocities relative to the barycentre. The planets' are rounded; the Sun's follows from the rounded ones,
/// Σ mᵢxᵢ = 0, because an ulp of Neptune's would otherwise move the centre of mass by more than the Sun's own rounding does.
inline void recentre(std::vector<double> const& masses, std::vector<double>& x) {
  auto const centre = barycentre_of(masses, x);
  for (std::size_t c = 0; c < 3; ++c) {
    Float128 planets = 0;
    for (std::size_t i = 1; i < outer_bodies; ++i) {
      double& component = x[3 * i + c];
      component = static_cast<double>(Float128(Float128(component) - centre[c]));
      planets += Float128(masses[i]) * Float128(component);
    }
    x[c] = static_cast<double>(Float128(-planets / Float128(masses[0])));
  }
}

/// Into the frame of the barycentre, where the study wants that.
inline void project_outer_solar_system(FieldValues& values) {
  if (values.at("recentre")[0] == 0) return;
  recentre(values.at("masses"), values.at("position"));
  recentre(values.at("masses"), values.at("velocity"));
}

/// That the centre of mass moves, where it does so by more than the rounding of a recentred start to double leaves.
inline std::optional<std::string> outer_solar_system_warning(FieldValues const& values) {
  if (values.at("recentre")[0] != 0) return std::nullopt;
  auto const& v = values.at("velocity");
  auto const drift = barycentre_of(values.at("masses"), v);
  double const speed =
      std::hypot(static_cast<double>(drift[0]), static_cast<double>(drift[1]), static_cast<double>(drift[2]));
  double const sun = std::hypot(v[0], v[1], v[2]);
  if (speed <= std::numeric_limits<double>::epsilon() * sun) return std::nullopt;
  std::ostringstream sentence;
  sentence.precision(2);
  sentence << "the centre of mass moves by " << speed
           << " AU/day: a drifting frame masquerades as round-off; recentre = 1 removes it";
  return sentence.str();
}

inline std::optional<std::string> outer_solar_system_complaint_of_parameters(FieldValues const& values) {
  if (!(values.at("gravitational-constant")[0] > 0)) return "gravitational-constant must be positive";
  auto const& masses = values.at("masses");
  if (!(masses[0] > 0)) return "masses must begin with that of the Sun, which is positive";
  for (double mass : masses)
    if (!(mass >= 0)) return "masses must not be negative";
  if (!(values.at("collision-distance")[0] >= 0)) return "collision-distance must not be negative";
  double const recentred = values.at("recentre")[0];
  if (recentred != 0 && recentred != 1) return "recentre must be 1 (frame of the barycentre) or 0 (as given)";
  return std::nullopt;
}

/// Which two bodies start too near to one another, or nothing.
inline std::optional<std::string> outer_solar_system_complaint_of_distances(FieldValues const& values) {
  auto const& q = values.at("position");
  for (std::size_t i = 0; i < outer_bodies; ++i)
    for (std::size_t j = i + 1; j < outer_bodies; ++j) {
      double const distance = std::hypot(q[3 * i] - q[3 * j], q[3 * i + 1] - q[3 * j + 1], q[3 * i + 2] - q[3 * j + 2]);
      if (!(distance > values.at("collision-distance")[0]))
        return std::string("position of ") + outer_body_names[i] + " and " + outer_body_names[j] +
               " must be farther apart than collision-distance";
    }
  return std::nullopt;
}

}  // namespace brouwer
