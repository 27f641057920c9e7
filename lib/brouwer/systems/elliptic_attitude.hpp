#pragma once
#include <vector>

#include <brouwer/special/gauss_legendre.hpp>
#include <brouwer/systems/addition_step.hpp>

namespace brouwer {

/// What relates two attitudes a time apart in the elliptic solution: the axis e = δ e_d that carries dn, the length
/// r of the momentum, and the angle Δψ by which the body turned about e between the two minimal rotations p.
///     q(t+h) = q(t) ⊗ p(y(t))⁻¹ ⊗ rot(e, Δψ) ⊗ p(y(t+h))
/// p(y) takes y/r to e: scalar 1 + y·e/r, vector y/r × e, normalised.
template <Real T>
struct AttitudeFrame {
  Vector3<T> e, direction;  ///< e, and y(t)/r
  T r;                      ///< |y|, or 1 where y = 0
  T cosine;                 ///< y·e/r ≥ 0

  AttitudeFrame(EllipticBranch<T> const& branch, Vector3<T> const& y) {
    using math::sqrt;
    T const side = branch.side(), length = sqrt(squared_norm(y));
    e = {select(branch.exchanged, side, T(0)), T(0), select(branch.exchanged, T(0), side)};
    r = select(length > T(0), length, T(1));
    direction = {y[0] / r, y[1] / r, y[2] / r};
    cosine = side * branch.y_dn / r;
  }

  /// p(y)⁻¹ ⊗ rot(e, Δψ) ⊗ p(y + Δy) − 1, every part with a relative error of a few ulp, however small the step:
  /// with P = √(2(1 + y·e/r)) p and P' = P + ΔP the product is |P|² (cos η, sin η y/r) + P* ⊗ (cos η, e sin η) ⊗ ΔP
  /// over |P||P'|, η = Δψ/2, because P* takes e back to y/r.
  Quaternion<T> turn_less_one(Vector3<T> const& dy, T const& psi) const {
    using math::cos;
    using math::sin;
    using math::sqrt;
    T const eta = psi / T(2), c = cos(eta), s = sin(eta);
    Vector3<T> const step{dy[0] / r, dy[1] / r, dy[2] / r};
    T const cosine_step = step[0] * e[0] + step[2] * e[2];
    auto const v = cross(direction, e), dv = cross(step, e);
    Quaternion<T> const back(T(1) + cosine, -v[0], -v[1], -v[2]), change(cosine_step, dv[0], dv[1], dv[2]);
    auto const rest = hamilton_product(hamilton_product(back, Quaternion<T>(c, s * e[0], s * e[1], s * e[2])), change);

    T const size2 = T(2) * (T(1) + cosine), size2_after = T(2) * (T(1) + (cosine + cosine_step));
    T const norm = sqrt(size2 * size2_after), main = size2 * s;
    Vector3<T> const vector{(main * direction[0] + rest.x()) / norm, (main * direction[1] + rest.y()) / norm,
                            (main * direction[2] + rest.z()) / norm};
    T const scalar = (size2 * c + rest.w()) / norm;
    auto const forward = scalar > T(0);
    T const less_one = select(forward, -squared_norm(vector) / (T(1) + select(forward, scalar, T(1))), scalar - T(1));
    return {less_one, vector[0], vector[1], vector[2]};
  }
};

/// dψ/dt = (2H + r δ y_d/I_d) / (r + δ y_d)
template <Real T>
T attitude_rate(T const& twice_energy, T const& r, T const& dn_component, T const& dn_inertia) {
  T const below = r + dn_component;
  return (twice_energy + r * dn_component / dn_inertia) / select(below > T(0), below, T(1));
}

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
    GaussLegendre<T> const rule(nodes_needed(c, h, start));
    for (auto const& node : rule.nodes()) {
      weights_.push_back(rounded<T>(W(W(node.weight) * W(h))));
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

  /// In the elliptic argument the nearest singularity is at least π/2 off the real axis, and |u̇| ≤ c₃ r.
  static int nodes_needed(EllipticConstants<T> const& c, T const& h, Vector3<T> const& y) {
    using math::sqrt;
    double const length = 1.01 * std::abs(static_cast<double>(c.c3 * h * sqrt(squared_norm(y))));
    double const half_pi = 1.5707963267948966;  // a bound, not a constant of the method
    return GaussLegendre<T>::nodes_needed(std::max(length, 1e-12), half_pi);
  }

  RigidBody<T> body_;
  EllipticConstants<T> constants_;
  std::vector<T> weights_;
  std::vector<AdditionStep<T>> to_node_;
};

}  // namespace brouwer
