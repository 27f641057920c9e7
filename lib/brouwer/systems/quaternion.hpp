#pragma once
#include <brouwer/special/trigonometric.hpp>
#include <brouwer/systems/state.hpp>

namespace brouwer {

/// Lane by lane.
template <Real T>
Vector3<T> select_vector(Mask<T> const& mask, Vector3<T> const& yes, Vector3<T> const& no) {
  return {select(mask, yes[0], no[0]), select(mask, yes[1], no[1]), select(mask, yes[2], no[2])};
}

/// max |aⱼ − bⱼ| of vectors close to one another
template <Real T>
Leading<T> largest_difference(Vector3<T> const& a, Vector3<T> const& b) {
  using math::abs;
  using L = Leading<T>;
  L const d1 = abs(leading_difference<T>(a[0], b[0])), d2 = abs(leading_difference<T>(a[1], b[1])),
          d3 = abs(leading_difference<T>(a[2], b[2]));
  return larger(larger(d1, d2), d3);
}

/// Hamilton's product p ⊗ q. Written out: Eigen's own changes its order of operations with the instruction set.
template <Real T>
Quaternion<T> hamilton_product(Quaternion<T> const& p, Quaternion<T> const& q) {
  return {p.w() * q.w() - p.x() * q.x() - p.y() * q.y() - p.z() * q.z(),
          p.w() * q.x() + p.x() * q.w() + p.y() * q.z() - p.z() * q.y(),
          p.w() * q.y() + p.y() * q.w() + p.z() * q.x() - p.x() * q.z(),
          p.w() * q.z() + p.z() * q.w() + p.x() * q.y() - p.y() * q.x()};
}

template <Real T>
Quaternion<T> conjugate(Quaternion<T> const& q) {
  return {q.w(), -q.x(), -q.y(), -q.z()};
}

template <Real T>
T squared_norm(Quaternion<T> const& q) {
  return q.w() * q.w() + q.x() * q.x() + q.y() * q.y() + q.z() * q.z();
}

template <Real T>
T squared_norm(Vector3<T> const& v) {
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

template <Real T>
Vector3<T> cross(Vector3<T> const& a, Vector3<T> const& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Q(q) v for the rotation of any q ≠ 0, not only of a unit quaternion: (q ⊗ (0, v) ⊗ q*) / |q|².
template <Real T>
Vector3<T> rotated(Quaternion<T> const& q, Vector3<T> const& v) {
  auto const image = hamilton_product(hamilton_product(q, Quaternion<T>(T(0), v[0], v[1], v[2])), conjugate(q));
  T const n = squared_norm(q);
  return {image.x() / n, image.y() / n, image.z() / n};
}

/// The rotation vector (radians) of a quaternion, of length 0 … π: q and −q are the same rotation.
template <Real T>
Vector3<T> rotation_vector(Quaternion<T> const& q) {
  using math::sqrt;
  T const length = sqrt(q.x() * q.x() + q.y() * q.y() + q.z() * q.z());
  T const side = sign_of(q.w());
  T const factor = select(
      length > T(0), T(2) * side * arctangent(length, side * q.w()) / select(length > T(0), length, T(1)), T(2) * side);
  return {factor * q.x(), factor * q.y(), factor * q.z()};
}

}  // namespace brouwer
