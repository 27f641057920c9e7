#pragma once
#include <optional>

#include <brouwer/integrators/elliptic_attitude.hpp>
#include <brouwer/integrators/stepper.hpp>

namespace brouwer {

/// What the elliptic integrators of the rigid body share: the body's three constants, and the attitude, which follows
/// from the momentum before and after the step whichever form computed it.
template <Real T>
class EllipticBase {
 public:
  using Scalar = T;
  using System = RigidBody<T>;
  using State = RigidBodyState<T>;
  static constexpr int order = 0;

  /// A finite state that has no next one is turned too often by a step (elliptic_attitude.hpp).
  static Failure failure(State const&, int) { return Failure::step_too_large; }

 protected:
  explicit EllipticBase(Setup<System> const& setup) : body_(setup.system), constants_(setup.system), h_(setup.step) {
    if (setup.whole_state) attitude_.emplace(setup.system, constants_, setup.step, setup.start.momentum);
  }

  RigidBody<T> const& body() const { return body_; }
  EllipticConstants<T> const& constants() const { return constants_; }
  T const& step_size() const { return h_; }
  /// None where nothing asks for it.
  std::optional<EllipticAttitude<T>> const& attitude() const { return attitude_; }

  /// The change of the state that belongs to a change of the momentum.
  State change(State const& s, Vector3<T> const& dy) const {
    if (!attitude_) return {dy, {T(0), T(0), T(0), T(0)}};
    return {dy, attitude_->increment(s.attitude, s.momentum, dy)};
  }

  /// The state after a step that computed the momentum's new value.
  State with_momentum(State const& s, Vector3<T> const& y) const {
    if (!attitude_) return {y, s.attitude};
    auto const& y0 = s.momentum;
    State next = sum(s, change(s, {y[0] - y0[0], y[1] - y0[1], y[2] - y0[2]}));
    next.momentum = y;
    return next;
  }

 private:
  RigidBody<T> body_;
  EllipticConstants<T> constants_;
  T h_;
  std::optional<EllipticAttitude<T>> attitude_;
};

}  // namespace brouwer
