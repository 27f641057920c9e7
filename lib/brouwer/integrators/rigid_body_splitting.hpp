#pragma once
#include <brouwer/integrators/composition.hpp>
#include <brouwer/integrators/stepper.hpp>
#include <brouwer/systems/rigid_body.hpp>

namespace brouwer {

/// Three rotations and their compositions: with H = H₁ + H₂ + H₃, Hⱼ = yⱼ²/(2Iⱼ), the flow φⱼ of Hⱼ over t turns the body
/// about its axis j by the angle tyⱼ/Iⱼ, which leaves yⱼ as it is. The base method, symmetric, symplectic, of order 2,
///     Φ(h) = φ₁(h/2) φ₂(h/2) φ₃(h) φ₂(h/2) φ₁(h/2)
/// (R. I. McLachlan, Phys. Rev. Lett. 71 (1993) 3043; S. Reich, Physica D 76 (1994) 375) is composed with the weights of any
/// Composition; neighbours about axis 1 are one rotation: 4s + 1 in a step of s stages. C and Qy are conserved exactly in
/// exact arithmetic, H to the order of the method.
///
/// A step is given as its change. With s = sin θ/2, c = cos θ/2 a rotation changes y by
///     2s(cy₃ − sy₂)    −2s(cy₂ + sy₃)        about axis 1 (and cyclic)
/// and the turn 1 + t so far by (1 + t) ⊗ (c − 1, s e₁): no change is the difference of large numbers.
template <Real T>
class RigidBodySplitting {
 public:
  using Scalar = T;
  using System = RigidBody<T>;
  using State = RigidBodyState<T>;
  static constexpr bool runs_in_lanes = true;

  RigidBodySplitting(Setup<System> const& setup, Composition const& composition) : attitude_(setup.whole_state) {
    using W = Wider<T>;
    auto const I = setup.system.template in<W>().inertia();
    W before = W(0);
    for (W const& weight : composition_weights<W>(composition)) {
      W const time = weight * W(setup.step), quarter = time / W(4);
      stages_.push_back({rounded<T>(W((before + quarter) / I[0])), rounded<T>(W(quarter / I[1])),
                         rounded<T>(W((quarter + quarter) / I[2]))});
      before = quarter;
    }
    last_ = rounded<T>(W(before / I[0]));
  }

  State increment(State const& s) const {
    Change change{};
    for (auto const& stage : stages_) {
      rotate<0>(stage.first, s.momentum, change);
      rotate<1>(stage.second, s.momentum, change);
      rotate<2>(stage.third, s.momentum, change);
      rotate<1>(stage.second, s.momentum, change);
    }
    rotate<0>(last_, s.momentum, change);
    if (!attitude_) return {change.momentum, {T(0), T(0), T(0), T(0)}};
    return {change.momentum, hamilton_product(s.attitude, change.turn)};
  }

 private:
  /// Half the angles of its rotations over the momentum about their axes: t/(2Iⱼ). The first takes in what the stage
  /// before leaves to do about axis 1.
  struct Stage {
    T first, second, third;
  };

  /// What a step has changed so far: y, and the turn less one.
  struct Change {
    Vector3<T> momentum{T(0), T(0), T(0)};
    Quaternion<T> turn{T(0), T(0), T(0), T(0)};
  };

  template <int axis>
  void rotate(T const& half_angle_per_momentum, Vector3<T> const& start, Change& change) const {
    constexpr int j = (axis + 1) % 3, k = (axis + 2) % 3;
    auto& d = change.momentum;
    T const y_j = start[j] + d[j], y_k = start[k] + d[k];
    auto const half = sine_cosine(T(half_angle_per_momentum * (start[axis] + d[axis])));
    T const twice = half.sin + half.sin;
    d[j] = d[j] + twice * (half.cos * y_k - half.sin * y_j);
    d[k] = d[k] - twice * (half.cos * y_j + half.sin * y_k);
    if (attitude_) turn_about<axis>(half, change.turn);
  }

  /// t + (1 + t) ⊗ (c − 1, s e)
  template <int axis>
  static void turn_about(SineCosine<T> const& half, Quaternion<T>& t) {
    constexpr int j = (axis + 1) % 3, k = (axis + 2) % 3;
    T const s = half.sin, less_one = cosine_less_one(half);
    auto& v = t.coeffs();  // x, y, z, w
    T const along = v[axis], t_j = v[j], t_k = v[k], w = v[3];
    v[3] = w + (less_one + (w * less_one - along * s));
    v[axis] = along + (s + (along * less_one + w * s));
    v[j] = t_j + (t_j * less_one + t_k * s);
    v[k] = t_k + (t_k * less_one - t_j * s);
  }

  /// c − 1 = −s²/(1 + c)
  static T cosine_less_one(SineCosine<T> const& angle) {
    auto const forward = angle.cos > T(0);
    return select(forward, -squared(angle.sin) / (T(1) + select(forward, angle.cos, T(0))), angle.cos - T(1));
  }

  bool attitude_;
  std::vector<Stage> stages_;
  T last_;
};

/// The same with its composition in the type, as catalogues want it.
template <Real T, Composition const& composition>
class RigidBodySplittingBy : public RigidBodySplitting<T> {
 public:
  using Core = RigidBodySplitting<T>;
  static constexpr int order = composition.order;
  explicit RigidBodySplittingBy(Setup<RigidBody<T>> const& setup) : Core(setup, composition) {}
};

}  // namespace brouwer
