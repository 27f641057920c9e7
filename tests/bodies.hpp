#pragma once
#include <array>
#include <brouwer/systems/rigid_body.hpp>
#include <vector>

// Rigid bodies and starts that the tests share.
namespace brouwer::testing_support {

/// Decimals in the arithmetic T: a body, a momentum and an attitude (normalised in T).
struct BodyCase {
  char const* name;
  std::array<double, 3> inertia, momentum;
  std::array<double, 4> attitude;

  template <class T>
  RigidBody<T> body() const {
    return RigidBody<T>(Vector3<T>{T(inertia[0]), T(inertia[1]), T(inertia[2])});
  }
  template <class T>
  RigidBodyState<T> start() const {
    using math::sqrt;
    Quaternion<T> const q{T(attitude[0]), T(attitude[1]), T(attitude[2]), T(attitude[3])};
    T const n = sqrt(squared_norm(q));
    return {{T(momentum[0]), T(momentum[1]), T(momentum[2])}, {q.w() / n, q.x() / n, q.y() / n, q.z() / n}};
  }
};

/// Both branches of the elliptic solution, both signs of the dn component.
inline std::vector<BodyCase> generic_bodies() {
  return {{"standard, dn on axis 1", {0.6, 0.8, 1.0}, {1.8, 0.4, -0.9}, {1, 0, 0, 0}},
          {"standard, dn on axis 3", {0.6, 0.8, 1.0}, {0.4, 0.3, -1.7}, {0.5, -0.5, 0.5, 0.5}},
          {"dn on axis 3, positive", {0.9, 1.1, 1.7}, {-0.6, 0.8, 1.9}, {0.1, 0.7, -0.2, 0.4}},
          {"dn on axis 1, negative", {0.5, 1.3, 1.6}, {-2.1, -0.7, 0.5}, {-0.3, 0.2, 0.9, 0.1}},
          {"slow and flat", {1.0, 2.0, 3.0}, {0.01, -0.02, 0.03}, {1, 1, 0, 0}}};
}

/// Symmetric bodies, a ball, rest on each axis, the separatrix, y = 0: where quotients of the formulas are 0/0.
inline std::vector<BodyCase> special_bodies() {
  return {{"I1 = I2", {0.7, 0.7, 1.0}, {0.9, -0.4, 1.1}, {1, 0, 0, 0}},
          {"I1 = I2, y3 = 0", {0.7, 0.7, 1.0}, {0.9, -0.4, 0}, {1, 0, 0, 0}},
          {"I1 = I2, on the axis", {0.7, 0.7, 1.0}, {0, 0, -1.3}, {1, 0, 0, 0}},
          {"I2 = I3", {0.6, 0.9, 0.9}, {-0.8, 0.5, 0.7}, {1, 0, 0, 0}},
          {"I2 = I3, y1 = 0", {0.6, 0.9, 0.9}, {0, 0.5, 0.7}, {1, 0, 0, 0}},
          {"ball", {1.0, 1.0, 1.0}, {0.3, -0.2, 0.8}, {1, 0, 0, 0}},
          {"rest on axis 1", {0.6, 0.8, 1.0}, {1.5, 0, 0}, {1, 0, 0, 0}},
          {"rest on axis 2", {0.6, 0.8, 1.0}, {0, -1.5, 0}, {1, 0, 0, 0}},
          {"rest on axis 3", {0.6, 0.8, 1.0}, {0, 0, 1.5}, {1, 0, 0, 0}},
          {"y = 0", {0.6, 0.8, 1.0}, {0, 0, 0}, {1, 0, 0, 0}},
          {"y3 = 0", {0.6, 0.8, 1.0}, {1.2, 0.5, 0}, {1, 0, 0, 0}},
          {"y1 = 0", {0.6, 0.8, 1.0}, {0, 0.5, 1.2}, {1, 0, 0, 0}},
          // c₁² = c₂² = 1/2 (of no real body) and |y₁| = |y₃|: k = 1 up to rounding
          {"separatrix", {2, 3, 6}, {1, 0.5, 1}, {1, 0, 0, 0}},
          {"separatrix, y2 = 0", {2, 3, 6}, {1, 0, -1}, {1, 0, 0, 0}},
          {"separatrix, cn < 0", {2, 3, 6}, {-1, 0.5, 1}, {1, 0, 0, 0}},
          {"flat body", {0.4, 0.6, 1.0}, {0.5, 1.0, -0.3}, {1, 0, 0, 0}}};
}

}  // namespace brouwer::testing_support
