#pragma once
#include <concepts>
#include <limits>
#include <ostream>

#include <brouwer/scalar/chosen_rounding.hpp>
#include <brouwer/scalar/double_double.hpp>
#include <brouwer/scalar/eigen_traits.hpp>
#include <brouwer/special/elementary.hpp>

namespace brouwer {

/// A float or double whose operations are carried out as operation_context says: each result is formed exactly, as the
/// nearest T and its error, and then rounded once by the rule. In the standard context the bits are those of T.
///
/// constants    While constants are formed (forming_constants) operations round to nearest. If the rule wants them exact,
///              +, −, ×, ÷ and √ keep value + rest, about twice the bits; conversion from wider numbers keeps the rest
///              always, but it counts only where the rule wants it. A step's operation takes value + rest of both
///              operands and leaves no rest. Our own series (elementary.hpp) remain as accurate as they are in T.
/// contraction  A product's rest is kept, too, until it is used: the next sum or difference that it is a term of takes it,
///              as std::fma would; of two products the left one's. Every other use, and the end of a step, drops it.
///              Negation keeps it. (Products below 2⁻⁹⁶⁹, 2⁻¹⁰² in float, are rounded by themselves.)
/// Error-free transformations run by the same rule: they are not error-free where it is not rounding to nearest, as on
/// hardware that rounds so. Zeros have the sign of rounding to nearest. With one
/// constant at most, sums and products are rounded correctly; what is known of quotients and roots with a constant, and of
/// operations on two, is 2⁻¹⁰⁴ of the result (2⁻⁴⁶ in float): one that is nearer to a tie may be misrounded.
///
/// Numbers only, no packs: the random numbers that a lane takes would depend on how long the others iterate.
template <class T>
class Modelled {
 public:
  Modelled() = default;
  constexpr Modelled(T const& value) : value_(value) {}  // NOLINT: a T is one
  template <std::integral I>
  constexpr Modelled(I value) : value_(static_cast<T>(value)) {}  // NOLINT
  /// Rounded to nearest; what binary128 and MPFR hold beyond T is kept as the rest.
  template <detail::FloatingWiderThan<T> W>
  constexpr explicit Modelled(W const& wide) : value_(static_cast<T>(wide)) {
    if constexpr (!std::floating_point<W>)
      if (std::isfinite(value_)) rest_ = static_cast<T>(W(wide - W(value_)));
  }

  T const& value() const { return value_; }
  T const& rest() const { return rest_; }
  /// Does the rule of this moment want them so? What is kept of constants is kept for each answer.
  static bool constants_are_exact() { return operation_context.rule.exact_constants; }
  /// Is it a product that may be fused with a sum?
  bool is_product() const { return product_; }
  /// Products are not fused across steps.
  void settle() {
    if (product_) *this = Modelled(value_);
  }

  template <detail::Floating W>
  requires(std::same_as<W, T> || detail::FloatingWiderThan<W, T>) explicit operator W() const {
    return static_cast<W>(value_);
  }
  template <std::integral I>
  explicit operator I() const {
    return static_cast<I>(value_);
  }

  friend Modelled operator-(Modelled const& a) { return Modelled(-a.value_, -a.rest_, a.product_); }
  friend Modelled operator+(Modelled const& a, Modelled const& b) { return sum(a, b.value_, b.rest_, b.product_); }
  friend Modelled operator-(Modelled const& a, Modelled const& b) { return sum(a, -b.value_, -b.rest_, b.product_); }
  friend Modelled operator*(Modelled const& a, Modelled const& b) { return product(a, b); }
  friend Modelled operator/(Modelled const& a, Modelled const& b) { return quotient(a, b); }

  Modelled& operator+=(Modelled const& b) { return *this = *this + b; }
  Modelled& operator-=(Modelled const& b) { return *this = *this - b; }
  Modelled& operator*=(Modelled const& b) { return *this = *this * b; }
  Modelled& operator/=(Modelled const& b) { return *this = *this / b; }

  friend bool operator<(Modelled const& a, Modelled const& b) { return a.value_ < b.value_; }
  friend bool operator<=(Modelled const& a, Modelled const& b) { return a.value_ <= b.value_; }
  friend bool operator>(Modelled const& a, Modelled const& b) { return a.value_ > b.value_; }
  friend bool operator>=(Modelled const& a, Modelled const& b) { return a.value_ >= b.value_; }
  friend bool operator==(Modelled const& a, Modelled const& b) { return a.value_ == b.value_; }
  friend bool operator!=(Modelled const& a, Modelled const& b) { return a.value_ != b.value_; }

  friend std::ostream& operator<<(std::ostream& out, Modelled const& a) { return out << a.value_; }

  friend Modelled abs(Modelled const& a) { return std::signbit(a.value_) ? -a : a; }
  friend Modelled copysign(Modelled const& a, Modelled const& b) {
    return std::signbit(a.value_) == std::signbit(b.value_) ? a : -a;
  }
  friend Modelled floor(Modelled const& a) { return std::floor(a.value_); }
  /// Exact in the range of normal numbers.
  friend Modelled ldexp(Modelled const& a, int exponent) {
    return Modelled(std::ldexp(a.value_, exponent), std::ldexp(a.rest_, exponent), a.product_);
  }
  friend Modelled sqrt(Modelled const& a) { return root(a); }
  /// a · b ± c rounded once, whether or not the rule contracts.
  friend Modelled fused_add(Modelled const& a, Modelled const& b, Modelled const& c) {
    T const value = a.value_ * b.value_;
    if (!exact_error_exists(value)) return T(std::fma(a.value_, b.value_, c.value_));
    return detail::chosen_sum(value, std::fma(a.value_, b.value_, -value), c.value_, T(0));
  }
  friend Modelled fused_subtract(Modelled const& a, Modelled const& b, Modelled const& c) {
    return fused_add(a, b, -c);
  }

 private:
  Modelled(T const& value, T const& rest, bool product) : value_(value), rest_(rest), product_(product) {}
  explicit Modelled(DoubleDouble<T> const& parts) : value_(parts.high()), rest_(parts.low()) {}

  /// As it counts when a constant is formed, and in a step.
  DoubleDouble<T> both() const { return DoubleDouble<T>(Exact<T>{value_, rest_}); }
  T tail() const { return operation_context.rule.exact_constants && !product_ ? rest_ : T(0); }
  static bool forming() { return operation_context.forming_constants; }
  static bool keeping() { return forming() && operation_context.rule.exact_constants; }
  static bool exact_error_exists(T const& value) {
    return std::abs(value) >= detail::least_for_exact_errors<T> && std::isfinite(value);
  }

  static Modelled sum(Modelled const& a, T const& b, T const& b_rest, bool b_is_product) {
    if (keeping()) return Modelled(a.both() + DoubleDouble<T>(Exact<T>{b, b_rest}));
    if (forming()) return T(a.value_ + b);
    bool const fuse = operation_context.rule.contraction, exact = operation_context.rule.exact_constants;
    T const b_counts = b_is_product ? (fuse && !a.product_ ? b_rest : T(0)) : exact ? b_rest : T(0);
    return detail::chosen_sum(a.value_, a.product_ ? a.rest_ : a.tail(), b, b_counts);
  }

  static Modelled product(Modelled const& a, Modelled const& b) {
    if (keeping()) return Modelled(a.both() * b.both());
    T const value = a.value_ * b.value_;
    if (forming()) return value;
    T const a_tail = a.tail(), b_tail = b.tail();
    if (!exact_error_exists(value))
      return detail::chosen_in_binary128(
          value,
          [&](Float128 const& x, Float128 const& y) {
            return Float128((x + Float128(a_tail)) * (y + Float128(b_tail)));
          },
          a.value_, b.value_);
    Exact<T> const exact = with_tails({value, std::fma(a.value_, b.value_, -value)}, a, a_tail, b, b_tail);
    T const rounded = detail::chosen(exact.value, exact.error);
    if (!operation_context.rule.contraction) return rounded;
    return Modelled(rounded, (exact.value - rounded) + exact.error, true);
  }

  /// a b + a·b_tail + b·a_tail + a_tail·b_tail
  static Exact<T> with_tails(Exact<T> const& main, Modelled const& a, T const& a_tail, Modelled const& b,
                             T const& b_tail) {
    if (a_tail == 0 && b_tail == 0) return main;
    auto const left = two_prod(a.value_, b_tail), right = two_prod(b.value_, a_tail);
    auto const cross = two_sum(left.value, right.value);
    auto const low = two_sum(main.error, cross.value);
    T const least = detail::to_odd(T(left.error + right.error), T(cross.error + a_tail * b_tail));
    return two_sum(main.value, detail::to_odd(low.value, detail::to_odd(low.error, least)));
  }

  static Modelled quotient(Modelled const& a, Modelled const& b) {
    if (keeping()) return Modelled(a.both() / b.both());
    T const value = a.value_ / b.value_;
    if (forming()) return value;
    T const a_tail = a.tail(), b_tail = b.tail();
    if (!exact_error_exists(value) || !exact_error_exists(a.value_) || !exact_error_exists(b.value_))
      return detail::chosen_in_binary128(
          value,
          [&](Float128 const& x, Float128 const& y) {
            return Float128((x + Float128(a_tail)) / (y + Float128(b_tail)));
          },
          a.value_, b.value_);
    T const remainder = std::fma(-value, b.value_, a.value_);
    return corrected(value, T((remainder + (a_tail - value * b_tail)) / b.value_), a_tail != 0 || b_tail != 0);
  }

  static Modelled root(Modelled const& a) {
    if (keeping()) return Modelled(sqrt(a.both()));
    T const value = std::sqrt(a.value_);
    if (forming()) return value;
    T const a_tail = a.tail();
    if (!exact_error_exists(a.value_))
      return detail::chosen_in_binary128(
          value, [&](Float128 const& x) { return Float128(sqrt(Float128(x + Float128(a_tail)))); }, a.value_);
    return corrected(value, T((std::fma(-value, value, a.value_) + a_tail) / (value + value)), a_tail != 0);
  }

  /// value + error, where tails may have moved the nearest number.
  static Modelled corrected(T const& value, T const& error, bool tails) {
    auto const exact = tails ? fast_two_sum(value, error) : Exact<T>{value, error};
    return detail::chosen(exact.value, exact.error);
  }

  T value_ = 0, rest_ = 0;
  bool product_ = false;
};

namespace detail {
/// What the machine's library gives where it is asked unasked; by binary128 and the rule elsewhere.
template <class T, class F, class... A>
Modelled<T> function_of(F f, Modelled<T> const& first, A const&... others) {
  auto const& context = operation_context;
  if (context.rule.standard()) return T(f(first.value(), others.value()...));
  auto const wide = [&](Modelled<T> const& a) {
    bool const counts = context.rule.exact_constants && !a.is_product();
    return Float128(Float128(a.value()) + Float128(counts ? a.rest() : T(0)));
  };
  Float128 const exact = f(wide(first), wide(others)...);
  if (!context.forming_constants) return isfinite(exact) ? Modelled<T>(chosen_of<T>(exact)) : static_cast<T>(exact);
  return context.rule.exact_constants ? Modelled<T>(exact) : Modelled<T>(static_cast<T>(exact));
}
}  // namespace detail

// clang-format off
template <class T> Modelled<T> sin(Modelled<T> const& a) { return detail::function_of([](auto const& x) { using std::sin; return sin(x); }, a); }
template <class T> Modelled<T> cos(Modelled<T> const& a) { return detail::function_of([](auto const& x) { using std::cos; return cos(x); }, a); }
template <class T> Modelled<T> cosh(Modelled<T> const& a) { return detail::function_of([](auto const& x) { using std::cosh; return cosh(x); }, a); }
template <class T> Modelled<T> tanh(Modelled<T> const& a) { return detail::function_of([](auto const& x) { using std::tanh; return tanh(x); }, a); }
template <class T> Modelled<T> atan2(Modelled<T> const& y, Modelled<T> const& x) { return detail::function_of([](auto const& b, auto const& a) { using std::atan2; return atan2(b, a); }, y, x); }
template <class T> Modelled<T> pow(Modelled<T> const& a, Modelled<T> const& b) { return detail::function_of([](auto const& x, auto const& y) { using std::pow; return pow(x, y); }, a, b); }
// clang-format on

/// Their elementary functions are those of T, operation by operation.
template <class T>
struct ElementaryConstants<Modelled<T>> : ElementaryConstants<T> {
  static constexpr Exact<Modelled<T>> of(Exact<T> const& pair) { return {pair.value, pair.error}; }
  static constexpr Exact<Modelled<T>> pi = of(ElementaryConstants<T>::pi);
  static constexpr Exact<Modelled<T>> half_pi = of(ElementaryConstants<T>::half_pi);
};

/// By the exact function: adding and subtracting a large number finds the nearest integer in one rounding only.
template <class T>
Modelled<T> nearest_integer(Modelled<T> const& a) {
  return std::nearbyint(a.value());
}

}  // namespace brouwer

template <class T>
struct std::numeric_limits<brouwer::Modelled<T>> : std::numeric_limits<T> {};

template <class T>
struct Eigen::NumTraits<brouwer::Modelled<T>> : brouwer::EigenTraits<brouwer::Modelled<T>, 3, 20, 20> {};
