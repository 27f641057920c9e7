#pragma once
#include <brouwer/special/elementary.hpp>

namespace brouwer {

template <Real T>
struct SechTanh {
  T sech, tanh;
};

namespace detail {

/// eʳ − 1 = r + r² E(r) for |r| ≤ ½ ln 2, Taylor's series.
template <class E>
struct ExponentialSeries {
  static constexpr double end = 0.3466;  ///< ≥ ½ ln 2
  static constexpr std::size_t terms =
      terms_of_series<E>([](std::size_t n) { return exponential_term(end, n + 2) / end; });
  static constexpr auto coefficients = [] {
    std::array<E, terms> c{};
    for (std::size_t k = 0; k < c.size(); ++k) c[k] = static_cast<E>(reciprocal_factorial(k + 2));
    return c;
  }();
};

/// 2⁻ⁿ for an integer 0 ≤ n < 2048, bit by bit.
template <OwnElementary T>
T half_to_the(T n) {
  T power = T(1);
  for (int bit = 10; bit >= 0; --bit) {
    int const weight = 1 << bit;
    Element<T> factor = 1;
    for (int i = 0; i < weight; ++i) factor /= 2;
    auto const set = n >= T(weight);
    power = select(set, power * T(factor), power);
    n = select(set, n - T(weight), n);
  }
  return power;
}

}  // namespace detail

/// sech u = 1/cosh u and tanh u, u any number; ±∞ included. sech is 0 where it is below e⁻⁷⁰⁰ (float: e⁻⁸⁰).
/// Method:   float and double: e^{−|u|} and e^{−|u|} − 1 from one reduction by ln 2 and Taylor's series. Other scalars:
///           their library's cosh and tanh.
/// Error:    float and double below 1.5 ε sech u and 2.1 ε tanh u over 10⁶ arguments; measured against 257 bits, not proved.
/// Rounding: the order of operations is part of the contract; every lane has the scalar's bits.
template <Real T>
SechTanh<T> sech_tanh(T const& u) {
  using math::cosh;
  using math::tanh;
  return {T(1) / cosh(u), tanh(u)};
}

template <OwnElementary T>
SechTanh<T> sech_tanh(T const& u) {
  using math::abs;
  using math::copysign;
  using Constants = ElementaryConstants<Element<T>>;
  auto const beyond = abs(u) > T(Constants::largest_exponent);
  T const a = select(beyond, T(0), abs(u));
  T const n = nearest_integer(T(a * T(Constants::one_over_ln2)));
  T const r = (n * T(Constants::ln2.value) - a) + n * T(Constants::ln2.error);
  T const scale = detail::half_to_the(n);
  T const change = scale * (r + r * r * power_sum(detail::ExponentialSeries<Element<T>>::coefficients, r));
  T const e = scale + change, less_one = (scale - T(1)) + change;

  T const below = T(1) + e * e;
  T const sech = T(2) * e / below, tanh = -(less_one * (T(1) + e)) / below;
  return {select(beyond, T(0), sech), copysign(select(beyond, T(1), tanh), u)};
}

}  // namespace brouwer
