#pragma once
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>

#include <brouwer/scalar/double_double.hpp>
#include <brouwer/special/elementary.hpp>

namespace brouwer {

/// Operations by kind. Signs, absolute values and selects are moves and are not counted.
struct Operations {
  std::int64_t additions = 0;  ///< and subtractions
  std::int64_t multiplications = 0;
  std::int64_t divisions = 0;
  std::int64_t roots = 0;
  std::int64_t fused = 0;        ///< multiply-adds rounded once: double-double has them
  std::int64_t comparisons = 0;  ///< maximum and minimum included

  /// A fused operation is two; a comparison is none.
  std::int64_t flops() const { return additions + multiplications + divisions + roots + 2 * fused; }
  bool operator==(Operations const&) const = default;
};

/// A number that counts what is done with it and is otherwise an E, bit for bit: put into a stepper's template, it says
/// what a step costs. Constructors of steppers count as well: reset `done` behind them.
template <class E>
class Counting {
 public:
  /// By this thread, since it was last set.
  static inline thread_local Operations done{};

  constexpr Counting() = default;
  constexpr Counting(E value) : value_(value) {}  // NOLINT: a number is a number
  template <std::integral I>
  constexpr Counting(I value) : value_(static_cast<E>(value)) {}  // NOLINT
  /// Rounded once where E is narrower.
  template <class U>
  requires(std::constructible_from<E, U> && !std::same_as<U, E> &&
           !std::integral<U>) constexpr explicit Counting(U const& value)
      : value_(static_cast<E>(value)) {}
  template <class U>
  requires std::same_as<U, DoubleDouble<Counting>>
  explicit Counting(U const& value) : value_(value.high().value()) {}

  constexpr E value() const { return value_; }
  template <class U>
  requires std::constructible_from<U, E>
  constexpr explicit operator U() const { return static_cast<U>(value_); }

  friend Counting operator-(Counting a) { return -a.value_; }
  friend Counting operator+(Counting a, Counting b) { return ++done.additions, a.value_ + b.value_; }
  friend Counting operator-(Counting a, Counting b) { return ++done.additions, a.value_ - b.value_; }
  friend Counting operator*(Counting a, Counting b) { return ++done.multiplications, a.value_ * b.value_; }
  friend Counting operator/(Counting a, Counting b) { return ++done.divisions, a.value_ / b.value_; }
  Counting& operator+=(Counting b) { return *this = *this + b; }
  Counting& operator-=(Counting b) { return *this = *this - b; }
  Counting& operator*=(Counting b) { return *this = *this * b; }
  Counting& operator/=(Counting b) { return *this = *this / b; }

  friend bool operator==(Counting a, Counting b) { return ++done.comparisons, a.value_ == b.value_; }
  friend std::partial_ordering operator<=>(Counting a, Counting b) { return ++done.comparisons, a.value_ <=> b.value_; }

  friend Counting sqrt(Counting a) { return ++done.roots, std::sqrt(a.value_); }
  friend Counting fma(Counting a, Counting b, Counting c) {
    return ++done.fused, std::fma(a.value_, b.value_, c.value_);
  }
  friend Counting abs(Counting a) { return std::abs(a.value_); }
  friend Counting copysign(Counting a, Counting b) { return std::copysign(a.value_, b.value_); }
  // What calls a library is not counted: it has no operations of ours.
  friend Counting floor(Counting a) { return std::floor(a.value_); }
  friend Counting ldexp(Counting a, int exponent) { return std::ldexp(a.value_, exponent); }
  friend Counting sin(Counting a) { return std::sin(a.value_); }
  friend Counting cos(Counting a) { return std::cos(a.value_); }
  friend Counting cosh(Counting a) { return std::cosh(a.value_); }
  friend Counting tanh(Counting a) { return std::tanh(a.value_); }
  friend Counting atan2(Counting y, Counting x) { return std::atan2(y.value_, x.value_); }

 private:
  E value_{};
};

/// One number, whose tables and constants are E's.
template <class E>
struct Lanes<Counting<E>> {
  using Element = E;
  static constexpr int count = 1;
  static E get(Counting<E> a, int) { return a.value(); }
  static void set(Counting<E>& a, int, E value) { a = value; }
};
template <class E>
struct Lanes<DoubleDouble<Counting<E>>> {
  using Element = DoubleDouble<E>;
  static constexpr int count = 1;
  static Element get(DoubleDouble<Counting<E>> const& a, int) {
    return Element(Exact<E>{a.high().value(), a.low().value()});
  }
  static void set(DoubleDouble<Counting<E>>& a, int, Element const& value) {
    a = DoubleDouble<Counting<E>>(Exact<Counting<E>>{value.high(), value.low()});
  }
};

}  // namespace brouwer

template <class E>
struct std::numeric_limits<brouwer::Counting<E>> : std::numeric_limits<E> {};

template <class E>
struct Eigen::NumTraits<brouwer::Counting<E>> : brouwer::EigenTraits<brouwer::Counting<E>, 1, 1, 1> {};
