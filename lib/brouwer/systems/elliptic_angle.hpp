#pragma once
#include <cmath>

#include <brouwer/special/carlson.hpp>
#include <brouwer/systems/elliptic_constants.hpp>

namespace brouwer {

/// The angle Δψ of the elliptic attitude (AttitudeFrame) in closed form, by Carlson's R_J. With D = k_dn dn u > 0 and d the
/// axis that carries dn, dψ/dt = r/I_d + (2H − r²/I_d)/(r + D), where
///     2H − r²/I_d = ±c₃k_cn²    r² − D² = k_cn²(1 + ν sn²u)    ν = c_dn²/c_cn²        (+ for axis 3, − for axis 1)
/// so that, du = u̇ dt and u̇ = δ c_cn c₃ k_dn,
///     ψ = rt/I_d ± δ [ r/(c_cn k_dn) Π(u) − θ(u) ]
///     Π(u) = ∫₀ᵘ du/(1 + ν sn²u) = u − (ν/3) sn³u R_J(cn²u, dn²u, 1, 1 + ν sn²u)            [DLMF 19.25.14]
///     θ(u) = the angle of the point (c_cn cn u, sn u), which is that of (y_cn, y_sn) up to sign
/// Both grow by twice their value at K in half a period.
///
/// Single numbers, no packs; not at rest (k_dn, c_cn > 0). The two terms in the bracket are nearly the same where k_cn is
/// small: the error is some ε of the angles rt/I_d and θ, not of their difference.
template <Real T>
class EllipticAngle {
 public:
  EllipticAngle(RigidBody<T> const& body, EllipticBranch<T> const& branch, EllipticFunctions<T> const& functions,
                T const& r)
      : functions_(functions),
        c_cn_(branch.c_cn),
        nu_(squared(T(branch.c_dn / branch.c_cn))),
        spin_(r / (branch.exchanged ? body.inertia()[0] : body.inertia()[2])),
        sign_((branch.exchanged ? T(-1) : T(1)) * branch.side()),
        weight_(r / (branch.c_cn * branch.k_dn)),
        periodic_(branch.modulus < T(1)) {
    if (!periodic_) return;
    K_ = complete_elliptic_k(branch.modulus);
    Pi_of_K_ = third_kind(K_, {T(1), T(0), T(sqrt_of_complement(branch.modulus))});
  }

  /// Over the time t from the argument u to the argument v = u + u̇t.
  T operator()(T const& t, T const& u, T const& v) const {
    auto const before = at(u), after = at(v);
    return spin_ * t + sign_ * (weight_ * (after.third_kind - before.third_kind) - (after.polar - before.polar));
  }

 private:
  struct Angles {
    T third_kind, polar;
  };

  static T sqrt_of_complement(T const& k) {
    using math::sqrt;
    return sqrt(complementary_parameter(k));
  }

  T third_kind(T const& u, Jacobi<T> const& j) const {
    T const s2 = squared(j.sn);
    T const rj = carlson_rj(squared(j.cn), squared(j.dn), T(1), T(T(1) + nu_ * s2));
    return u - nu_ * s2 * j.sn * rj / T(3);
  }

  /// u less the nearest multiple of 2K, and that multiple.
  Angles at(T const& u) const {
    using std::floor;
    T const half_periods = periodic_ ? T(floor(T((u + K_) / (T(2) * K_)))) : T(0);
    T const rest = periodic_ ? T(u - half_periods * (T(2) * K_)) : u;
    auto const j = functions_.jacobi(rest);
    return {T(2) * half_periods * Pi_of_K_ + third_kind(rest, j),
            half_periods * pi<T>() + arctangent(j.sn, T(c_cn_ * j.cn))};
  }

  EllipticFunctions<T> functions_;
  T c_cn_, nu_, spin_, sign_, weight_;
  bool periodic_;
  T K_ = T(0), Pi_of_K_ = T(0);
};

}  // namespace brouwer
