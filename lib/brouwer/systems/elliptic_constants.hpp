#pragma once
#include <brouwer/special/elliptic.hpp>
#include <brouwer/systems/rigid_body.hpp>

namespace brouwer {

/// The three constants of a body from which the whole elliptic solution is built:
///     c₁ = √(I₁(I₃−I₂) / (I₂(I₃−I₁)))    c₂ = √(1 − c₁²)    c₃ = 1/I₁ − 1/I₃
/// c₂ is computed from the *rounded* c₁, so that c₁² + c₂² = 1 holds as well as two rounded numbers can: this
/// consistency is what removes the drift. G. Vilmart, J. Comput. Phys. 227 (2008) 7083.
/// Each is formed in wider arithmetic and rounded once. A ball (I₁ = I₃) has c₃ = 0, and c₁ = 0 by convention.
template <Real T>
struct EllipticConstants {
  T c1, c2, c3;

  explicit EllipticConstants(RigidBody<T> const& body) {
    using W = Wider<T>;
    auto const I = body.template in<W>().inertia();
    W const width = I[2] - I[0];
    W const ratio = select(width > W(0), I[0] * (I[2] - I[1]) / (I[1] * select(width > W(0), width, W(1))), W(0));
    c1 = rounded<T>(W(sqrt(ratio)));
    c2 = rounded<T>(W(sqrt(larger(W(W(1) - squared(W(c1))), W(0)))));
    c3 = rounded<T>(W(width / (I[0] * I[2])));
  }
};

/// y with the axis that carries dn last: (y₁, y₂, y₃) where c₂k₁ ≤ c₁k₃, otherwise (y₃, y₂, y₁), with the constants
/// and k₁, k₃ exchanged likewise. The two branches of the elliptic solution are this exchange and nothing else.
template <Real T>
struct EllipticBranch {
  Mask<T> exchanged;
  T y_cn, y_sn, y_dn;  ///< the components that are multiples of cn, sn, dn
  T c_cn, c_dn;        ///< c₁, c₂ or c₂, c₁
  T k_cn, k_dn;  ///< k₁ = √(y₁² + c₁²y₂²), k₃ = √(c₂²y₂² + y₃²), or exchanged: both first integrals
  T modulus;  ///< k = c_dn k_cn / (c_cn k_dn), 0 ≤ k ≤ 1

  EllipticBranch(EllipticConstants<T> const& c, Vector3<T> const& y) {
    using math::sqrt;
    // (c₁y₂)², not c₁²·y₂²: a rounded c₁² would contradict c₁ by the same amount in every step of every member
    T const k1 = sqrt(squared(y[0]) + squared(T(c.c1 * y[1])));
    T const k3 = sqrt(squared(T(c.c2 * y[1])) + squared(y[2]));
    exchanged = c.c2 * k1 > c.c1 * k3;
    y_cn = select(exchanged, y[2], y[0]);
    y_sn = y[1];
    y_dn = select(exchanged, y[0], y[2]);
    c_cn = select(exchanged, c.c2, c.c1);
    c_dn = select(exchanged, c.c1, c.c2);
    k_cn = select(exchanged, k3, k1);
    k_dn = select(exchanged, k1, k3);
    T const below = c_cn * k_dn;
    modulus = select(below > T(0), c_dn * k_cn / nonzero(below), T(0));
  }

  /// For denominators of lanes whose quotient is not used.
  static T nonzero(T const& a) { return select(a > T(0), a, T(1)); }

  /// δ = sign of the dn component
  T side() const { return sign_of(y_dn); }

  /// u̇ = δ c_cn c₃ k_dn
  T rate(T const& c3) const { return side() * c_cn * c3 * k_dn; }

  /// y from sn, cn, dn
  Vector3<T> momentum(Jacobi<T> const& j) const {
    T const cn_part = k_cn * j.cn, sn_part = k_cn / nonzero(c_cn) * j.sn, dn_part = side() * k_dn * j.dn;
    return {select(exchanged, dn_part, cn_part), sn_part, select(exchanged, cn_part, dn_part)};
  }
};

/// Where ẏ = 0: a principal axis, every y of a ball, y₃ = 0 of a body with I₁ = I₂ …: y stays, and no formula with
/// a quotient is asked.
template <Real T>
Mask<T> at_rest(EllipticConstants<T> const& c, Vector3<T> const& y) {
  // c₁² : 1 : c₂² are the ratios of the three coefficients of Euler's equations
  T const r1 = c.c3 * c.c1 * y[1] * y[2], r2 = c.c3 * y[2] * y[0], r3 = c.c3 * c.c2 * y[0] * y[1];
  return both(both(r1 == T(0), r2 == T(0)), r3 == T(0));
}

}  // namespace brouwer
