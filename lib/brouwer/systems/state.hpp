#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <boost/multiprecision/eigen.hpp>

#include <brouwer/scalar/exact.hpp>
#include <brouwer/scalar/real.hpp>

namespace brouwer {

template <Real T>
using Vector3 = Eigen::Matrix<T, 3, 1>;

template <Real T>
using Quaternion = Eigen::Quaternion<T>;

/// A state whose increments can be added: it hands its components, and those of its companions, to a
/// function, one by one and in the same order.
template <class S>
concept State = std::copyable<S> && Real<typename S::Scalar> && requires(S a, S const b) {
  for_components([](auto&, auto const&) {}, a, b);
};

/// value + increment, component by component.
template <State S>
S sum(S value, S const& increment) {
  for_components([](auto& a, auto const& d) { a = a + d; }, value, increment);
  return value;
}

/// A state together with what rounding cost it so far: the state that is meant is value + residue.
/// Compensated summation belongs to the state, so that every integrator with an increment has it.
template <State S>
struct Compensated {
  using Scalar = typename S::Scalar;
  S value, residue;

  explicit Compensated(S const& start) : value(start), residue(start) {
    for_components([](auto& r, auto const&) { r = Scalar(0); }, residue, start);
  }

  /// Adds an increment; what is lost is carried to the next (W. Kahan, Comm. ACM 8 (1965) 40; O. Møller,
  /// BIT 5 (1965) 37). two_sum rather than fast_two_sum: a component that crosses zero is smaller than its increment.
  void add(S const& increment) {
    for_components(
        [](Scalar& a, Scalar& carried, Scalar const& d) {
          auto const next = two_sum(a, carried + d);
          a = next.value;
          carried = next.error;
        },
        value, residue, increment);
  }
};

}  // namespace brouwer
