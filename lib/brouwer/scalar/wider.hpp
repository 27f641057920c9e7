#pragma once
#include <type_traits>

#include <brouwer/scalar/float128.hpp>
#include <brouwer/scalar/mpfr.hpp>

namespace brouwer {

namespace detail {
template <int Bits>
struct WiderThanBits {
  static constexpr unsigned next = Bits <= 128 ? 256 : Bits <= 257 ? 512 : 1024;
  using type = std::conditional_t<(Bits <= 64), Float128, Mpfr<next>>;
};
}  // namespace detail

/// Specialised where more than the bits decide.
template <class T>
struct WiderThan : detail::WiderThanBits<significand_bits<T>> {};

/// The arithmetic in which constants of T are computed before they are rounded to it once, and in which errors
/// of T are judged: Float128 for the built-in types, about twice the bits for the others.
/// Mpfr<512> and wider are judged in Mpfr<1024>.
template <class T>
using Wider = typename WiderThan<T>::type;

/// Rounds to T once. From a narrower type this is exact.
template <class T, class From>
T rounded(From const& x) {
  return static_cast<T>(x);
}

}  // namespace brouwer
