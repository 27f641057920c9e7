#pragma once
#include <array>

#include <brouwer/scalar/wider.hpp>
#include <brouwer/special/carlson.hpp>
#include <brouwer/special/hyperbolic.hpp>
#include <brouwer/special/trigonometric.hpp>

namespace brouwer {

/// sn, cn, dn of one argument.
template <Real T>
struct Jacobi {
  T sn, cn, dn;
};

/// Lane by lane; for single numbers the general select does.
template <Real T>
requires(!std::same_as<Mask<T>, bool>) Jacobi<T> select(Mask<T> const& mask, Jacobi<T> const& yes,
                                                        Jacobi<T> const& no) {
  return {select(mask, yes.sn, no.sn), select(mask, yes.cn, no.cn), select(mask, yes.dn, no.dn)};
}

/// 1 − k² from the factors: no cancellation that k itself does not have.
template <Real T>
T complementary_parameter(T const& k) {
  return (T(1) - k) * (T(1) + k);
}

/// Complete elliptic integral of the first kind K(k) = ∫₀^{π/2} dθ / √(1 − k² sin²θ) = R_F(0, 1−k², 1) [DLMF 19.25.1].
/// @param k  modulus, 0 ≤ k < 1
/// Error:    below 4 ulp in double over the moduli of tests/special/elliptic_test.cpp; measured, not proved.
template <Real T>
T complete_elliptic_k(T const& k) {
  return carlson_rf(T(0), complementary_parameter(k), T(1));
}

/// The elliptic functions and integrals of one modulus k, which share its arithmetic–geometric means
///     a₀ = 1   g₀ = √(1 − k²)   aₙ₊₁ = (aₙ + gₙ)/2   gₙ₊₁ = √(aₙgₙ)   until |aₙ − gₙ| ≤ 2√ε aₙ; A = aₙ₊₁.
/// @param k  modulus, 0 ≤ k ≤ 1
/// Rounding: the order of operations is part of the contract; a lane takes the stages that it needs and no more.
template <Real T>
class EllipticFunctions {
 public:
  explicit EllipticFunctions(T const& k) : degenerate_(k >= T(1)) {
    using math::sqrt;
    T a = T(1), g = sqrt(select(degenerate_, T(1), complementary_parameter(k)));
    T four = T(1), half = T(1);  // 4ⁿ and 2⁻ⁿ
    mean_ = halvings_ = T(1);
    for (Mask<T> active = a > T(0);;) {
      T const mean = (a + g) / T(2), ag = a * g, am = a * mean;
      half = half / T(2);
      stages_[count_++] = {select(active, four * ag, T(0)), select(active, half, T(0)), am,
                           select(active, g * mean, am)};
      four = T(4) * four;
      mean_ = select(active, mean, mean_);
      halvings_ = select(active, half, halvings_);
      active = both(active, g < (T(1) - T(2) * root_epsilon()) * a);
      if (!any(active) || count_ == most_stages) break;
      a = mean;
      g = sqrt(ag);
    }
  }

  /// The u with sn u : cn u = s : c, that is F(arctan(s/c), k), −K ≤ u ≤ K.
  /// @param s,c  any two numbers with c ≥ 0 in a proportion; k = 1, c = 0: ±∞
  /// Method:   Landen's transformation of w = 2ⁿa cot φ, w → w − 4ⁿag/w, which doubles φ; half turns are counted as
  ///           fractions of the last: R. Bulirsch, Numer. Math. 7 (1965) 78 [DLMF 19.8(ii)]. k = 1: R_F. Small s/c: s/c.
  T argument(T const& s, T const& c) const {
    using math::abs;
    T const size = abs(s), nothing = squared(epsilon<T>());  // w = 0 becomes a quotient that is not 1/0
    auto const tiny = size <= root_epsilon() / T(2) * c;
    T w = c / select(tiny, T(1), size) + nothing, half_turns = T(0);
    for (std::size_t i = 0; i < count_; ++i) {
      auto const& stage = stages_[i];
      half_turns = half_turns + select(w < T(0), stage.weight, T(0));
      w = (w - stage.ag / w) + nothing;
    }
    T const per_radian = sign_of(s) / mean_;
    T u = (half_turns * pi<T>() + halvings_ * arctangent(mean_, T(halvings_ * w))) * per_radian;
    if (any(tiny)) u = select(tiny, s / select(c > T(0), c, T(1)), u);
    if (any(degenerate_)) u = select(degenerate_, hyperbolic_argument(s, c), u);
    return u;
  }

  /// sn, cn, dn of u.
  /// Method:   Gauss's transformation of a cot φ back through the means: R. Bulirsch, Numer. Math. 7 (1965) 78
  ///           [DLMF 22.20(ii)]. k = 1: tanh and sech. Near a zero of sn: its tangent.
  Jacobi<T> jacobi(T const& u) const {
    using math::abs;
    using math::sqrt;
    auto const angle = sine_cosine(T(mean_ * select(degenerate_, T(0), u)));
    T c = mean_ * angle.cos / (angle.sin + squared(epsilon<T>())), dn = T(1);
    for (std::size_t i = count_; i-- > 0;) {
      auto const& stage = stages_[i];
      T const c2 = c * c;
      c = c * dn;
      dn = (stage.gm + c2) / (stage.am + c2);
    }
    T const sn = sign_of(angle.sin) / sqrt(c * c + T(1));
    Jacobi<T> j{sn, c * sn, dn};
    auto const tiny = abs(angle.sin) < root_epsilon() / T(2) * mean_;
    if (any(tiny)) j = select(tiny, Jacobi<T>{angle.sin / mean_, sign_of(angle.cos), T(1)}, j);
    if (any(degenerate_)) j = select(degenerate_, hyperbolic(u), j);
    return j;
  }

  /// K(k) = π/(2A) [DLMF 19.8.5]; ∞ for k = 1.
  T quarter_period() const { return select(degenerate_, std::numeric_limits<T>::infinity(), pi<T>() / (T(2) * mean_)); }

 private:
  /// With a = aₙ, g = gₙ, m = aₙ₊₁. In a lane that needs fewer stages the values make a stage do nothing, exactly.
  struct Stage {
    T ag;      ///< 4ⁿ ag, or 0
    T weight;  ///< 2⁻¹⁻ⁿ, or 0
    T am, gm;  ///< or both am
  };
  /// From g₀ ≥ √ε: log₂ log₂ (1/g₀) stages until g/a is near 1, and as many again.
  static constexpr std::size_t most_stages = significand_bits<T> > 64 ? 32 : 16;

  static T root_epsilon() {
    if constexpr (OwnElementary<T>) {
      return T(ElementaryConstants<Element<T>>::root_epsilon);
    } else {
      using math::sqrt;
      static T const root = sqrt(epsilon<T>());
      return root;
    }
  }

  /// sech and tanh: the limit k = 1.
  [[gnu::cold, gnu::noinline]] static Jacobi<T> hyperbolic(T const& u) {
    auto const h = sech_tanh(u);
    return {h.tanh, h.sech, h.sech};
  }

  /// F(φ, 1) = sin φ R_F(cos²φ, cos²φ, 1), with sin φ and cos φ in a proportion.
  [[gnu::cold, gnu::noinline]] T hyperbolic_argument(T const& s, T const& c) const {
    auto const inside = both(degenerate_, c > T(0));
    T const cosine = select(inside, c, T(1)), sine = select(inside, s, T(0));
    T const c2 = squared(cosine);
    return select(inside, sine * carlson_rf(c2, c2, T(c2 + squared(sine))),
                  sign_of(s) * std::numeric_limits<T>::infinity());
  }

  Mask<T> degenerate_;
  T mean_, halvings_;  ///< A and 2⁻ᴺ
  std::size_t count_ = 0;
  std::array<Stage, most_stages> stages_;
};

/// Incomplete elliptic integral of the first kind F(φ, k) = ∫₀^φ dθ / √(1 − k² sin²θ).
/// @param phi  amplitude, radians, −π ≤ φ ≤ π
/// @param k    modulus, 0 ≤ k ≤ 1; with k = 1 only |φ| < π/2 is finite
/// Method:   EllipticFunctions::argument; beyond π/2 the reflection 2K(k) − F(π − φ, k).
/// Error:    below 4 ulp in double; measured in tests/special/elliptic_test.cpp, not proved.
template <Real T>
T elliptic_f(T const& phi, T const& k) {
  using math::abs;
  EllipticFunctions<T> const functions(k);
  auto const angle = sine_cosine(phi);
  T const near = functions.argument(angle.sin, T(abs(angle.cos)));
  return select(angle.cos < T(0), T(2) * sign_of(angle.sin) * functions.quarter_period() - near, near);
}

/// Jacobi's elliptic functions sn(u, k), cn(u, k), dn(u, k).
/// @param u  argument, any finite number (accuracy is that of reducing u by the period)
/// @param k  modulus, 0 ≤ k ≤ 1
/// Method:   EllipticFunctions::jacobi
/// Error:    below 12 ulp of 1 in double for |u| ≤ 10, half of it the rounding of the period; measured in
///           tests/special/elliptic_test.cpp, not proved.
template <Real T>
Jacobi<T> jacobi_elliptic(T const& u, T const& k) {
  return EllipticFunctions<T>(k).jacobi(u);
}

/// sn, cn, dn of u + v, where sn u : cn u = s : c for any two numbers s and c; k as above.
/// Method:   u is taken in −K ≤ u ≤ K: half a period from there sn and cn have changed their signs and dn has not.
template <Real T>
inline Jacobi<T> jacobi_advanced(T const& s, T const& c, T const& v, T const& k) {
  using math::abs;
  EllipticFunctions<T> const functions(k);
  T const side = sign_of(c);
  T const u = functions.argument(T(side * s), T(abs(c)));
  auto const j = functions.jacobi(T(u + v));
  return {side * j.sn, side * j.cn, j.dn};
}

}  // namespace brouwer
