#pragma once
#include <optional>

#include <brouwer/special/elliptic.hpp>
#include <brouwer/special/gauss_legendre.hpp>
#include <brouwer/systems/attitude_frame.hpp>
#include <brouwer/systems/elliptic_angle.hpp>
#include <brouwer/systems/exact_flow.hpp>

namespace brouwer {

/// How the angle Δψ of the attitude is made from y: by Gauss–Legendre quadrature, or in closed form (elliptic_angle.hpp).
/// Each is the other's oracle.
enum class AngleBy { quadrature, carlson };

/// The exact flow of a free rigid body from one start, evaluated directly at any time: the reference against which the
/// error of a state is measured, and the test oracle of every integrator.
///
/// y by Jacobi's functions (three constants), the attitude by q(t) = q(0) ⊗ p(y(0))⁻¹ ⊗ rot(e, Δψ(t)) ⊗ p(y(t)) with Δψ
/// integrated over one period of the integrand once and over the remainder at each call, or in closed form. The error at
/// time t is a few ulp of T times the number of periods: take a T wider than what is judged.
template <Real T>
class RigidBodyFlow {
 public:
  RigidBodyFlow(RigidBody<T> const& body, RigidBodyState<T> const& start, AngleBy by = AngleBy::quadrature)
      : body_(body),
        start_(start),
        constants_(body),
        branch_(constants_, start.momentum),
        frame_(branch_, start.momentum),
        functions_(branch_.modulus),
        resting_(at_rest(constants_, start.momentum)),
        side_(sign_of(branch_.y_cn)),
        rate_(branch_.rate(constants_.c3)) {
    using math::abs;
    if (!resting_) argument_ = functions_.argument(T(side_ * branch_.c_cn * branch_.y_sn), T(side_ * branch_.y_cn));
    if (by == AngleBy::carlson && !resting_) closed_form_.emplace(body, branch_, functions_, frame_.r);
    periodic_ = !resting_ && !closed_form_ && branch_.modulus < T(1);
    if (periodic_) {
      period_ = T(2) * complete_elliptic_k(branch_.modulus) / abs(rate_);
      angle_of_period_ = angle(period_);
    }
  }

  Vector3<T> momentum(T const& t) const {
    if (resting_) return start_.momentum;
    auto const j = functions_.jacobi(T(argument_ + rate_ * t));
    return branch_.momentum({side_ * j.sn, side_ * j.cn, j.dn});
  }

  RigidBodyState<T> operator()(T const& t) const {
    auto const y = momentum(t);
    auto const& y0 = start_.momentum;
    auto const turn = frame_.turn_less_one({y[0] - y0[0], y[1] - y0[1], y[2] - y0[2]}, total_angle(t));
    auto const& q = start_.attitude;
    auto const dq = hamilton_product(q, turn);
    return {y, {q.w() + dq.w(), q.x() + dq.x(), q.y() + dq.y(), q.z() + dq.z()}};
  }

 private:
  T total_angle(T const& t) const {
    using std::floor;
    if (closed_form_) return (*closed_form_)(t, argument_, T(argument_ + rate_ * t));
    if (!periodic_) return angle(t);
    T const periods = floor(T(t / period_));
    return periods * angle_of_period_ + angle(T(t - periods * period_));
  }

  /// ∫₀ᵗ dψ, t at most about one period, in pieces short enough for the rule's nodes to stay few.
  T angle(T const& t) const {
    double const span = std::abs(static_cast<double>(rate_ * t));
    int const pieces = 1 + static_cast<int>(std::min(span / 2, 1e6));
    GaussLegendre<T> const& rule = rule_for_two_radians();
    T const length = t / T(pieces), twice_energy = T(2) * body_.energy(start_.momentum);
    T const inertia = branch_.exchanged ? body_.inertia()[0] : body_.inertia()[2];
    T sum = T(0);
    for (int piece = 0; piece < pieces; ++piece)
      for (auto const& node : rule.nodes()) {
        auto const y = momentum(T(T(piece) + node.x) * length);
        T const along = branch_.side() * (branch_.exchanged ? y[0] : y[2]);
        sum += node.weight * attitude_rate(twice_energy, frame_.r, along, inertia);
      }
    return sum * length;
  }

  static GaussLegendre<T> const& rule_for_two_radians() {
    static GaussLegendre<T> const rule(GaussLegendre<T>::nodes_needed(2.0, singularity_distance));
    return rule;
  }

  RigidBody<T> body_;
  RigidBodyState<T> start_;
  EllipticConstants<T> constants_;
  EllipticBranch<T> branch_;
  AttitudeFrame<T> frame_;
  EllipticFunctions<T> functions_;
  std::optional<EllipticAngle<T>> closed_form_;
  bool resting_, periodic_ = false;
  T side_;  ///< −1: half a period further on in the argument, where sn and cn have the other sign
  T rate_, argument_{}, period_{}, angle_of_period_{};
};

template <Real T>
struct ExactFlow<RigidBody<T>> {
  using type = RigidBodyFlow<T>;
};

}  // namespace brouwer
