#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <brouwer/scalar/exact.hpp>
#include <brouwer/scalar/float128.hpp>
#include <brouwer/scalar/operation_context.hpp>

namespace brouwer::detail {

// An exact result is known as value + error: value is the result rounded to nearest, error is what that left, with the
// right sign and 0 only if nothing was left. From these the result of any rounding follows: value or its neighbour on
// the side of the error.

/// Below this size errors of products, quotients and roots would underflow: binary128 forms these results.
template <class T>
inline constexpr T least_for_exact_errors = std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon() * 2;

/// The next number above or below; ±0 is one number. From the largest to ∞.
template <class T>
T neighbour(T value, bool above) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  if (value == 0) return above ? std::numeric_limits<T>::denorm_min() : -std::numeric_limits<T>::denorm_min();
  auto const bits = std::bit_cast<Bits>(value);
  return std::bit_cast<T>(static_cast<Bits>((value > 0) == above ? bits + 1 : bits - 1));
}

/// The neighbour with the chance error/gap: the mean is the exact result, to 2⁻⁵³ of the gap.
template <class T, class E>
T at_random(T value, E const& error) {
  T const other = neighbour(value, error > 0);
  E const share = E(error / (E(other) - E(value)));
  return operation_context.random.next() < static_cast<double>(share) ? other : value;
}

/// Overflow is infinity towards it and the largest number away from it.
template <class T>
T overflowed(T infinity) {
  Rounding const rule = operation_context.rule.rounding;
  bool const cut = rule == Rounding::toward_zero || (rule == Rounding::up && infinity < 0) ||
                   (rule == Rounding::down && infinity > 0);
  return cut ? std::copysign(std::numeric_limits<T>::max(), infinity) : infinity;
}

/// value + error as the rule says; E may be wider than T.
template <class T, class E>
T chosen(T value, E const& error) {
  Rounding const rule = operation_context.rule.rounding;
  if (rule == Rounding::nearest || !(error != 0)) return value;
  switch (rule) {
    case Rounding::up:
      return error > 0 ? neighbour(value, true) : value;
    case Rounding::down:
      return error < 0 ? neighbour(value, false) : value;
    case Rounding::toward_zero:
      return value != 0 && (value > 0) != (error > 0) ? neighbour(value, value < 0) : value;
    case Rounding::stochastic:
      return at_random(value, error);
    case Rounding::nearest:
      break;
  }
  return value;
}

/// A finite result that binary128 holds, or holds so well that no rounding to T can tell.
template <class T>
[[gnu::cold, gnu::noinline]] T chosen_of(Float128 const& exact) {
  T const value = static_cast<T>(exact);
  return std::isinf(value) ? overflowed(value) : chosen(value, Float128(exact - Float128(value)));
}

/// A sum rounded to odd: if it is no number, the neighbour with an odd last bit, so that a later rounding to fewer bits
/// sees on which side of a tie it lies. S. Boldo, G. Melquiond, IEEE Trans. Comput. 57 (2008) 462.
template <class T>
T to_odd(T const& a, T const& b) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  auto const sum = two_sum(a, b);
  bool const odd = (std::bit_cast<Bits>(sum.value) & 1U) != 0;
  return sum.error == 0 || odd || !std::isfinite(sum.value) ? sum.value : neighbour(sum.value, sum.error > 0);
}

/// a + b + rest, rest being much smaller than one of the others, with the right sign of the error (Boldo and Melquiond's
/// algorithm Fma, with its two errors in the place of the product's).
template <class T>
Exact<T> sum_of_three(T const& a, T const& b, T const& rest) {
  auto const low = two_sum(b, rest);
  auto const high = two_sum(a, low.value);
  return two_sum(high.value, to_odd(high.error, low.error));
}

/// The sum of two numbers with rests.
template <class T>
T chosen_sum(T const& a, T const& a_rest, T const& b, T const& b_rest) {
  T const rest = to_odd(a_rest, b_rest);
  auto const sum = rest == 0 ? two_sum(a, b) : sum_of_three(a, b, rest);
  if (std::isfinite(sum.value)) return chosen(sum.value, sum.error);
  return std::isinf(a) || std::isinf(b) ? T(a + b) : chosen_of<T>(Float128(a) + Float128(b));
}

/// What is outside the range of exact errors, and special values: what T makes of infinities, NaN and zeros, else what
/// binary128 makes of finite numbers.
template <class T, class F, class... A>
[[gnu::cold, gnu::noinline]] T chosen_in_binary128(T plain, F exact, A const&... operands) {
  bool const finite = (std::isfinite(operands) && ...);
  if (!finite || std::isnan(plain)) return plain;
  Float128 const wide = exact(Float128(operands)...);
  if (wide == 0 || isinf(wide)) return plain;  // a zero factor, a zero divisor
  return chosen_of<T>(wide);
}

}  // namespace brouwer::detail
