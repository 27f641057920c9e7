#pragma once
#include <limits>

#include <brouwer/integrators/stepper.hpp>
#include <brouwer/systems/rigid_body.hpp>

namespace brouwer {

/// The discrete Moser–Veselov algorithm, order 2, symmetric, symplectic; conserves H, C and Qy exactly in exact
/// arithmetic. J. Moser, A. P. Veselov, Comm. Math. Phys. 139 (1991) 217; in quaternions E. Hairer, G. Vilmart,
/// J. Phys. A 39 (2006) 13225. With pⱼ = h yⱼ/(2Iⱼ) the step's rotation is (1, c₁, c₂, c₃)/√α, where
///     c₁ = α p₁ + (I₂−I₃)/I₁ c₂c₃ (and cyclic)      α = 1 + c₁² + c₂² + c₃²
/// is solved by fixed-point iteration in Gauss–Seidel order from c = p, until the iterate stands still or its
/// change, down to a few ulp, no longer shrinks; then
///     y₁' = y₁ + (4/(hα)) (I₂−I₃) c₂c₃ (and cyclic)      q' = q ⊗ (1, c)/√α.
/// Only two constants a component are rounded, η₁ = h/(2I₁) and κ₁ = (I₂−I₃)/I₁; the change is formed from them, as
/// 2κ₁c₂c₃/(αη₁). A third constant 4(I₂−I₃)/h would contradict them by some ε in every step, and the energy would drift
/// by ε⟨(y₁'−y₁)²⟩/I₁: small, but seen with compensation (−5·10⁻²⁰ per step at h = 0.1, t = −15, 64 members).
/// Where h is too large for the iteration to settle the increment is NaN: the member has failed.
template <Real T>
class Dmv2 {
 public:
  using Scalar = T;
  using System = RigidBody<T>;
  using State = RigidBodyState<T>;
  static constexpr int order = 2;

  explicit Dmv2(Setup<System> const& setup) : attitude_(setup.attitude) {
    using W = Wider<T>;
    auto const I = setup.system.template in<W>().inertia();
    W const h(setup.step);
    for (int j = 0; j < 3; ++j) {
      W const difference = I[(j + 1) % 3] - I[(j + 2) % 3];
      half_step_over_inertia_[j] = rounded<T>(W(h / (2 * I[j])));
      coupling_[j] = rounded<T>(W(difference / I[j]));
    }
  }

  State increment(State const& s) const {
    auto const& y = s.momentum;
    Rotation const r = solve(
        {half_step_over_inertia_[0] * y[0], half_step_over_inertia_[1] * y[1], half_step_over_inertia_[2] * y[2]});
    auto const& c = r.c;
    Vector3<T> const dy{change(0, c[1] * c[2], r.alpha), change(1, c[2] * c[0], r.alpha),
                        change(2, c[0] * c[1], r.alpha)};
    if (!attitude_) return {dy, {T(0), T(0), T(0), T(0)}};
    return {dy, attitude_increment(s.attitude, r)};
  }

  /// Iterations that a step from y takes, for tests and benchmarks.
  int iterations(Vector3<T> const& y) const {
    int count = 0;
    solve({half_step_over_inertia_[0] * y[0], half_step_over_inertia_[1] * y[1], half_step_over_inertia_[2] * y[2]},
          &count);
    return count;
  }

 private:
  struct Rotation {
    Vector3<T> c;
    T alpha;
  };

  static constexpr int most_iterations = 50 + 8 * significand_bits<T>;  // linear convergence, at worst 1/8 bit a turn

  Rotation solve(Vector3<T> const& p, int* count = nullptr) const {
    using math::abs;
    Vector3<T> c = p;
    T change = std::numeric_limits<T>::infinity();
    auto active = change > T(0);
    int i = 0;
    for (; i < most_iterations && any(active); ++i) {
      T const alpha = T(1) + squared_norm(c);
      T const c1 = alpha * p[0] + coupling_[0] * c[1] * c[2];
      T const c2 = alpha * p[1] + coupling_[1] * c[2] * c1;
      T const c3 = alpha * p[2] + coupling_[2] * c1 * c2;
      T const moved = larger(larger(abs(c1 - c[0]), abs(c2 - c[1])), abs(c3 - c[2]));
      c = select_vector<T>(active, {c1, c2, c3}, c);
      T const at_rounding = T(16) * epsilon<T>() * larger(larger(abs(c1), abs(c2)), abs(c3));
      active = both(active, both(moved > T(0), either((moved < change), (moved > at_rounding))));
      change = select(active, moved, change);
    }
    if (count) *count = i;
    T const settled = select(active, std::numeric_limits<T>::quiet_NaN(), T(1));
    return {c, settled * (T(1) + squared_norm(c))};
  }

  /// yⱼ' − yⱼ
  T change(int j, T const& product, T const& alpha) const {
    return T(2) * (coupling_[j] * product) / (alpha * half_step_over_inertia_[j]);
  }

  /// q ⊗ (1, c)/√α − q = q ⊗ (1 − √α, c)/√α, with 1 − √α = −|c|²/(1 + √α)
  static Quaternion<T> attitude_increment(Quaternion<T> const& q, Rotation const& r) {
    using math::sqrt;
    T const root = sqrt(r.alpha), less_one = -squared_norm(r.c) / (T(1) + root);
    return hamilton_product(q, Quaternion<T>(less_one / root, r.c[0] / root, r.c[1] / root, r.c[2] / root));
  }

  bool attitude_;
  Vector3<T> half_step_over_inertia_, coupling_;
};

}  // namespace brouwer
