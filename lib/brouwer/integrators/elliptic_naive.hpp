#pragma once
#include <brouwer/integrators/elliptic_base.hpp>
#include <brouwer/special/elliptic_variants.hpp>

namespace brouwer {

/// The rigid body by Jacobi's elliptic functions with the constants of the textbooks (L. D. Landau, E. M. Lifshitz,
/// Mechanics, §37):
///     c₁ = √(I₁/(I₃−I₁))   c₂ = √(I₂/(I₃−I₂))   c₃ = √(I₃/(I₃−I₁))   a₁ = √(2H·I₃ − 2C)   a₂ = √(2C − 2H·I₁)
///     k² = (I₂−I₁)/(I₃−I₂) · a₁²/a₂²            u̇ = √((I₃−I₂)/(I₁I₂I₃)) · δ a₂              δ = sign y₃
///     y₁ = c₁a₁ cn(u,k)    y₂ = c₂a₁ sn(u,k)    y₃ = δ c₃a₂ dn(u,k)
/// and a step u = F(arctan(y₂/c₂ : y₁/c₁), k) + u̇h, with H and C evaluated anew in every step; for k > 1 the axes 1 and 3 are exchanged. Exact in exact arithmetic. In
/// rounded arithmetic its constants contradict one another, by the same amount in every step: the energy drifts.
/// This is the implementation to be contrasted, so everything is computed in the working precision, as written.
template <Real T, class Functions = OwnElliptic>
class EllipticNaive : public EllipticBase<T> {
 public:
  using State = RigidBodyState<T>;
  static constexpr bool runs_in_lanes = true;

  explicit EllipticNaive(Setup<RigidBody<T>> const& setup) : EllipticBase<T>(setup) {
    using math::sqrt;
    auto const& I = setup.system.inertia();
    d21_ = I[1] - I[0];
    d32_ = I[2] - I[1];
    c1_ = root_of_ratio(I[0], I[2] - I[0]);
    c3_ = root_of_ratio(I[2], I[2] - I[0]);
    c2_[0] = root_of_ratio(I[1], d32_);
    c2_[1] = root_of_ratio(I[1], d21_);
    rate_[0] = sqrt(d32_ / (I[0] * I[1] * I[2]));
    rate_[1] = sqrt(d21_ / (I[0] * I[1] * I[2]));
  }

  State operator()(State const& s) const { return this->with_momentum(s, next_momentum(s.momentum)); }

 private:
  /// √(a/b); 1 where b = 0, where the quotient is not used (I₁ = I₂ or I₂ = I₃ chooses the other branch).
  static T root_of_ratio(T const& a, T const& b) {
    using math::sqrt;
    return sqrt(a / select(b > T(0), b, T(1)));
  }

  Vector3<T> next_momentum(Vector3<T> const& y) const {
    using math::sqrt;
    auto const& I = this->body().inertia();
    T const twice_h = T(2) * this->body().energy(y), twice_c = T(2) * this->body().casimir(y);
    T const a1 = sqrt(larger(twice_h * I[2] - twice_c, T(0))), a2 = sqrt(larger(twice_c - twice_h * I[0], T(0)));

    auto const exchanged = d21_ * squared(a1) > d32_ * squared(a2);
    T const above = select(exchanged, d32_ * squared(a2), d21_ * squared(a1));
    T const below = select(exchanged, d21_ * squared(a1), d32_ * squared(a2));
    T const k = sqrt(above / select(below > T(0), below, T(1)));

    T const a_cn = select(exchanged, a2, a1), a_dn = select(exchanged, a1, a2);
    T const c_cn = select(exchanged, c3_, c1_), c_sn = select(exchanged, c2_[1], c2_[0]);
    T const c_dn = select(exchanged, c1_, c3_), rate = select(exchanged, rate_[1], rate_[0]);
    T const y_cn = select(exchanged, y[2], y[0]), side = sign_of(select(exchanged, y[0], y[2]));

    T const v = rate * side * a_dn * this->step_size();
    auto const j = Functions::advanced(T(y[1] / c_sn), T(y_cn / c_cn), v, k);
    T const cn_part = c_cn * a_cn * j.cn, dn_part = side * c_dn * a_dn * j.dn;
    Vector3<T> const next{select(exchanged, dn_part, cn_part), c_sn * a_cn * j.sn, select(exchanged, cn_part, dn_part)};
    return select_vector<T>(at_rest(this->constants(), y), y, next);
  }

  T d21_, d32_, c1_, c3_;
  T c2_[2], rate_[2];  ///< by branch
};

}  // namespace brouwer
