#pragma once
#include <brouwer/systems/henon_heiles.hpp>
#include <brouwer/systems/phase_state.hpp>
#include <brouwer/systems/system.hpp>

// Small systems in which the methods for any system are tested.
namespace brouwer::testing_support {

/// What the tests here never ask a system for.
template <class T, int n>
struct Unobserved {
  using Scalar = T;
  using State = PhaseState<T, n>;
  using Part = typename State::Part;
  static constexpr int first_integral_count = 0, state_error_count = 0;
  std::array<T, 0> first_integral_scales(State const&) const { return {}; }
  std::array<T, 0> state_errors(State const&, State const&) const { return {}; }
};

/// H = ½|p|²(1 + c|q|²): not separable; conserves q₁p₂ − q₂p₁, which is quadratic.
template <class T>
struct Geodesics : Unobserved<T, 2> {
  using State = typename Unobserved<T, 2>::State;
  template <class U>
  using In = Geodesics<U>;
  T curvature;

  explicit Geodesics(std::span<T const> parameters) : curvature(parameters[0]) {}
  template <class U>
  Geodesics<U> in() const {
    std::array<U, 1> const parameters{U(curvature)};
    return Geodesics<U>(std::span<U const>(parameters));
  }
  State rate(State const& y) const {
    T const stretch = T(1) + curvature * (y.q[0] * y.q[0] + y.q[1] * y.q[1]);
    T const pull = curvature * (y.p[0] * y.p[0] + y.p[1] * y.p[1]);
    return {{stretch * y.p[0], stretch * y.p[1]}, {-(pull * y.q[0]), -(pull * y.q[1])}};
  }
};

/// q̇ = λq, with a p that rests: a fixed-point iteration contracts by what is expected of it.
template <class T>
struct Growth : Unobserved<T, 1> {
  using State = typename Unobserved<T, 1>::State;
  template <class U>
  using In = Growth<U>;
  T lambda;

  explicit Growth(std::span<T const> parameters) : lambda(parameters[0]) {}
  template <class U>
  Growth<U> in() const {
    std::array<U, 1> const parameters{U(lambda)};
    return Growth<U>(std::span<U const>(parameters));
  }
  State rate(State const& y) const { return {{lambda * y.q[0]}, {T(0)}}; }
};

/// A fall on a centre of attraction: there is no force at q ≤ 0, and the system knows why.
template <class T>
struct Fall : Unobserved<T, 1> {
  using State = typename Unobserved<T, 1>::State;
  using Part = typename Unobserved<T, 1>::Part;
  template <class U>
  using In = Fall<U>;

  explicit Fall(std::span<T const> = {}) {}
  template <class U>
  Fall<U> in() const {
    return Fall<U>();
  }
  Part velocity(Part const& p) const { return p; }
  Part force(Part const& q) const {
    return {select(q[0] > T(0), T(T(-1) / (q[0] * q[0])), T(std::numeric_limits<T>::quiet_NaN()))};
  }
  State rate(State const& y) const { return {velocity(y.p), force(y.q)}; }
  Failure failure(State const& y, int l) const {
    return is_set(y.q[0] <= T(0), l) ? Failure::collision : Failure::none;
  }
};

/// Rates that are bounded everywhere: with a large step fixed-point iteration goes on and on, and never diverges.
template <class T>
struct Bounded : Unobserved<T, 1> {
  using State = typename Unobserved<T, 1>::State;
  using Part = typename Unobserved<T, 1>::Part;
  template <class U>
  using In = Bounded<U>;

  explicit Bounded(std::span<T const> = {}) {}
  template <class U>
  Bounded<U> in() const {
    return Bounded<U>();
  }
  Part velocity(Part const& p) const { return {p[0] / (T(1) + p[0] * p[0])}; }
  Part force(Part const& q) const { return {-(q[0] / (T(1) + q[0] * q[0]))}; }
  State rate(State const& y) const { return {velocity(y.p), force(y.q)}; }
};

}  // namespace brouwer::testing_support
