#pragma once
#include <array>

#include <brouwer/scalar/wider.hpp>

namespace brouwer {

namespace detail {
/// The first duplications halve the exponents of small arguments, each of the others gains a factor of 4: more than
/// any domain's point needs. Only R_F(0, 0, z) = ∞ never arrives.
template <class T>
inline constexpr int duplication_limit = 32 + significand_bits<T> / 8;
}  // namespace detail

/// Carlson's symmetric integral of the first kind, R_F(x, y, z) = ½ ∫₀^∞ dt / √((t+x)(t+y)(t+z)).
/// @param x,y,z  ≥ 0, at most one of them 0
/// Method:   duplication until the arguments agree to ε^{1/6}, then the series of order 5.
///           B. C. Carlson, Numer. Algorithms 10 (1995) 13, eqs (2.1)–(2.11) [DLMF 19.36.1].
/// Error:    measured in tests/special/elliptic_test.cpp.
/// Rounding: the order of operations is part of the contract; a converged lane is frozen.
template <Real T>
T carlson_rf(T x, T y, T z) {
  using math::abs;
  using math::sqrt;
  static T const tolerance = [] {
    using E = Element<T>;
    Wider<E> const small = 3 * Wider<E>(epsilon<E>());
    return T(rounded<E>(pow(small, Wider<E>(-1) / 6)));
  }();
  T mean = (x + y + z) / T(3);
  T spread = tolerance * larger(larger(abs(mean - x), abs(mean - y)), abs(mean - z));
  auto active = abs(mean) <= spread;
  for (int i = 0; any(active) && i < detail::duplication_limit<T>; ++i) {
    T const rx = sqrt(x), ry = sqrt(y), rz = sqrt(z);
    T const lambda = rx * ry + ry * rz + rz * rx;
    x = select(active, (x + lambda) / T(4), x);
    y = select(active, (y + lambda) / T(4), y);
    z = select(active, (z + lambda) / T(4), z);
    mean = select(active, (mean + lambda) / T(4), mean);
    spread = select(active, spread / T(4), spread);
    active = both(active, abs(mean) <= spread);
  }
  T const X = (mean - x) / mean, Y = (mean - y) / mean, Z = -(X + Y);
  T const e2 = X * Y - Z * Z, e3 = X * Y * Z;
  T const series = T(1) - e2 / T(10) + e3 / T(14) + e2 * e2 / T(24) - T(3) * e2 * e3 / T(44);
  return series / sqrt(mean);
}

/// Carlson's degenerate integral, R_C(x, y) = ½ ∫₀^∞ dt / (√(t+x) (t+y)) = R_F(x, y, y).
/// @param x,y  x ≥ 0, y ≠ 0; for y < 0 Cauchy's principal value [DLMF 19.2.20]
/// Method:   duplication until the arguments agree to ε^{1/8}, then the series of order 7.
///           B. C. Carlson, Numer. Algorithms 10 (1995) 13, eqs (2.12)–(2.17) [DLMF 19.36.1].
/// Error:    below 2 ulp in double over the arguments of tests/special/carlson_test.cpp; measured, not proved.
/// Rounding: the order of operations is part of the contract; a converged lane is frozen.
template <Real T>
T carlson_rc(T x, T y) {
  using math::abs;
  using math::sqrt;
  static T const tolerance = [] {
    using E = Element<T>;
    Wider<E> const small = 3 * Wider<E>(epsilon<E>());
    return T(rounded<E>(pow(small, Wider<E>(-1) / 8)));
  }();
  auto const beyond_pole = y < T(0);
  T const shifted = x - select(beyond_pole, y, T(0));
  T const factor = select(beyond_pole, sqrt(x / select(beyond_pole, shifted, T(1))), T(1));
  x = shifted;
  y = abs(y);

  T mean = (x + y + y) / T(3), spread = tolerance * abs(mean - x);
  auto active = mean <= spread;
  for (int i = 0; any(active) && i < detail::duplication_limit<T>; ++i) {
    T const lambda = T(2) * sqrt(x) * sqrt(y) + y;
    x = select(active, (x + lambda) / T(4), x);
    y = select(active, (y + lambda) / T(4), y);
    mean = select(active, (mean + lambda) / T(4), mean);
    spread = select(active, spread / T(4), spread);
    active = both(active, mean <= spread);
  }
  T const s = (y - mean) / mean;
  T const inner = T(3) / T(8) + s * (T(9) / T(22) + s * (T(159) / T(208) + s * (T(9) / T(8))));
  T const series = T(1) + s * s * (T(3) / T(10) + s * (T(1) / T(7) + s * inner));
  return factor * (series / sqrt(mean));
}

/// Carlson's symmetric integral of the third kind, R_J(x, y, z, p) = ³⁄₂ ∫₀^∞ dt / (√((t+x)(t+y)(t+z)) (t+p)).
/// @param x,y,z  ≥ 0, at most one of them 0
/// @param p      > 0
/// Method:   duplication until the arguments agree to ε^{1/6}, then the series of order 5; each duplication adds an R_C.
///           B. C. Carlson, Numer. Algorithms 10 (1995) 13, eqs (2.18)–(2.29) [DLMF 19.26(ii), 19.36(i)].
/// Error:    below 4 ulp in double over the arguments of tests/special/carlson_test.cpp; measured, not proved.
/// Rounding: the order of operations is part of the contract; a converged lane is frozen.
template <Real T>
T carlson_rj(T x, T y, T z, T p) {
  using math::abs;
  using math::sqrt;
  static T const tolerance = [] {
    using E = Element<T>;
    Wider<E> const small = Wider<E>(epsilon<E>()) / 4;
    return T(rounded<E>(pow(small, Wider<E>(-1) / 6)));
  }();
  T mean = (x + y + z + p + p) / T(5);
  T spread = tolerance * larger(larger(abs(mean - x), abs(mean - y)), larger(abs(mean - z), abs(mean - p)));
  T scale = T(1), sum = T(0);  // 4⁻ⁿ
  auto active = mean <= spread;
  for (int i = 0; any(active) && i < detail::duplication_limit<T>; ++i) {
    T const rx = sqrt(x), ry = sqrt(y), rz = sqrt(z), rp = sqrt(p);
    T const lambda = rx * ry + ry * rz + rz * rx;
    // d = (√p+√x)(√p+√y)(√p+√z), and d(1 + e) = d + (√p−√x)(√p−√y)(√p−√z), in which nothing cancels
    T const d = (rp + rx) * (rp + ry) * (rp + rz), one_plus_e = T(2) * rp * (p + lambda) / d;
    sum = select(active, sum + scale / d * carlson_rc(T(1), one_plus_e), sum);
    x = select(active, (x + lambda) / T(4), x);
    y = select(active, (y + lambda) / T(4), y);
    z = select(active, (z + lambda) / T(4), z);
    p = select(active, (p + lambda) / T(4), p);
    mean = select(active, (mean + lambda) / T(4), mean);
    spread = select(active, spread / T(4), spread);
    scale = select(active, scale / T(4), scale);
    active = both(active, mean <= spread);
  }
  T const X = (mean - x) / mean, Y = (mean - y) / mean, Z = (mean - z) / mean, P = -(X + Y + Z) / T(2);
  T const xyz = X * Y * Z, P2 = P * P;
  T const e2 = X * Y + X * Z + Y * Z - T(3) * P2, e3 = xyz + T(2) * e2 * P + T(4) * P2 * P;
  T const e4 = (T(2) * xyz + e2 * P + T(3) * P2 * P) * P, e5 = xyz * P2;
  T const series = T(1) - T(3) * e2 / T(14) + e3 / T(6) + T(9) * e2 * e2 / T(88) - T(3) * e4 / T(22) -
                   T(9) * e2 * e3 / T(52) + T(3) * e5 / T(26);
  return scale * series / (mean * sqrt(mean)) + T(6) * sum;
}

}  // namespace brouwer
