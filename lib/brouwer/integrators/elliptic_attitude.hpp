#pragma once
#include <vector>

#include <brouwer/integrators/addition_step.hpp>
#include <brouwer/special/gauss_legendre.hpp>
#include <brouwer/systems/attitude_frame.hpp>

namespace brouwer {

/// The attitude over one step of an elliptic integrator, from the momentum before the step and its change.
/// Δψ is a Gauss–Legendre quadrature to the working precision; the momentum at the nodes comes from the
/// branch-free addition step, which is cheap, whichever form advances the momentum itself.
template <Real T>
class EllipticAttitude {
 public:
  EllipticAttitude(RigidBody<T> const& body, EllipticConstants<T> const& c, T const& h, Vector3<T> const& start)
      : body_(body), constants_(c) {
    using W = Wider<T>;
    auto const plan = plan_series(c, start, h);
    SnSeries<T> const series(plan.terms);
    int const needed = nodes_needed(c, h, start);
    GaussLegendre<T> const rule(std::min(needed, most_nodes));
    W const scale = needed <= most_nodes ? W(h) : std::numeric_limits<W>::quiet_NaN();
    for (auto const& node : rule.nodes()) {
      weights_.push_back(rounded<T>(W(W(node.weight) * scale)));
      to_node_.emplace_back(c, W(W(node.x) * W(h)), plan.halvings, series);
    }
  }

  /// q(t+h) − q(t) for the attitude q before the step.
  Quaternion<T> increment(Quaternion<T> const& q, Vector3<T> const& y, Vector3<T> const& dy) const {
    EllipticBranch<T> const branch(constants_, y);
    AttitudeFrame<T> const frame(branch, y);
    return hamilton_product(q, frame.turn_less_one(dy, angle(branch, frame, y)));
  }

 private:
  /// Δψ over the step
  T angle(EllipticBranch<T> const& branch, AttitudeFrame<T> const& frame, Vector3<T> const& y) const {
    T const twice_energy = T(2) * body_.energy(y), side = branch.side();
    T const inertia = select(branch.exchanged, body_.inertia()[0], body_.inertia()[2]);
    T psi = T(0);
    for (std::size_t i = 0; i < weights_.size(); ++i)
      psi = psi + weights_[i] * attitude_rate(twice_energy, frame.r, side * dn_component(i, branch, y), inertia);
    return psi;
  }

  /// The dn component of the momentum at node i.
  T dn_component(std::size_t i, EllipticBranch<T> const& branch, Vector3<T> const& y) const {
    auto const& step = to_node_[i];
    auto const f = step(y);
    T const y3 = f.R * y[2] - step.c2_squared() * f.w * f.P * y[0] * y[1];
    T const y1 = f.P * y[0] - step.c1_squared() * f.w * f.R * y[1] * y[2];
    return select(branch.exchanged, y1, y3) / f.denominator;
  }

  /// A step over hundreds of periods has no attitude: it is NaN, and the member has failed.
  static constexpr int most_nodes = 4000;

  /// |u̇| ≤ c₃ r
  static int nodes_needed(EllipticConstants<T> const& c, T const& h, Vector3<T> const& y) {
    using math::sqrt;
    double const length = 1.01 * std::abs(static_cast<double>(c.c3 * h * sqrt(squared_norm(y))));
    return GaussLegendre<T>::nodes_needed(std::max(length, 1e-12), singularity_distance);
  }

  RigidBody<T> body_;
  EllipticConstants<T> constants_;
  std::vector<T> weights_;
  std::vector<AdditionStep<T>> to_node_;
};

}  // namespace brouwer
