#pragma once
#include <brouwer/scalar/mpfr.hpp>
#include <brouwer/special/elementary.hpp>

namespace brouwer {

template <Real T>
struct SineCosine {
  T sin, cos;
};

namespace detail {

/// sin r = r + r³ S(r²) and cos r = 1 − r²/2 + r⁴ C(r²) for |r| ≤ π/4: Taylor's series, whose coefficients are exact
/// rationals rounded once, as long as T needs.
template <class E>
struct SineSeries {
  static constexpr double end = 0.7853982;  ///< ≥ π/4
  static constexpr std::size_t sine_terms =
      terms_of_series<E>([](std::size_t n) { return exponential_term(end, 2 * n + 3) / end; });
  static constexpr std::size_t cosine_terms =
      terms_of_series<E>([](std::size_t n) { return exponential_term(end, 2 * n + 4); });

  static constexpr auto sine = [] {
    std::array<E, sine_terms> c{};
    for (std::size_t k = 0; k < c.size(); ++k)
      c[k] = static_cast<E>((k % 2 == 0 ? -1 : 1) * reciprocal_factorial(2 * k + 3));
    return c;
  }();
  static constexpr auto cosine = [] {
    std::array<E, cosine_terms> c{};
    for (std::size_t k = 0; k < c.size(); ++k)
      c[k] = static_cast<E>((k % 2 == 0 ? 1 : -1) * reciprocal_factorial(2 * k + 4));
    return c;
  }();
};

/// x − nπ/2 as an unevaluated sum of nearly twice the bits of T: W. J. Cody, W. Waite, Software Manual for the Elementary
/// Functions (1980), with the errors of the differences kept. x − n·(first part) is exact.
template <OwnElementary T>
Exact<T> less_quarter_turns(T const& x, T const& n) {
  constexpr auto part = ElementaryConstants<Element<T>>::half_pi_parts;
  auto const second = two_sum(T(x - n * T(part[0])), T(-(n * T(part[1]))));
  auto const third = two_sum(second.value, T(-(n * T(part[2]))));
  return {third.value, (second.error + third.error) - n * T(part[3])};
}

/// Of r.value + r.error, |r| ≤ π/4.
template <OwnElementary T>
SineCosine<T> sine_cosine_of_eighth_turn(Exact<T> const& r) {
  using Series = SineSeries<Element<T>>;
  T const z = r.value * r.value, half = z / T(2), near_one = T(1) - half;
  T const s = r.value * (z * power_sum(Series::sine, z)) + r.error * near_one;
  T const c = z * z * power_sum(Series::cosine, z) - r.value * r.error;
  return {r.value + s, near_one + (((T(1) - near_one) - half) + c)};
}

/// The lanes outside the reduction's range again, by MPFR; infinity has no sine.
template <OwnElementary T>
[[gnu::cold, gnu::noinline]] SineCosine<T> reduced_in_mpfr(T x, T sine, T cosine) {
  using E = Element<T>;
  auto const patched = [&](T const& inside, auto function) {
    return from_lanes<T>([&](int i) {
      using math::abs;
      E const xi = lane(x, i);
      bool const outside = abs(xi) > ElementaryConstants<E>::largest_reduced;
      return outside ? static_cast<E>(function(Mpfr<128>(xi))) : lane(inside, i);
    });
  };
  return {patched(sine, [](Mpfr<128> const& a) { return sin(a); }),
          patched(cosine, [](Mpfr<128> const& a) { return cos(a); })};
}

}  // namespace detail

/// sin x and cos x, x in radians; NaN for NaN and ±∞, sin ±0 = ±0.
/// Method:   float and double: x − nπ/2 in nearly twice the bits, Taylor's series, exchange and signs by n mod 4; for
///           |x| > 2²⁰ (float: 2¹⁰) lane by lane by MPFR at 128 bits. Other scalars: their library's sin and cos.
/// Error:    float and double below 0.86 ulp over 1.5·10⁶ arguments (uniform, logarithmic down to denormal numbers, next to
///           multiples of π/2); measured against 257 bits, not proved.
/// Rounding: the order of operations is part of the contract; every lane has the scalar's bits.
template <Real T>
SineCosine<T> sine_cosine(T const& x) {
  using math::cos;
  using math::sin;
  return {sin(x), cos(x)};
}

template <OwnElementary T>
inline SineCosine<T> sine_cosine(T const& x) {
  using math::abs;
  using Constants = ElementaryConstants<Element<T>>;
  T const n = nearest_integer(T(x * T(Constants::two_over_pi)));
  auto const r = detail::sine_cosine_of_eighth_turn(detail::less_quarter_turns(x, n));

  T const quarter = n - T(4) * nearest_integer(T(n / T(4)));  // n mod 4 in −2 … 2
  auto const exchanged = abs(quarter) == T(1), opposite = abs(quarter) == T(2);
  T const s = select(exchanged, r.cos, r.sin), c = select(exchanged, r.sin, r.cos);
  auto const tiny = abs(x) < T(std::numeric_limits<Element<T>>::epsilon());  // x³/6 is nothing; keeps −0
  T const sine = select(tiny, x, select(either(opposite, quarter == T(-1)), T(-s), s));
  T const cosine = select(either(opposite, quarter == T(1)), T(-c), c);
  if (any(abs(x) > T(Constants::largest_reduced))) return detail::reduced_in_mpfr(x, sine, cosine);
  return {sine, cosine};
}

namespace detail {

/// arctan z = z + z³ A(z²) for |z| ≤ 5/16, Taylor's series.
template <class E>
struct ArctangentSeries {
  static constexpr double end = 5.0 / 16;
  static constexpr std::size_t terms = terms_of_series<E>([](std::size_t n) {
    double power = 1;
    for (std::size_t i = 0; i <= n; ++i) power *= end * end;
    return power / static_cast<double>(2 * n + 3);
  });
  static constexpr auto coefficients = [] {
    std::array<E, terms> c{};
    for (std::size_t k = 0; k < c.size(); ++k)
      c[k] = static_cast<E>((k % 2 == 0 ? -1.0 : 1.0) / static_cast<double>(2 * k + 3));
    return c;
  }();
};

/// The same point nearer to 1 or farther from it where the halves of its coordinates would not be exact, or their sum
/// would overflow.
template <OwnElementary T>
[[gnu::cold, gnu::noinline]] std::array<T, 2> rescaled(T small, T large, Mask<T> tiny, Mask<T> huge) {
  using E = Element<T>;
  T const up = T(1 / std::numeric_limits<E>::epsilon()), down = T(std::numeric_limits<E>::epsilon());
  T const scale = select(tiny, up, select(huge, down, T(1)));
  return {small * scale, large * scale};
}

/// arctan(small/large), 0 ≤ small ≤ large, as value + error: arctan a + arctan((t − a)/(1 + ta)) with a = 0, ½ or 1,
/// whichever is near t = small/large. The numerators are exact. 0 for 0/0.
template <OwnElementary T>
Exact<T> arctangent_of_quotient(T small, T large) {
  using E = Element<T>;
  using Constants = ElementaryConstants<E>;
  using Series = ArctangentSeries<E>;
  auto const tiny = large<T(std::numeric_limits<E>::min() * 16), huge = large> T(std::numeric_limits<E>::max() / 2);
  if (any(either(tiny, huge))) {
    auto const scaled = rescaled(small, large, tiny, huge);
    small = scaled[0];
    large = scaled[1];
  }
  auto const half = small > T(5) / T(16) * large, one = small > T(3) / T(4) * large;
  auto const near = [&](T const& none, T const& at_half, T const& at_one) {
    return select(one, at_one, select(half, at_half, none));
  };
  T const above = near(small, small - large / T(2), small - large);
  T const below = near(select(large == T(0), T(1), large), large + small / T(2), large + small);
  T const z = above / below, w = z * z;
  T const tail = z * (w * power_sum(Series::coefficients, w));

  T const anchor = near(T(0), T(Constants::arctan_half.value), T(Constants::quarter_pi.value));
  T const rest = near(T(0), T(Constants::arctan_half.error), T(Constants::quarter_pi.error));
  auto const sum = fast_two_sum(anchor, z);
  return {sum.value, sum.error + (tail + rest)};
}

/// whole − a where the mask is set.
template <OwnElementary T>
Exact<T> reflected(Mask<T> const& mask, Exact<Element<T>> const& whole, Exact<T> const& a) {
  auto const difference = fast_two_sum(T(whole.value), T(-a.value));
  return {select(mask, difference.value, a.value),
          select(mask, difference.error + (T(whole.error) - a.error), a.error)};
}

}  // namespace detail

/// The angle of the point (x, y), −π ≤ angle ≤ π radians, with the signs of zero of C's atan2; NaN for NaN and for two
/// infinities.
/// Method:   float and double: quotient of the smaller by the larger, less ½ or 1 where that is near, Taylor's series,
///           reflections in twice the bits. Other scalars: their library's atan2.
/// Error:    float and double below 0.99 ε|angle|, which is 1.5 ulp next to a power of 2, over 1.5·10⁶ points; measured
///           against 257 bits, not proved.
/// Rounding: the order of operations is part of the contract; every lane has the scalar's bits.
template <Real T>
T arctangent(T const& y, T const& x) {
  using math::atan2;
  return atan2(y, x);
}

template <OwnElementary T>
inline T arctangent(T const& y, T const& x) {
  using math::abs;
  using math::copysign;
  using Constants = ElementaryConstants<Element<T>>;
  T const up = abs(y), across = abs(x);
  auto const steep = up > across;
  // the second argument is what is not a number, if one is
  auto const first = detail::arctangent_of_quotient(smaller(across, up), larger(up, across));
  auto const quadrant = detail::reflected<T>(steep, Constants::half_pi, first);
  auto const left = copysign(T(1), x) < T(0);
  auto const angle = detail::reflected<T>(left, Constants::pi, quadrant);
  return copysign(T(angle.value + angle.error), y);
}

/// π rounded to T once.
template <Real T>
T pi() {
  if constexpr (OwnElementary<T>) {
    return T(ElementaryConstants<Element<T>>::pi.value);
  } else {
    using math::atan2;
    static T const value = atan2(T(0), T(-1));
    return value;
  }
}

}  // namespace brouwer
