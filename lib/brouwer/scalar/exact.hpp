#pragma once
#include <cmath>

#include <brouwer/scalar/real.hpp>

namespace brouwer {

/// A value and what was lost when it was rounded: value + error is exact.
template <class T>
struct Exact {
  T value, error;
};

/// a + b = value + error exactly, in any order of magnitude; 6 operations.
/// D. E. Knuth, The Art of Computer Programming 2, 4.2.2, theorem B; holds in round-to-nearest without overflow.
template <Real T>
[[gnu::always_inline]] inline Exact<T> two_sum(T const& a, T const& b) {
  T const sum = a + b;
  T const b_seen = sum - a;
  T const a_seen = sum - b_seen;
  return {sum, (a - a_seen) + (b - b_seen)};
}

/// a − b = value + error exactly; bit for bit two_sum(a, −b), without the negation.
template <Real T>
[[gnu::always_inline]] inline Exact<T> two_difference(T const& a, T const& b) {
  T const difference = a - b;
  T const b_seen = difference - a;  // −b, nearly
  T const a_seen = difference - b_seen;
  return {difference, (a - a_seen) - (b + b_seen)};
}

/// a + b = value + error exactly where |a| ≥ |b| or a = 0; 3 operations.
/// T. J. Dekker, Numer. Math. 18 (1971) 224.
template <Real T>
[[gnu::always_inline]] inline Exact<T> fast_two_sum(T const& a, T const& b) {
  T const sum = a + b;
  return {sum, b - (sum - a)};
}

/// a · b + c rounded once. The library fuses nowhere but in two_prod and in double-double arithmetic.
template <Real T>
[[gnu::always_inline]] inline T fused_add(T const& a, T const& b, T const& c) {
  using std::fma;
  return fma(a, b, c);
}

/// a · b − c rounded once.
template <Real T>
[[gnu::always_inline]] inline T fused_subtract(T const& a, T const& b, T const& c) {
  using std::fma;
  return fma(a, b, -c);
}

/// a · b = value + error exactly, by one fused multiply-add; holds unless the error underflows.
template <Real T>
[[gnu::always_inline]] inline Exact<T> two_prod(T const& a, T const& b) {
  T const product = a * b;
  return {product, fused_subtract(a, b, product)};
}

}  // namespace brouwer
