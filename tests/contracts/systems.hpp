#pragma once
#include <brouwer/systems/double_pendulum.hpp>
#include <brouwer/systems/double_well.hpp>
#include <brouwer/systems/henon_heiles.hpp>
#include <brouwer/systems/kepler.hpp>
#include <brouwer/systems/outer_solar_system.hpp>
#include <brouwer/systems/pendulum.hpp>
#include <brouwer/systems/rigid_body.hpp>
#include <brouwer/systems/system.hpp>
#include <gtest/gtest.h>

#include "tests/numbers.hpp"

// Every system, one line each: what is listed here keeps the promises of the contract tests.
namespace brouwer::testing_support {

/// A system's template and its description as a type, so that a test can put any scalar in.
template <template <class> class S, SystemDescription (*describe_)(), bool separable_>
struct SystemFamily {
  template <class T>
  using In = S<T>;
  static SystemDescription describe() { return describe_(); }
  static constexpr bool separable = separable_;
};

using Systems = testing::Types<                                     //
    SystemFamily<RigidBody, describe_rigid_body, false>,            //
    SystemFamily<HenonHeiles, describe_henon_heiles, true>,         //
    SystemFamily<DoubleWell, describe_double_well, true>,           //
    SystemFamily<Pendulum, describe_pendulum, true>,                //
    SystemFamily<Kepler, describe_kepler, true>,                    //
    SystemFamily<DoublePendulum, describe_double_pendulum, false>,  //
    SystemFamily<OuterSolarSystem, describe_outer_solar_system, true>>;

/// Values that a system must refuse, beside numbers that are none: one field of the standard ones changed.
struct RefusedValues {
  char const* system;
  char const* field;
  std::vector<double> values;
};

inline std::vector<RefusedValues> refused_values() {
  return {{"rigid_body", "inertia", {0.6, 0.8, 1.5}},
          {"rigid_body", "inertia", {0.8, 0.6, 1.0}},
          {"rigid_body", "attitude", {1, 0, 0, 0.1}},
          {"pendulum", "frequency", {0}},
          {"pendulum", "frequency", {-1}},
          {"kepler", "position", {0, 0}},
          {"kepler", "position", {5e-5, 0}},
          {"kepler", "collision-distance", {-1}},
          {"kepler", "collision-distance", {0.5}},
          {"double_pendulum", "length", {1, 0}},
          {"double_pendulum", "mass", {-1, 1}},
          {"double_pendulum", "gravity", {-9.81}},
          {"outer_solar_system", "gravitational-constant", {0}},
          {"outer_solar_system", "masses", {0, 1e-3, 1e-4, 1e-5, 1e-5, 1e-9}},
          {"outer_solar_system", "masses", {1, 1e-3, -1e-4, 1e-5, 1e-5, 1e-9}},
          {"outer_solar_system", "recentre", {2}},
          {"outer_solar_system", "position", std::vector<double>(18, 1)}};
}

/// What the standard values become as members of an ensemble: parameters within 2 %, the start within a tenth of its size.
inline FieldValues values_near_standard(SystemDescription const& system, Uniform& uniform) {
  FieldValues values;
  for (auto const& field : system.fields) {
    double size = 0;
    for (double number : field.standard) size = std::max(size, std::abs(number));
    for (double number : field.standard) {
      double const moved = field.parameter ? number * (1 + uniform(-0.02, 0.02))
                                           : number + (size > 0 ? size / 10 : 0.5) * uniform(-1, 1);
      values[field.name].push_back(field.name == "recentre" ? number : moved);
    }
  }
  if (system.project) system.project(values);
  return values;
}

inline FieldValues standard_values(SystemDescription const& system) {
  FieldValues values;
  for (auto const& field : system.fields) values[field.name] = field.standard;
  return values;
}

/// The numbers of the parameters, or of the start, in the order of the fields.
inline std::vector<double> numbers_of(SystemDescription const& system, FieldValues const& values, bool parameters) {
  std::vector<double> numbers;
  for (auto const& field : system.fields)
    if (field.parameter == parameters)
      numbers.insert(numbers.end(), values.at(field.name).begin(), values.at(field.name).end());
  return numbers;
}

/// A system and a state in the arithmetic T.
template <class S>
struct SystemCase {
  using T = typename S::Scalar;
  std::vector<T> parameters, numbers;
  S system;
  typename S::State state;

  SystemCase(SystemDescription const& description, FieldValues const& values)
      : parameters(converted(numbers_of(description, values, true))),
        numbers(converted(numbers_of(description, values, false))),
        system(std::span<T const>(parameters)),
        state(S::State::from_components(numbers)) {}

  static std::vector<T> converted(std::vector<double> const& doubles) {
    std::vector<T> result;
    for (double number : doubles) result.push_back(static_cast<T>(number));
    return result;
  }
};

/// y + εẏ
template <class State, class T>
State moved(State y, State const& rate, T const& e) {
  for_components([&](T& a, T const& r) { a = a + e * r; }, y, rate);
  return y;
}

template <class State>
auto components_of(State const& y) {
  std::vector<typename State::Scalar> components;
  for_components([&](auto const& c) { components.push_back(c); }, y);
  return components;
}

}  // namespace brouwer::testing_support
