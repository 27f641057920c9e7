#pragma once
#include <brouwer/integrators/elliptic_base.hpp>

namespace brouwer {

/// What the branch-free elliptic integrators share: the addition step (addition_step.hpp) and, with its half step, the
/// attitude.
template <Real T>
class EllipticByAddition : public EllipticBase<T> {
 public:
  using State = RigidBodyState<T>;
  static constexpr bool runs_in_lanes = true;
  static constexpr int stages = 3;

  /// One step on its way (StagedStep).
  struct Work {
    HalfStep<T> half;
    Vector3<T> momentum;  ///< after the step, or its change
    Quaternion<T> turn;   ///< of the attitude, less one
  };

 protected:
  explicit EllipticByAddition(Setup<RigidBody<T>> const& setup)
      : EllipticBase<T>(setup), addition_(this->constants(), Wider<T>(setup.step), setup.start.momentum) {}

  AdditionStep<T> const& addition() const { return addition_; }

  /// Added to an attitude it leaves every bit: −0.
  static Quaternion<T> no_turn() { return {-T(0), -T(0), -T(0), -T(0)}; }

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

  State operator()(State s) const {
    auto const half = this->addition().half(s.momentum);
    auto const next = this->addition().next(half, s.momentum);
    if (this->attitude()) turn(s.attitude, this->attitude()->turn_less_one(half, s.momentum, less(next, s.momentum)));
    return {next, s.attitude};
  }

  template <int i>
  void stage(State const& s, Work& w) const {
    if constexpr (i == 0) w.half = this->addition().half(s.momentum);
    if constexpr (i == 1) w.momentum = this->addition().next(w.half, s.momentum);
    if constexpr (i == 2)
      if (this->attitude()) w.turn = this->attitude()->turn_less_one(w.half, s.momentum, less(w.momentum, s.momentum));
  }
  void finish(State& s, Work const& w) const {
    s.momentum = w.momentum;
    if (this->attitude()) turn(s.attitude, w.turn);
  }

 private:
  static Vector3<T> less(Vector3<T> const& a, Vector3<T> const& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static void turn(Quaternion<T>& q, Quaternion<T> const& turn_less_one) {
    auto const dq = hamilton_product(q, turn_less_one);
    q = {q.w() + dq.w(), q.x() + dq.x(), q.y() + dq.y(), q.z() + dq.z()};
  }
};

/// The same step as an increment. Its rounding errors are of the size of the increment: a random walk, which compensation
/// makes a hundred times smaller at h = 0.01 (studies/elliptic-forms.toml).
template <Real T>
class EllipticIncrement : public EllipticByAddition<T> {
 public:
  using State = RigidBodyState<T>;
  using Work = typename EllipticByAddition<T>::Work;

  explicit EllipticIncrement(Setup<RigidBody<T>> const& setup) : EllipticByAddition<T>(setup) {}

  State increment(State const& s) const {
    auto const half = this->addition().half(s.momentum);
    auto const dy = this->addition().increment(half, s.momentum);
    if (!this->attitude()) return {dy, this->no_turn()};
    return {dy, hamilton_product(s.attitude, this->attitude()->turn_less_one(half, s.momentum, dy))};
  }

  template <int i>
  void stage(State const& s, Work& w) const {
    if constexpr (i == 0) w.half = this->addition().half(s.momentum);
    if (!this->attitude()) return;
    if constexpr (i == 1) w.momentum = this->addition().increment(w.half, s.momentum);
    if constexpr (i == 2) w.turn = this->attitude()->turn_less_one(w.half, s.momentum, w.momentum);
  }
  /// @param y  the state, or the state with its residue
  template <class Y>
  void finish(Y& y, Work const& w) const {
    if (this->attitude()) {
      add(y, State{w.momentum, hamilton_product(value_of(y).attitude, w.turn)});
      return;
    }
    auto const dy = this->addition().increment(w.half, value_of(y).momentum);
    if constexpr (std::same_as<Y, State>)
      y.momentum = {y.momentum[0] + dy[0], y.momentum[1] + dy[1], y.momentum[2] + dy[2]};
    else
      add(y, State{dy, this->no_turn()});
  }
};

}  // namespace brouwer
