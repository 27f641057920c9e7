#pragma once
#include <array>
#include <span>

#include <brouwer/systems/state.hpp>

namespace brouwer {

/// A point in the phase space of n degrees of freedom: coordinates q and what moves them, p (momenta, or velocities where
/// the system says so).
template <Real T, int n>
struct PhaseState {
  using Scalar = T;
  static constexpr int degrees = n;
  using Part = std::array<T, n>;
  Part q{}, p{};

  /// q₁ … qₙ, p₁ … pₙ
  static PhaseState from_components(std::span<T const> c) {
    PhaseState s;
    for (std::size_t i = 0; i < n; ++i) s.q[i] = c[i], s.p[i] = c[n + i];
    return s;
  }
};

template <class S>
concept OfPhaseSpace = std::same_as<std::remove_const_t<S>, PhaseState<typename S::Scalar, S::degrees>>;

template <class F, OfPhaseSpace S, class... Others>
void for_components(F f, S& a, Others&... others) {
  for (std::size_t i = 0; i < S::degrees; ++i) f(a.q[i], others.q[i]...);
  for (std::size_t i = 0; i < S::degrees; ++i) f(a.p[i], others.p[i]...);
}

}  // namespace brouwer
