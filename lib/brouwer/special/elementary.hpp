#pragma once
#include <array>
#include <concepts>
#include <limits>

#include <brouwer/scalar/exact.hpp>

namespace brouwer {

/// The constants of this library's own elementary functions of T; `exists` where there are such functions. They have
/// the same bits on every machine, in every lane and with every compiler, because they are made of + − × ÷ √ and selects
/// alone. Other scalars call their own library's functions.
///
/// Each constant is its decimal expansion at 400 bits, rounded to the bits that it has; pairs are value + remainder.
template <class T>
struct ElementaryConstants {
  static constexpr bool exists = false;
};

template <>
struct ElementaryConstants<double> {
  static constexpr bool exists = true;
  static constexpr double root_epsilon = 0x1p-26;
  static constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
  /// π/2 in three parts of 33 bits, whose products with |n| ≤ 2²⁰ are exact, and the rest.
  static constexpr std::array<double, 4> half_pi_parts = {0x1.921fb544p0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69,
                                                          0x1.b839a252049c1p-104};
  static constexpr double largest_reduced = 0x1p20;  ///< |x| up to which n stays below 2²⁰
  static constexpr Exact<double> pi = {0x1.921fb54442d18p1, 0x1.1a62633145c07p-53};
  static constexpr Exact<double> half_pi = {0x1.921fb54442d18p0, 0x1.1a62633145c07p-54};
  static constexpr Exact<double> quarter_pi = {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55};
  static constexpr Exact<double> arctan_half = {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56};
  static constexpr double one_over_ln2 = 0x1.71547652b82fep0;
  /// ln 2 in 42 bits, whose products with |n| < 2¹¹ are exact, and the rest.
  static constexpr Exact<double> ln2 = {0x1.62e42fefa38p-1, 0x1.ef35793c7673p-45};
  static constexpr double largest_exponent = 700;  ///< e⁻⁷⁰⁰ is still a normal number
};

template <>
struct ElementaryConstants<float> {
  static constexpr bool exists = true;
  static constexpr float root_epsilon = 0x1.6a09e6p-12F;
  static constexpr float two_over_pi = 0x1.45f306p-1F;
  /// Three parts of 14 bits for |n| ≤ 2¹⁰, and the rest.
  static constexpr std::array<float, 4> half_pi_parts = {0x1.922p0F, -0x1.2afp-18F, 0x1.0b48p-34F, -0x1.ee59dap-50F};
  static constexpr float largest_reduced = 0x1p10F;
  static constexpr Exact<float> pi = {0x1.921fb6p1F, -0x1.777a5cp-24F};
  static constexpr Exact<float> half_pi = {0x1.921fb6p0F, -0x1.777a5cp-25F};
  static constexpr Exact<float> quarter_pi = {0x1.921fb6p-1F, -0x1.777a5cp-26F};
  static constexpr Exact<float> arctan_half = {0x1.dac67p-2F, 0x1.586ed4p-28F};
  static constexpr float one_over_ln2 = 0x1.715476p0F;
  /// 16 bits for |n| < 2⁸, and the rest.
  static constexpr Exact<float> ln2 = {0x1.62e4p-1F, 0x1.7f7d1cp-20F};
  static constexpr float largest_exponent = 80;
};

/// Numbers, and packs of them, whose elementary functions are this library's own.
template <class T>
concept OwnElementary = Real<T> && ElementaryConstants<Element<T>>::exists;

/// The integer nearest to a, ties to even, for |a| < 2^(p−2): what the addition of 1.5·2^(p−1) rounds to.
template <OwnElementary T>
T nearest_integer(T const& a) {
  constexpr Element<T> shift = 3 / (2 * std::numeric_limits<Element<T>>::epsilon());
  return (a + T(shift)) - T(shift);
}

/// Σₖ cₖ zᵏ, split into even and odd powers again and again (G. Estrin, 1960): a short chain of dependent operations.
template <std::size_t first = 0, std::size_t stride = 1, Real T, class E, std::size_t N>
T power_sum(std::array<E, N> const& c, T const& z) {
  if constexpr (first + stride >= N) {
    return T(c[first]);
  } else {
    T const square = z * z;
    return power_sum<first, 2 * stride>(c, square) + z * power_sum<first + stride, 2 * stride>(c, square);
  }
}

namespace detail {

/// How many of the terms size(n) are summed: those before the first below ε/64.
template <class E, class F>
constexpr std::size_t terms_of_series(F size) {
  std::size_t n = 1;
  while (size(n) * 64 > static_cast<double>(std::numeric_limits<E>::epsilon())) ++n;
  return n;
}

/// xᵏ/k!
constexpr double exponential_term(double x, std::size_t k) {
  double term = 1;
  for (std::size_t i = 1; i <= k; ++i) term *= x / static_cast<double>(i);
  return term;
}

/// 1/k!; k! is exact in double up to 22!, so that this is rounded once to double.
constexpr double reciprocal_factorial(std::size_t k) {
  double factorial = 1;
  for (std::size_t i = 2; i <= k; ++i) factorial *= static_cast<double>(i);
  return 1 / factorial;
}

}  // namespace detail

}  // namespace brouwer
