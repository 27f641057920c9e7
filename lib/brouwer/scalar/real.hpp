#pragma once
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>

namespace brouwer {

/// What a comparison of two scalars gives: bool for one number, one flag a lane for a pack of them.
template <class T>
using Mask = decltype(std::declval<T>() < std::declval<T>());

/// Functions of a scalar by one name: the standard's for the built-in types; Boost's and our own types
/// bring theirs by argument-dependent look-up.
namespace math {
using std::abs;
using std::atan2;
using std::copysign;
using std::cos;
using std::cosh;
using std::sin;
using std::sqrt;
using std::tanh;
}  // namespace math

// A number is a pack of one lane. Packs overload these for their masks.
inline bool any(bool mask) { return mask; }
inline bool all(bool mask) { return mask; }
inline bool both(bool a, bool b) { return a && b; }
inline bool either(bool a, bool b) { return a || b; }
inline bool negated(bool mask) { return !mask; }
inline bool is_set(bool mask, int) { return mask; }

/// Lane by lane: `yes` where the mask is set, `no` elsewhere. Both sides have been computed.
template <class T>
T select(bool mask, T const& yes, T const& no) {
  return mask ? yes : no;
}

/// How many numbers a scalar holds side by side, and how one gets at them: one, unless it is a pack (pack.hpp).
template <class T>
struct Lanes {
  using Element = T;
  static constexpr int count = 1;
  static T const& get(T const& a, int) { return a; }
  static void set(T& a, int, T const& value) { a = value; }
};

template <class T>
using Element = typename Lanes<T>::Element;
template <class T>
inline constexpr int lanes = Lanes<T>::count;

template <class T>
Element<T> lane(T const& a, int i) {
  return Lanes<T>::get(a, i);
}

/// The scalar whose lane i is f(i), for what is decided number by number, in constructors.
template <class T, class F>
T from_lanes(F f) {
  T a{};
  for (int i = 0; i < lanes<T>; ++i) Lanes<T>::set(a, i, f(i));
  return a;
}

/// A scalar we can integrate with: float, double, long double, Float128, Mpfr<N>, DoubleDouble<T>, and packs of them.
///
/// Templates over Real never branch on a comparison (`if (a < b)`): they form a mask, compute both sides and
/// `select`; a loop that iterates to convergence runs while any(active) and freezes a lane when *it* has
/// converged, so that a lane of a pack is bit-identical to the scalar run.
template <class T>
concept Real = std::copyable<T> && std::constructible_from<T, int> && requires(T a, T b) {
  { -a } -> std::convertible_to<T>;
  { a + b } -> std::convertible_to<T>;
  { a - b } -> std::convertible_to<T>;
  { a* b } -> std::convertible_to<T>;
  { a / b } -> std::convertible_to<T>;
  { select(a < b, a, b) } -> std::convertible_to<T>;
  { any(a < b) } -> std::same_as<bool>;
};

/// The leading part of a scalar that is a sum of two (double_double.hpp); void elsewhere.
template <class T>
struct HighPart {
  using type = void;
};

/// What of a scalar decides its size: the high part, or the whole.
template <class T>
using Leading = std::conditional_t<std::is_void_v<typename HighPart<T>::type>, T, typename HighPart<T>::type>;

/// a − b of numbers close to one another, as far as it decides the size.
template <class T>
Leading<T> leading_difference(T const& a, T const& b) {
  if constexpr (std::same_as<Leading<T>, T>)
    return a - b;
  else
    return (a.high() - b.high()) + (a.low() - b.low());
}

/// Unit roundoff's double: the distance from 1 to the next number, 2^(1−p).
template <class T>
T epsilon() {
  return std::numeric_limits<T>::epsilon();
}

/// Bits of the significand, p.
template <class T>
inline constexpr int significand_bits = std::numeric_limits<T>::digits;

/// The maximum by mask; the second argument wins where they are equal or unordered.
template <Real T>
T larger(T const& a, T const& b) {
  return select(a > b, a, b);
}

/// The minimum, likewise.
template <Real T>
T smaller(T const& a, T const& b) {
  return select(a < b, a, b);
}

/// +1 or −1; zero (of either sign) counts as positive.
template <Real T>
T sign_of(T const& a) {
  return select(a < T(0), T(-1), T(1));
}

template <Real T>
T squared(T const& a) {
  return a * a;
}

}  // namespace brouwer
