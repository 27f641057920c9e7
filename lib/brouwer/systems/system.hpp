#pragma once
#include <array>
#include <span>

#include <brouwer/systems/failure.hpp>
#include <brouwer/systems/state.hpp>

namespace brouwer {

/// What the ensemble asks of a system, a template over the scalar: it is made from the numbers of its description's
/// parameters, goes over into other arithmetics, and observes a state. Errors of a state are given in the order of the
/// description's quantities (description.hpp), component by component.
template <class S>
concept ObservableSystem = Real<typename S::Scalar> && State<typename S::State> &&
    std::constructible_from<S, std::span<typename S::Scalar const>> &&
    requires(S const system, typename S::State const y) {
  { system.template in<typename S::Scalar>() } -> std::same_as<S>;
  { system.first_integral_scales(y) } -> std::same_as<std::array<typename S::Scalar, S::first_integral_count>>;
  { system.state_errors(y, y) } -> std::same_as<std::array<typename S::Scalar, S::state_error_count>>;
};

/// A system of ordinary differential equations ẏ = rate(y). The rate has the type of a state.
template <class S>
concept FieldSystem = ObservableSystem<S> && requires(S const system, typename S::State const y) {
  { system.rate(y) } -> std::same_as<typename S::State>;
};

/// q̇ = velocity(p), ṗ = force(q): H(q, p) = T(p) + V(q), or the same in velocities.
template <class S>
concept SeparableSystem = FieldSystem<S> && requires(S const system, typename S::State::Part const part) {
  { system.velocity(part) } -> std::same_as<typename S::State::Part>;
  { system.force(part) } -> std::same_as<typename S::State::Part>;
};

/// The first integrals of a state; h is told to systems with integrals that only a method with that step conserves
/// (truncated modified Hamiltonians).
template <class S>
auto first_integrals(S const& system, typename S::State const& y, typename S::Scalar const& h) {
  if constexpr (requires { system.first_integrals(y, h); })
    return system.first_integrals(y, h);
  else
    return system.first_integrals(y);
}

}  // namespace brouwer
