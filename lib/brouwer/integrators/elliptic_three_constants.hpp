#pragma once
#include <brouwer/integrators/elliptic_base.hpp>
#include <brouwer/special/elliptic_variants.hpp>

namespace brouwer {

/// The elliptic solution with three constants that are consistent with one another: G. Vilmart, J. Comput. Phys. 227
/// (2008) 7083. One step in the argument: u = F(arctan(c₁y₂ : y₁), k), add u̇h, evaluate. Its energy error is a
/// random walk.
template <Real T, class Functions = OwnElliptic>
class EllipticThreeConstants : public EllipticBase<T> {
 public:
  using State = RigidBodyState<T>;
  static constexpr bool runs_in_lanes = true;
  explicit EllipticThreeConstants(Setup<RigidBody<T>> const& setup) : EllipticBase<T>(setup) {}

  State operator()(State const& s) const { return this->with_momentum(s, next_momentum(s.momentum)); }

 private:
  Vector3<T> next_momentum(Vector3<T> const& y) const {
    EllipticBranch<T> const b(this->constants(), y);
    T const v = b.rate(this->constants().c3) * this->step_size();
    auto const j = Functions::advanced(T(b.c_cn * b.y_sn), b.y_cn, v, b.modulus);
    return select_vector<T>(at_rest(this->constants(), y), y, b.momentum(j));
  }
};

/// The same solution, one step by the addition theorem: sn, cn, dn of the small v = u̇h once, put together with
///     sn u = c₁y₂/k₁    cn u = y₁/k₁    dn u = δy₃/k₃        [DLMF 22.8.1–22.8.3]
/// and no inverse function. The same rounded sn v, cn v, dn v act in every step of a member: its error persists,
/// with another slope in every member and no drift of the ensemble's mean.
template <Real T, class Functions = OwnElliptic>
class EllipticAddition : public EllipticBase<T> {
 public:
  using State = RigidBodyState<T>;
  static constexpr bool runs_in_lanes = true;
  explicit EllipticAddition(Setup<RigidBody<T>> const& setup) : EllipticBase<T>(setup) {}

  State operator()(State const& s) const { return this->with_momentum(s, next_momentum(s.momentum)); }

 private:
  Vector3<T> next_momentum(Vector3<T> const& y) const {
    EllipticBranch<T> const b(this->constants(), y);
    auto const step = Functions::jacobi(T(b.rate(this->constants().c3) * this->step_size()), b.modulus);
    T const k_cn = b.nonzero(b.k_cn), k_dn = b.nonzero(b.k_dn);
    Jacobi<T> const now{b.c_cn * b.y_sn / k_cn, b.y_cn / k_cn, b.side() * b.y_dn / k_dn};
    return select_vector<T>(at_rest(this->constants(), y), y, b.momentum(add(now, step, squared(b.modulus))));
  }

  /// sn, cn, dn of u + v from those of u and v; m = k².
  static Jacobi<T> add(Jacobi<T> const& u, Jacobi<T> const& v, T const& m) {
    T const below = T(1) - m * squared(u.sn) * squared(v.sn);
    return {(u.sn * v.cn * v.dn + v.sn * u.cn * u.dn) / below, (u.cn * v.cn - u.sn * u.dn * v.sn * v.dn) / below,
            (u.dn * v.dn - m * u.sn * u.cn * v.sn * v.cn) / below};
  }
};

}  // namespace brouwer
