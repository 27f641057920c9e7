#pragma once
#include <brouwer/integrators/elliptic_base.hpp>

namespace brouwer {

/// The elliptic solution by the branch-free addition step (addition_step.hpp), in value form. P and R near 1 are the same
/// rounded numbers in every step: persistent slopes.
template <Real T>
class EllipticBranchFree : public EllipticBase<T> {
 public:
  using State = RigidBodyState<T>;
  static constexpr bool runs_in_lanes = true;

  explicit EllipticBranchFree(Setup<RigidBody<T>> const& setup)
      : EllipticBase<T>(setup), step_(this->constants(), Wider<T>(setup.step), setup.start.momentum) {}

  State operator()(State const& s) const {
    return this->with_momentum(s, step_.next(step_.half(s.momentum), s.momentum));
  }

 private:
  AdditionStep<T> step_;
};

/// The same step as an increment. Its rounding errors are of the size of the increment: a random walk, which compensation
/// makes a hundred times smaller at h = 0.01 (studies/elliptic-forms.toml).
template <Real T>
class EllipticIncrement : public EllipticBase<T> {
 public:
  using State = RigidBodyState<T>;
  static constexpr bool runs_in_lanes = true;

  explicit EllipticIncrement(Setup<RigidBody<T>> const& setup)
      : EllipticBase<T>(setup), step_(this->constants(), Wider<T>(setup.step), setup.start.momentum) {}

  State increment(State const& s) const { return this->change(s, step_.increment(step_.half(s.momentum), s.momentum)); }

 private:
  AdditionStep<T> step_;
};

}  // namespace brouwer
