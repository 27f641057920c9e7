#pragma once
#include <boost/multiprecision/mpfr.hpp>

#include <brouwer/scalar/real.hpp>

namespace brouwer {

namespace detail {
/// Boost counts decimal digits and rounds the bits up: the fewest digits that give at least `bits`.
constexpr unsigned bits_of_digits(unsigned digits) {
  return digits * 1000U / 301U + (digits * 1000U % 301U != 0 ? 2U : 1U);
}
constexpr unsigned digits_for_bits(unsigned bits) {
  unsigned digits = 1;
  while (bits_of_digits(digits) < bits) ++digits;
  return digits;
}
}  // namespace detail

/// MPFR number with a significand of at least `Bits` bits, on the stack, without expression templates.
/// Boost's precision is in decimal digits, so that Mpfr<256> holds 257 bits; every operation is correctly rounded to
/// those.
template <unsigned Bits>
using Mpfr = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<detail::digits_for_bits(Bits), boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

}  // namespace brouwer
