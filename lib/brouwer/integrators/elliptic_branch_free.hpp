#pragma once
#include <brouwer/integrators/elliptic_base.hpp>

namespace brouwer {

/// The elliptic solution by the branch-free addition step (addition_step.hpp), in value form:
///     y₁' = (P y₁ − c₁² w R y₂y₃)/D     y₂' = (P R y₂ + w y₁y₃)/D     y₃' = (R y₃ − c₂² w P y₁y₂)/D
/// P and R near 1 are the same rounded numbers in every step: persistent slopes.
template <Real T>
class EllipticBranchFree : public EllipticBase<T> {
 public:
  using State = RigidBodyState<T>;

  explicit EllipticBranchFree(Setup<RigidBody<T>> const& setup)
      : EllipticBase<T>(setup), step_(planned_step(this->constants(), setup)) {}

  State operator()(State const& s) const {
    auto const& y = s.momentum;
    auto const f = step_(y);
    return this->with_momentum(s, {(f.P * y[0] - step_.c1_squared() * f.w * f.R * y[1] * y[2]) / f.denominator,
                                   (f.P * f.R * y[1] + f.w * y[0] * y[2]) / f.denominator,
                                   (f.R * y[2] - step_.c2_squared() * f.w * f.P * y[0] * y[1]) / f.denominator});
  }

  /// The addition step over h, with a series just long enough for this start.
  static AdditionStep<T> planned_step(EllipticConstants<T> const& c, Setup<RigidBody<T>> const& setup) {
    auto const plan = plan_series(c, setup.start.momentum, setup.step);
    return {c, Wider<T>(setup.step), plan.halvings, SnSeries<T>(plan.terms)};
  }

 private:
  AdditionStep<T> step_;
};

/// The same step as an increment, with p₁ = P − 1, r₁ = R − 1 and e = c₁²c₂²w²y₂² free of cancellation:
///     y₁' − y₁ = ((p₁ + e) y₁ − c₁² w R y₂y₃)/D
///     y₂' − y₂ = ((p₁ + r₁ + p₁r₁ + e) y₂ + w y₁y₃)/D
///     y₃' − y₃ = ((r₁ + e) y₃ − c₂² w P y₁y₂)/D
/// Its rounding errors are of the size of the increment: a random walk, which compensation makes
/// a hundred times smaller at h = 0.01 (studies/elliptic-forms.toml).
template <Real T>
class EllipticIncrement : public EllipticBase<T> {
 public:
  using State = RigidBodyState<T>;

  explicit EllipticIncrement(Setup<RigidBody<T>> const& setup)
      : EllipticBase<T>(setup), step_(EllipticBranchFree<T>::planned_step(this->constants(), setup)) {}

  State increment(State const& s) const {
    auto const& y = s.momentum;
    auto const f = step_(y);
    return this->change(s, {((f.p1 + f.e) * y[0] - step_.c1_squared() * f.w * f.R * y[1] * y[2]) / f.denominator,
                            ((f.p1 + f.r1 + f.p1 * f.r1 + f.e) * y[1] + f.w * y[0] * y[2]) / f.denominator,
                            ((f.r1 + f.e) * y[2] - step_.c2_squared() * f.w * f.P * y[0] * y[1]) / f.denominator});
  }

 private:
  AdditionStep<T> step_;
};

}  // namespace brouwer
