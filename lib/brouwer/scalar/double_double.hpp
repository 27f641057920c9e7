#pragma once
#include <boost/multiprecision/number.hpp>
#include <cmath>
#include <concepts>
#include <limits>
#include <ostream>

#include <brouwer/scalar/exact.hpp>
#include <brouwer/scalar/float128.hpp>
#include <brouwer/scalar/pack.hpp>
#include <brouwer/scalar/wider.hpp>

namespace brouwer {

namespace detail {

/// The built-in floating-point types and Boost's: the numbers that are not packs.
template <class U>
concept Floating = std::floating_point<U> ||
    (boost::multiprecision::is_number<U>::value&& boost::multiprecision::number_category<U>::value ==
     boost::multiprecision::number_kind_floating_point);

/// Floating numbers that hold more than a T, or all that it holds.
template <class U, class T>
concept FloatingWiderThan = Floating<U> && std::numeric_limits<U>::digits > std::numeric_limits<T>::digits;

/// What a T holds exactly whatever its value is: operations with it are cheaper than with another double-double.
template <class P, class T>
concept Plain = std::same_as<P, T> || std::same_as<P, Element<T>> ||
    (std::integral<P>&& std::numeric_limits<P>::digits <= std::numeric_limits<T>::digits);

}  // namespace detail

/// An unevaluated sum high + low of two T, a double or a pack of them: about 107 bits from operations on 53. Normalised:
/// high is the sum rounded to nearest, so that it is also the correctly rounded double.
///
/// The order of operations is written out and is part of the contract; a lane of a pack is bit for bit the scalar.
/// Relative errors are bounded in units of u² = 2⁻¹⁰⁶ (u = 2^−p, p the bits of T), where nothing over- or underflows:
/// low parts are u times smaller than their number, so that results below 2⁻⁹⁶⁹ lose bits. Operations with a plain T or
/// an int are the cheaper ones. Zero results may lose their sign. Overflow, and any operation with an infinity or NaN,
/// gives ±∞ or NaN, and at the latest the next operation NaN: comparisons are false and iterations end.
///
/// M. Joldes, J.-M. Muller, V. Popescu, ACM Trans. Math. Softw. 44 (2017) 15res [JMP]; bounds as corrected and proved in
/// Coq by J.-M. Muller, L. Rideau, ACM Trans. Math. Softw. 48 (2022) 9 [MR].
template <class T>
class DoubleDouble {
 public:
  using Part = T;

  DoubleDouble() = default;
  /// Exact.
  DoubleDouble(T const& a) : high_(a), low_(0) {}  // NOLINT: a T is a double-double
  /// Exact: an integer of more bits than a T has is cut in two.
  template <std::integral I>
  DoubleDouble(I a)  // NOLINT
      : DoubleDouble(of_integer(a)) {}
  /// high = value, low = error, which must be normalised.
  explicit DoubleDouble(Exact<T> const& parts) : high_(parts.value), low_(parts.error) {}
  /// Rounded to nearest: high to nearest, low to the nearest of the rest.
  template <detail::FloatingWiderThan<T> W>
  requires(lanes<T> == 1) explicit DoubleDouble(W const& a) : DoubleDouble(split(a)) {}
  /// The same number in every lane, rounded as above.
  template <class U>
  requires(lanes<T> > 1 && !std::integral<U> &&
           std::constructible_from<DoubleDouble<Element<T>>, U>) explicit DoubleDouble(U const& a)
      : high_(DoubleDouble<Element<T>>(a).high()), low_(DoubleDouble<Element<T>>(a).low()) {}
  /// Lane by lane, rounded as above.
  template <class U, int N>
  requires(N == lanes<T> && !std::same_as<Pack<U, N>, T>) explicit DoubleDouble(Pack<U, N> const& a) {
    for (int i = 0; i < N; ++i) {
      DoubleDouble<Element<T>> const each(a[i]);
      high_.set(i, each.high());
      low_.set(i, each.low());
    }
  }

  T const& high() const { return high_; }
  T const& low() const { return low_; }

  /// Rounded to nearest: exact where the parts are not too far apart for W.
  template <detail::Floating W>
  requires(lanes<T> == 1 && (std::same_as<W, T> || detail::FloatingWiderThan<W, T>)) explicit operator W() const {
    if constexpr (std::same_as<W, T>)
      return high_;
    else
      return W(W(high_) + W(low_));
  }
  /// Towards zero.
  template <std::integral I>
  requires(lanes<T> == 1) explicit operator I() const { return static_cast<I>(static_cast<Float128>(*this)); }
  template <class W, int N>
  requires(lanes<T> == N && detail::Floating<W>) explicit operator Pack<W, N>() const {
    if constexpr (std::same_as<Pack<W, N>, T>) {
      return high_;
    } else {
      Pack<W, N> result;
      for (int i = 0; i < N; ++i) result.set(i, static_cast<W>(lane(*this, i)));
      return result;
    }
  }

  [[gnu::always_inline]] friend DoubleDouble operator-(DoubleDouble const& a) {
    return DoubleDouble(Exact<T>{-a.high_, -a.low_});
  }

  /// 20 operations. JMP algorithm 6 (AccurateDWPlusDW), theorem 3.1; MR: error < 3u² + 13u³, nearly attained.
  [[gnu::always_inline]] friend DoubleDouble operator+(DoubleDouble const& a, DoubleDouble const& b) {
    return sum(two_sum(a.high_, b.high_), two_sum(a.low_, b.low_));
  }
  /// a + (−b), bit for bit.
  [[gnu::always_inline]] friend DoubleDouble operator-(DoubleDouble const& a, DoubleDouble const& b) {
    return sum(two_difference(a.high_, b.high_), two_difference(a.low_, b.low_));
  }

  /// 8 operations, two of them fused. JMP algorithm 11 (DWTimesDW2); error < 5u², MR theorem 2.7. (Algorithm 12, with
  /// a_l b_l and 4u², has one operation more and a longer chain: a tenth slower in a discrete Moser–Veselov step.)
  [[gnu::always_inline]] friend DoubleDouble operator*(DoubleDouble const& a, DoubleDouble const& b) {
    auto const main = two_prod(a.high_, b.high_);
    T const cross = fused_add(a.low_, b.high_, T(a.high_ * b.low_));
    return DoubleDouble(fast_two_sum(main.value, T(main.error + cross)));
  }

  /// 8 operations, two of them divisions. JMP algorithm 17 (DWDivDW2; theorem 7.1: error < 15u² + 56u³) without the
  /// roundings that fused operations save: with q = RN(a_h/b_h), a_h − q b_h is a T, and a_l − q b_l is rounded once.
  /// Error < 11u² + O(u³): relative to |a/b|, |a_h − q b_h| ≤ u and |a_l − q b_l| ≤ 2u + u², rounded with 2u²; their sum,
  /// at most 3u + …, rounded with 3u²; divided by b_h for b, 3u², and rounded, 3u².
  [[gnu::always_inline]] friend DoubleDouble operator/(DoubleDouble const& a, DoubleDouble const& b) {
    T const quotient = a.high_ / b.high_;
    T const excess = fused_subtract(quotient, b.high_, a.high_) + fused_subtract(quotient, b.low_, a.low_);
    return DoubleDouble(fast_two_sum(quotient, T(-(excess / b.high_))));
  }

  /// 10 operations; the bits of a + DoubleDouble(b). JMP algorithm 4 (DWPlusFP), theorem 2.2: error < 2u².
  template <detail::Plain<T> P>
  [[gnu::always_inline]] friend DoubleDouble operator+(DoubleDouble const& a, P const& b) {
    return sum(two_sum(a.high_, T(b)), a.low_);
  }
  template <detail::Plain<T> P>
  [[gnu::always_inline]] friend DoubleDouble operator+(P const& a, DoubleDouble const& b) {
    return sum(two_sum(T(a), b.high_), b.low_);
  }
  template <detail::Plain<T> P>
  [[gnu::always_inline]] friend DoubleDouble operator-(DoubleDouble const& a, P const& b) {
    return sum(two_difference(a.high_, T(b)), a.low_);
  }
  template <detail::Plain<T> P>
  [[gnu::always_inline]] friend DoubleDouble operator-(P const& a, DoubleDouble const& b) {
    return sum(two_difference(T(a), b.high_), T(-b.low_));
  }

  /// 6 operations. JMP algorithm 9 (DWTimesFP3), theorem 4.3: error < 2u². Exact for powers of two.
  template <detail::Plain<T> P>
  [[gnu::always_inline]] friend DoubleDouble operator*(DoubleDouble const& a, P const& b) {
    T const factor(b);
    auto const main = two_prod(a.high_, factor);
    return DoubleDouble(fast_two_sum(main.value, fused_add(a.low_, factor, main.error)));
  }
  template <detail::Plain<T> P>
  [[gnu::always_inline]] friend DoubleDouble operator*(P const& a, DoubleDouble const& b) {
    return b * a;
  }

  /// 7 operations; the bits of a / DoubleDouble(b). JMP algorithm 15 (DWDivFP3), theorem 6.2: error < 3u².
  template <detail::Plain<T> P>
  [[gnu::always_inline]] friend DoubleDouble operator/(DoubleDouble const& a, P const& b) {
    T const divisor(b), quotient = a.high_ / divisor;
    T const excess = fused_subtract(quotient, divisor, a.high_) - a.low_;
    return DoubleDouble(fast_two_sum(quotient, T(-(excess / divisor))));
  }

  template <class U>
  DoubleDouble& operator+=(U const& b) {
    return *this = *this + b;
  }
  template <class U>
  DoubleDouble& operator-=(U const& b) {
    return *this = *this - b;
  }
  template <class U>
  DoubleDouble& operator*=(U const& b) {
    return *this = *this * b;
  }
  template <class U>
  DoubleDouble& operator/=(U const& b) {
    return *this = *this / b;
  }

  // Normalised numbers compare by high parts, then by low ones.
  friend Mask<T> operator<(DoubleDouble const& a, DoubleDouble const& b) {
    return either(a.high_ < b.high_, both(a.high_ == b.high_, a.low_ < b.low_));
  }
  friend Mask<T> operator<=(DoubleDouble const& a, DoubleDouble const& b) {
    return either(a.high_ < b.high_, both(a.high_ == b.high_, a.low_ <= b.low_));
  }
  friend Mask<T> operator>(DoubleDouble const& a, DoubleDouble const& b) { return b < a; }
  friend Mask<T> operator>=(DoubleDouble const& a, DoubleDouble const& b) { return b <= a; }
  friend Mask<T> operator==(DoubleDouble const& a, DoubleDouble const& b) {
    return both(a.high_ == b.high_, a.low_ == b.low_);
  }
  friend Mask<T> operator!=(DoubleDouble const& a, DoubleDouble const& b) { return negated(a == b); }

  friend std::ostream& operator<<(std::ostream& out, DoubleDouble const& a) {
    return out << a.high_ << " + " << a.low_;
  }

 private:
  /// The exact sums of the high and of the low parts, put together.
  [[gnu::always_inline]] static DoubleDouble sum(Exact<T> const& high, Exact<T> const& low) {
    auto const main = fast_two_sum(high.value, T(high.error + low.value));
    return DoubleDouble(fast_two_sum(main.value, T(low.error + main.error)));
  }
  [[gnu::always_inline]] static DoubleDouble sum(Exact<T> const& high, T const& low) {
    return DoubleDouble(fast_two_sum(high.value, T(low + high.error)));
  }

  /// The rest rounds up to half an ulp of high where it is just below: fast_two_sum then takes the even neighbour.
  template <class W>
  static DoubleDouble split(W const& a) {
    using math::abs;
    T const high = static_cast<T>(a);
    if (!(abs(high) <= std::numeric_limits<T>::max())) return high;
    return DoubleDouble(fast_two_sum(high, T(static_cast<T>(W(a - W(high))) + T(0))));  // + 0: Boost gives −0
  }

  template <class I>
  static DoubleDouble of_integer(I a) {
    if constexpr (detail::Plain<I, T>) {
      return T(a);
    } else {
      constexpr int half = std::numeric_limits<I>::digits / 2;
      I const upper = a >> half, lower = a - (upper << half);
      using E = Element<T>;
      return DoubleDouble(T(std::ldexp(E(upper), half))) + DoubleDouble(T(E(lower)));
    }
  }

  T high_, low_;
};

// --- functions --------------------------------------------------------------------------------------------------------

/// Lane by lane; for single numbers the general select does.
template <class T>
requires(!std::same_as<Mask<T>, bool>) DoubleDouble<T> select(Mask<T> const& mask, DoubleDouble<T> const& yes,
                                                              DoubleDouble<T> const& no) {
  return DoubleDouble<T>(Exact<T>{select(mask, yes.high(), no.high()), select(mask, yes.low(), no.low())});
}

template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> abs(DoubleDouble<T> const& a) {
  using math::abs;
  return DoubleDouble<T>(Exact<T>{abs(a.high()), select(a.high() < T(0), T(-a.low()), a.low())});
}

/// |a| with the sign of b.
template <class T>
DoubleDouble<T> copysign(DoubleDouble<T> const& a, DoubleDouble<T> const& b) {
  using std::copysign;
  T const high = copysign(a.high(), b.high()), turn = copysign(T(1), a.high()) * copysign(T(1), b.high());
  return DoubleDouble<T>(Exact<T>{high, turn * a.low()});
}

/// 7 operations. With a_h in [1, 2) the neglected a_l² is at most u², and the rounding of (a_h² − RN(a_h²)) + 2a_h a_l,
/// below 4u where a_h² < 2 and below 6u elsewhere, at most 2u² or 4u²: error < 3u² + O(u³).
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> squared(DoubleDouble<T> const& a) {
  auto const main = two_prod(a.high(), a.high());
  return DoubleDouble<T>(fast_two_sum(main.value, fused_add(T(a.low() + a.low()), a.high(), main.error)));
}

/// 8 operations, of them a root and a division. V. Lefèvre, N. Louvet, J.-M. Muller, J. Picot, L. Rideau, ACM Trans. Math.
/// Softw. 49 (2023) 1, algorithm 8 (SQRTDWtoDW): error < 25/8 u². √0 = 0; NaN below.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> sqrt(DoubleDouble<T> const& a) {
  using math::sqrt;
  T const root = sqrt(a.high());
  T const rest = a.low() - fused_subtract(root, root, a.high());
  return DoubleDouble<T>(fast_two_sum(root, select(a.high() > T(0), T(rest / (root + root)), T(0))));
}

/// Exact.
template <class T>
DoubleDouble<T> floor(DoubleDouble<T> const& a) {
  using std::floor;
  T const high = floor(a.high());
  return DoubleDouble<T>(fast_two_sum(high, select(high == a.high(), T(floor(a.low())), T(0))));
}

/// a · 2^exponent, exact.
template <class T>
DoubleDouble<T> ldexp(DoubleDouble<T> const& a, int exponent) {
  using std::ldexp;
  return DoubleDouble<T>(Exact<T>{ldexp(a.high(), exponent), ldexp(a.low(), exponent)});
}

namespace detail {
/// f lane by lane in binary128, whose 113 bits are more than two doubles' in most cases: accurate, and slow.
template <class T, class F, class... A>
T by_float128(F f, A const&... a) {
  return from_lanes<T>([&](int i) { return Element<T>(Float128(f(static_cast<Float128>(lane(a, i))...))); });
}
}  // namespace detail

// Transcendental functions go through binary128 (libquadmath): error about 2⁻¹¹² and the rounding to double-double.
template <class T>
DoubleDouble<T> sin(DoubleDouble<T> const& a) {
  return detail::by_float128<DoubleDouble<T>>([](Float128 const& x) { return sin(x); }, a);
}
template <class T>
DoubleDouble<T> cos(DoubleDouble<T> const& a) {
  return detail::by_float128<DoubleDouble<T>>([](Float128 const& x) { return cos(x); }, a);
}
template <class T>
DoubleDouble<T> cosh(DoubleDouble<T> const& a) {
  return detail::by_float128<DoubleDouble<T>>([](Float128 const& x) { return cosh(x); }, a);
}
template <class T>
DoubleDouble<T> tanh(DoubleDouble<T> const& a) {
  return detail::by_float128<DoubleDouble<T>>([](Float128 const& x) { return tanh(x); }, a);
}
template <class T>
DoubleDouble<T> atan2(DoubleDouble<T> const& y, DoubleDouble<T> const& x) {
  return detail::by_float128<DoubleDouble<T>>([](Float128 const& b, Float128 const& a) { return atan2(b, a); }, y, x);
}
template <class T>
DoubleDouble<T> pow(DoubleDouble<T> const& a, DoubleDouble<T> const& b) {
  return detail::by_float128<DoubleDouble<T>>([](Float128 const& x, Float128 const& y) { return pow(x, y); }, a, b);
}

// --- lanes ------------------------------------------------------------------------------------------------------------

/// A double-double of packs is a pack of double-doubles; a pack of double-doubles is not needed.
template <class T>
struct HighPart<DoubleDouble<T>> {
  using type = T;
};

template <class T, int N>
struct Lanes<DoubleDouble<Pack<T, N>>> {
  using Element = DoubleDouble<T>;
  static constexpr int count = N;
  static Element get(DoubleDouble<Pack<T, N>> const& a, int i) { return Element(Exact<T>{a.high()[i], a.low()[i]}); }
  static void set(DoubleDouble<Pack<T, N>>& a, int i, Element const& value) {
    Pack<T, N> high = a.high(), low = a.low();
    high.set(i, value.high());
    low.set(i, value.low());
    a = DoubleDouble<Pack<T, N>>(Exact<Pack<T, N>>{high, low});
  }
};

template <class T, int N>
struct WiderThan<DoubleDouble<Pack<T, N>>> {
  using type = Pack<Wider<DoubleDouble<T>>, N>;
};

}  // namespace brouwer

/// Two parts hold every number of 2p bits: ε is 2^(1−2p), in units of which +, ×, ÷ and √ err by at most 1.5, 2.5, 5.5
/// and 1.6. (Some hold more: 1 + 2⁻¹⁰⁰⁰ is one.)
template <class T>
struct std::numeric_limits<brouwer::DoubleDouble<T>> : std::numeric_limits<T> {
  using DoubleDouble = brouwer::DoubleDouble<T>;
  using Base = std::numeric_limits<T>;
  static constexpr int digits = 2 * Base::digits;
  static constexpr int digits10 = (digits - 1) * 301 / 1000;
  static constexpr int max_digits10 = 2 + digits * 302 / 1000;
  static constexpr int min_exponent = Base::min_exponent + Base::digits;
  static constexpr bool is_iec559 = false;
  static DoubleDouble epsilon() { return DoubleDouble(T(Base::epsilon() * Base::epsilon() / T(2))); }
  static DoubleDouble infinity() { return DoubleDouble(Base::infinity()); }
  static DoubleDouble quiet_NaN() { return DoubleDouble(Base::quiet_NaN()); }
  /// The smallest power of two whose low parts do not underflow.
  static DoubleDouble min() { return DoubleDouble(T(Base::min() / Base::epsilon() * T(2))); }
  static DoubleDouble max() {
    return DoubleDouble(brouwer::Exact<T>{Base::max(), T(Base::max() * (Base::epsilon() / T(4)))});
  }
  static DoubleDouble lowest() { return -max(); }
};

template <class T>
struct Eigen::NumTraits<brouwer::DoubleDouble<T>> : brouwer::EigenTraits<brouwer::DoubleDouble<T>, 2, 20, 9> {};
