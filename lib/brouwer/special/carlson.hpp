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

}  // namespace brouwer
