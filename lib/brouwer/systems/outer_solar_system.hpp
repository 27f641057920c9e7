#pragma once
#include <brouwer/systems/outer_solar_system_start.hpp>
#include <brouwer/systems/phase_errors.hpp>
#include <brouwer/systems/quaternion.hpp>
#include <brouwer/systems/system.hpp>

namespace brouwer {

/// The Sun and the outer planets, Jupiter … Pluto, with Newton's attraction:
///     q̇ᵢ = vᵢ    v̇ᵢ = G Σⱼ mⱼ (qⱼ − qᵢ)/|qⱼ − qᵢ|³
/// The second part of a state are velocities, not momenta. E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration,
/// I.2.4.
///
/// No constant is formed from the parameters: G stands in the numerator of the only quotient, so that every arithmetic
/// integrates the same bodies, and not ones whose Gm has been rounded.
///
/// Bodies nearer to one another than collision_distance have no force but NaN: no fixed step of days resolves an encounter
/// there, and what comes out of it would be finite and mean nothing. The standard value, 0.005 AU, is a little more than
/// the Sun's radius.
template <Real T>
class OuterSolarSystem {
 public:
  using Scalar = T;
  static constexpr std::size_t bodies = outer_bodies;
  using State = PhaseState<T, 3 * bodies>;
  using Part = typename State::Part;
  template <Real U>
  using In = OuterSolarSystem<U>;

  static constexpr int first_integral_count = 10;  ///< H, L (3), P (3), barycentre (3)
  static constexpr int state_error_count = 20;     ///< heliocentric positions (15), phases (5)

  /// G, the masses, the least distance; what follows (recentre) concerns the start.
  explicit OuterSolarSystem(std::span<T const> parameters)
      : gravitational_constant_(parameters[0]), collision_distance_(parameters[bodies + 1]) {
    std::copy_n(parameters.begin() + 1, bodies, masses_.begin());
  }

  template <Real U>
  OuterSolarSystem<U> in() const {
    std::array<U, bodies + 2> numbers;
    numbers[0] = U(gravitational_constant_);
    for (std::size_t i = 0; i < bodies; ++i) numbers[i + 1] = U(masses_[i]);
    numbers[bodies + 1] = U(collision_distance_);
    return OuterSolarSystem<U>(std::span<U const>(numbers));
  }

  std::array<T, bodies> const& masses() const { return masses_; }

  Part velocity(Part const& v) const { return v; }

  /// Pair by pair: 15 × 25 operations, of them a root and a division each. The Sun comes last, so that the small attractions
  /// are summed before they are added to a large one.
  Part force(Part const& q) const {
    Part force{};
    for (std::size_t i = bodies - 1; i-- > 0;)
      for (std::size_t j = i + 1; j < bodies; ++j) {
        auto const pair = pair_of(q, i, j);
        auto const& d = pair.difference;
        T const pull = select(pair.distance > collision_distance_,
                              T(gravitational_constant_ / (pair.distance2 * pair.distance)), not_a_number());
        T const on_i = masses_[j] * pull, on_j = masses_[i] * pull;
        for (std::size_t c = 0; c < 3; ++c) {
          force[3 * i + c] = force[3 * i + c] + on_i * d[c];
          force[3 * j + c] = force[3 * j + c] - on_j * d[c];
        }
      }
    return force;
  }

  State rate(State const& y) const { return {y.p, force(y.q)}; }

  /// H = ½ Σ mᵢ|vᵢ|² − G Σ mᵢmⱼ/|qⱼ − qᵢ|
  T energy(State const& y) const {
    T twice_kinetic = T(0), attraction = T(0);
    for (std::size_t i = 0; i < bodies; ++i) {
      twice_kinetic = twice_kinetic + masses_[i] * squared_norm(vector(y.p, i));
      for (std::size_t j = i + 1; j < bodies; ++j)
        attraction = attraction + masses_[i] * masses_[j] / pair_of(y.q, i, j).distance;
    }
    return twice_kinetic / T(2) - gravitational_constant_ * attraction;
  }

  /// L = Σ mᵢ qᵢ × vᵢ
  Vector3<T> angular_momentum(State const& y) const {
    return weighted_sum([&](std::size_t i) { return cross(vector(y.q, i), vector(y.p, i)); });
  }
  /// P = Σ mᵢvᵢ
  Vector3<T> linear_momentum(State const& y) const {
    return weighted_sum([&](std::size_t i) { return vector(y.p, i); });
  }
  /// Σ mᵢqᵢ / Σ mᵢ. It rests where P = 0. Its uniform motion is not taken off: that is what shows a frame which drifts.
  Vector3<T> barycentre(State const& y) const {
    auto const sum = weighted_sum([&](std::size_t i) { return vector(y.q, i); });
    T total = masses_[0];
    for (std::size_t i = 1; i < bodies; ++i) total = total + masses_[i];
    return {sum[0] / total, sum[1] / total, sum[2] / total};
  }

  std::array<T, first_integral_count> first_integrals(State const& y) const {
    auto const l = angular_momentum(y), p = linear_momentum(y), b = barycentre(y);
    return {energy(y), l[0], l[1], l[2], p[0], p[1], p[2], b[0], b[1], b[2]};
  }

  /// |H|, |L| and Σ mᵢ|vᵢ| of the start, 1 where they are 0; 1 AU for the barycentre.
  std::array<T, first_integral_count> first_integral_scales(State const& start) const {
    using math::abs;
    using math::sqrt;
    T momenta = T(0);
    for (std::size_t i = 0; i < bodies; ++i) momenta = momenta + masses_[i] * T(sqrt(squared_norm(vector(start.p, i))));
    T const l = or_one(T(sqrt(squared_norm(angular_momentum(start))))), p = or_one(momenta);
    return {or_one(T(abs(energy(start)))), l, l, l, p, p, p, T(1), T(1), T(1)};
  }

  /// The planets' positions relative to the Sun, less the reference's, then the time by which each is ahead along its orbit:
  /// ⟨d, ẋ*⟩ / |ẋ*|² with the heliocentric velocity ẋ*.
  std::array<T, state_error_count> state_errors(State const& y, State const& reference) const {
    std::array<T, state_error_count> errors{};
    for (std::size_t i = 1; i < bodies; ++i) {
      auto const x = pair_of(y.q, 0, i).difference, x_reference = pair_of(reference.q, 0, i).difference;
      auto const speed = pair_of(reference.p, 0, i).difference;
      auto const d = difference(x, x_reference);
      std::copy_n(d.begin(), 3, errors.begin() + static_cast<std::ptrdiff_t>(3 * (i - 1)));
      errors[3 * (bodies - 1) + (i - 1)] = time_ahead(inner_product(d, speed), inner_product(speed, speed));
    }
    return errors;
  }

  Failure failure(State const& y, int l) const {
    bool collided = false;
    for (std::size_t i = 0; i < bodies; ++i)
      for (std::size_t j = i + 1; j < bodies; ++j)
        collided = collided || is_set(pair_of(y.q, i, j).distance <= collision_distance_, l);
    return collided ? Failure::collision : Failure::none;
  }

 private:
  static T not_a_number() { return std::numeric_limits<T>::quiet_NaN(); }

  static Vector3<T> vector(Part const& part, std::size_t i) { return {part[3 * i], part[3 * i + 1], part[3 * i + 2]}; }

  /// From body i to body j. 9 operations, of them a root, where all of it is used.
  struct Pair {
    std::array<T, 3> difference;
    T distance2, distance;
  };
  static Pair pair_of(Part const& part, std::size_t i, std::size_t j) {
    using math::sqrt;
    std::array<T, 3> const d{part[3 * j] - part[3 * i], part[3 * j + 1] - part[3 * i + 1],
                             part[3 * j + 2] - part[3 * i + 2]};
    T const distance2 = inner_product(d, d);
    return {d, distance2, sqrt(distance2)};
  }

  /// Σ mᵢ aᵢ
  template <class F>
  Vector3<T> weighted_sum(F of_body) const {
    Vector3<T> sum{T(0), T(0), T(0)};
    for (std::size_t i = 0; i < bodies; ++i) {
      auto const a = of_body(i);
      for (int c = 0; c < 3; ++c) sum[c] = sum[c] + masses_[i] * a[c];
    }
    return sum;
  }

  T gravitational_constant_, collision_distance_;
  std::array<T, bodies> masses_;
};

inline std::optional<std::string> outer_solar_system_complaint(FieldValues const& values) {
  if (auto complaint = finite_complaint(values)) return complaint;
  if (auto complaint = outer_solar_system_complaint_of_parameters(values)) return complaint;
  return outer_solar_system_complaint_of_distances(values);
}

/// The names of a vector's components for each body from `first`: sun-x …
inline std::vector<std::string> names_of_outer_bodies(std::size_t first, std::string const& prefix) {
  std::vector<std::string> names;
  for (std::size_t i = first; i < outer_bodies; ++i)
    for (char const* axis : {"x", "y", "z"}) names.push_back(outer_body_names[i] + ('-' + prefix) + axis);
  return names;
}

inline std::vector<Quantity> quantities_of_outer_solar_system() {
  using Kind = Quantity::Kind;
  auto const vector = [](std::string const& name, std::string const& unit, std::string const& help) {
    return Quantity{name, {name + "-x", name + "-y", name + "-z"}, unit, Kind::integral, false, help};
  };
  Quantity phase{"phase", {}, "day", Kind::state, false, "by how many days each planet is ahead along its orbit"};
  for (std::size_t i = 1; i < outer_bodies; ++i)
    phase.components.push_back(std::string("phase-") + outer_body_names[i]);
  return {
      energy_quantity("H; error relative to |H(0)|"),
      vector("angular-momentum", "relative", "L = sum m q x v; error relative to |L(0)|"),
      vector("linear-momentum", "relative", "P = sum m v; error relative to the start's sum m |v|"),
      vector("barycentre", "AU", "sum m q / sum m since the start: rests where recentre = 1, else moves with P"),
      {"state", names_of_outer_bodies(1, ""), "AU", Kind::state, false, "heliocentric positions, less the reference's"},
      phase};
}

inline SystemDescription describe_outer_solar_system() {
  auto const list = [](auto const& numbers) { return std::vector<double>(numbers.begin(), numbers.end()); };
  auto components = names_of_outer_bodies(0, "");
  auto const velocities = names_of_outer_bodies(0, "v");
  components.insert(components.end(), velocities.begin(), velocities.end());
  return {"outer_solar_system",
          "outer solar system: the Sun, Jupiter, Saturn, Uranus, Neptune, Pluto",
          {{"gravitational-constant", 1, true, "AU^3 / (solar mass day^2)", "G, > 0", {outer_gravitational_constant}},
           {"masses", 6, true, "solar mass", "Sun with inner planets, Jupiter ... Pluto", list(outer_masses)},
           {"collision-distance",
            1,
            true,
            "AU",
            "nearer to one another bodies have collided: a member ends there",
            {0.005}},
           {"recentre", 1, true, "1", "1: the start is moved into the frame of the barycentre; 0: as given", {1}},
           {"position", 18, false, "AU", "x, y, z of each body, Sun first", list(outer_positions)},
           {"velocity", 18, false, "AU / day", "likewise", list(outer_velocities)}},
          quantities_of_outer_solar_system(),
          components,
          6 * outer_bodies,
          false,
          outer_solar_system_complaint,
          project_outer_solar_system,
          outer_solar_system_warning,
          {3, 4},
          10};
}

}  // namespace brouwer
