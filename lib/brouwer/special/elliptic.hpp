#pragma once
#include <array>

#include <brouwer/scalar/wider.hpp>
#include <brouwer/special/carlson.hpp>

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

/// Incomplete elliptic integral of the first kind F(φ, k) = ∫₀^φ dθ / √(1 − k² sin²θ).
/// @param phi  amplitude, radians, −π ≤ φ ≤ π
/// @param k    modulus, 0 ≤ k ≤ 1; with k = 1 only |φ| < π/2 is finite
/// Method:   sin φ R_F(cos²φ, 1 − k² sin²φ, 1) [DLMF 19.25.5], the second argument as cos²φ + (1 − k²) sin²φ; beyond
/// π/2 the reflection 2K(k) − F(π − φ, k).
/// Error:    below 8 ulp in double; measured in tests/special/elliptic_test.cpp, not proved.
template <Real T>
T elliptic_f(T const& phi, T const& k) {
  using math::cos;
  using math::sin;
  T const s = sin(phi), c = cos(phi);
  T const near = s * carlson_rf(c * c, c * c + complementary_parameter(k) * (s * s), T(1));
  auto const beyond = c < T(0);
  if (!any(beyond)) return near;
  T const k_inside = select(beyond, k, T(0));  // no K(1) for lanes that do not ask for it
  return select(beyond, T(2) * sign_of(s) * complete_elliptic_k(k_inside) - near, near);
}

namespace detail {

/// sech and tanh: the limit k = 1.
template <Real T>
Jacobi<T> hyperbolic_jacobi(T const& u) {
  using math::cosh;
  using math::tanh;
  T const sech = T(1) / cosh(u);
  return {tanh(u), sech, sech};
}

template <Real T>
inline constexpr int agm_limit = 16 + (significand_bits<T> > 64 ? 16 : 0);

}  // namespace detail

/// Jacobi's elliptic functions sn(u, k), cn(u, k), dn(u, k).
/// @param u  argument, any finite number (accuracy is that of reducing u by the period)
/// @param k  modulus, 0 ≤ k ≤ 1
/// Method:   arithmetic–geometric mean forward, Gauss's transformation of cot backward: R. Bulirsch,
///           Numer. Math. 7 (1965) 78 [DLMF 22.20(ii)]. k = 1: tanh and sech. Near a zero of sn: its tangent.
/// Error:    below 12 ulp of 1 in double; measured in tests/special/elliptic_test.cpp, not proved.
/// Rounding: the order of operations is part of the contract; a converged lane is frozen.
template <Real T>
Jacobi<T> jacobi_elliptic(T const& u, T const& k) {
  using math::abs;
  using math::cos;
  using math::sin;
  using math::sqrt;
  constexpr int limit = detail::agm_limit<T>;
  static T const root_epsilon = sqrt(epsilon<T>());
  auto const degenerate = k >= T(1);
  using M = std::remove_cv_t<decltype(degenerate)>;

  // the means: arithmetic a, geometric g; `ran` remembers which lanes took a stage
  std::array<T, limit> a_at{}, g_at{};
  std::array<M, limit> ran{};
  T a = T(1), c = T(1), product = select(degenerate, T(1), complementary_parameter(k));
  M active = a > T(0);
  int stages = 0;
  for (; stages < limit && any(active); ++stages) {
    T const g = sqrt(product);
    T const mean = (a + g) / T(2);
    auto const slot = static_cast<std::size_t>(stages);
    a_at[slot] = a;
    g_at[slot] = g;
    ran[slot] = active;
    c = select(active, mean, c);
    active = both(active, abs(a - g) > root_epsilon * a);
    product = select(active, g * a, product);
    a = select(active, mean, a);
  }

  // back through the stages with c = cot of the amplitude, scaled
  T const s = sin(c * u), cosine = cos(c * u);
  auto const tiny = abs(s) < root_epsilon * c / T(2);
  Jacobi<T> const at_zero{s / c, sign_of(cosine), T(1)};
  T ratio = cosine / select(tiny, T(1), s), dn = T(1);
  c = c * ratio;
  for (int stage = stages - 1; stage >= 0; --stage) {
    auto const slot = static_cast<std::size_t>(stage);
    T const b = a_at[slot], x = ratio * c, y = c * dn;
    T const d = (g_at[slot] + x) / (b + x);
    ratio = select(ran[slot], y / b, ratio);
    c = select(ran[slot], y, c);
    dn = select(ran[slot], d, dn);
  }
  T const sn = sign_of(s) / sqrt(c * c + T(1));
  auto const regular = select(tiny, at_zero, Jacobi<T>{sn, c * sn, dn});
  return any(degenerate) ? select(degenerate, detail::hyperbolic_jacobi(u), regular) : regular;
}

}  // namespace brouwer
