#pragma once
#include <brouwer/systems/elliptic_constants.hpp>

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
    using math::sqrt;
    auto const [s, c] = sine_cosine(T(psi / T(2)));
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

/// In the elliptic argument u̇t the nearest singularity of dψ/dt is at least this far from the real axis: K' ≥ π/2. A
/// bound for the number of quadrature nodes, not a constant of the method.
inline constexpr double singularity_distance = 1.5707963267948966;

/// dψ/dt = (2H + r δ y_d/I_d) / (r + δ y_d)
template <Real T>
T attitude_rate(T const& twice_energy, T const& r, T const& dn_component, T const& dn_inertia) {
  T const below = r + dn_component;
  return (twice_energy + r * dn_component / dn_inertia) / select(below > T(0), below, T(1));
}

}  // namespace brouwer
