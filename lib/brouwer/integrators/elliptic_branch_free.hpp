#pragma once
#include <brouwer/integrators/elliptic_base.hpp>

namespace brouwer {

/// What the branch-free elliptic integrators share: the addition step (addition_step.hpp) and, in stages, the attitude.
template <Real T>
class EllipticByAddition : public EllipticBase<T> {
 public:
  using State = RigidBodyState<T>;
  static constexpr bool runs_in_lanes = true;
  static constexpr int stages = 3;

  /// One step on its way.
  struct Work {
    HalfStep<T> half;
    Vector3<T> momentum;  ///< after the step, or its change
    Quaternion<T> turn;   ///< of the attitude, less one
  };

 protected:
  explicit EllipticByAddition(Setup<RigidBody<T>> const& setup)
      : EllipticBase<T>(setup), addition_(this->constants(), Wider<T>(setup.step), setup.start.momentum) {}

  AdditionStep<T> const& addition() const { return addition_; }

  void turn(State const& s, Vector3<T> const& change, Work& w) const {
    if (this->attitude()) w.turn = this->attitude()->turn_less_one(w.half, s.momentum, change);
  }

  template <class Stepper>
  static State all_stages(Stepper const& step, State const& s) {
    Work w;
    step.template stage<0>(s, w);
    step.template stage<1>(s, w);
    step.template stage<2>(s, w);
    return step.finish(s, w);
  }

 private:
  AdditionStep<T> addition_;
};

/// The elliptic solution by the branch-free addition step, in value form. P and R near 1 are the same rounded numbers in
/// every step: persistent slopes.
template <Real T>
class EllipticBranchFree : public EllipticByAddition<T> {
 public:
  using State = RigidBodyState<T>;
  using Work = typename EllipticByAddition<T>::Work;

  explicit EllipticBranchFree(Setup<RigidBody<T>> const& setup) : EllipticByAddition<T>(setup) {}

  template <int i>
  void stage(State const& s, Work& w) const {
    auto const& y = s.momentum;
    if constexpr (i == 0) w.half = this->addition().half(y);
    if constexpr (i == 1) w.momentum = this->addition().next(w.half, y);
    if constexpr (i == 2) this->turn(s, {w.momentum[0] - y[0], w.momentum[1] - y[1], w.momentum[2] - y[2]}, w);
  }
  State finish(State const& s, Work const& w) const {
    if (!this->attitude()) return {w.momentum, s.attitude};
    auto const dq = hamilton_product(s.attitude, w.turn);
    auto const& q = s.attitude;
    return {w.momentum, {q.w() + dq.w(), q.x() + dq.x(), q.y() + dq.y(), q.z() + dq.z()}};
  }

  State operator()(State const& s) const { return this->all_stages(*this, s); }
};

/// The same step as an increment. Its rounding errors are of the size of the increment: a random walk, which compensation
/// makes a hundred times smaller at h = 0.01 (studies/elliptic-forms.toml).
template <Real T>
class EllipticIncrement : public EllipticByAddition<T> {
 public:
  using State = RigidBodyState<T>;
  using Work = typename EllipticByAddition<T>::Work;

  explicit EllipticIncrement(Setup<RigidBody<T>> const& setup) : EllipticByAddition<T>(setup) {}

  template <int i>
  void stage(State const& s, Work& w) const {
    if constexpr (i == 0) w.half = this->addition().half(s.momentum);
    if constexpr (i == 1) w.momentum = this->addition().increment(w.half, s.momentum);
    if constexpr (i == 2) this->turn(s, w.momentum, w);
  }
  State finish(State const& s, Work const& w) const {
    if (!this->attitude()) return {w.momentum, {T(0), T(0), T(0), T(0)}};
    return {w.momentum, hamilton_product(s.attitude, w.turn)};
  }

  State increment(State const& s) const { return this->all_stages(*this, s); }
};

}  // namespace brouwer
