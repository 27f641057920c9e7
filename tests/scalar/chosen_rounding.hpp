#pragma once
#include <mpfr.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <type_traits>

#include <brouwer/scalar/modelled.hpp>

namespace brouwer::testing {

/// So many bits that sums and products of any two doubles are exact, and no quotient or root of them is near a tie.
class Judge {
 public:
  static constexpr mpfr_prec_t bits = 2400;
  Judge() { mpfr_init2(x_, bits); }
  explicit Judge(double a) : Judge() { mpfr_set_d(x_, a, MPFR_RNDN); }
  Judge(Judge const& other) : Judge() { mpfr_set(x_, other.x_, MPFR_RNDN); }
  Judge& operator=(Judge const& other) {
    mpfr_set(x_, other.x_, MPFR_RNDN);
    return *this;
  }
  ~Judge() { mpfr_clear(x_); }

  friend Judge operator+(Judge const& a, Judge const& b) { return of(mpfr_add, a, b); }
  friend Judge operator-(Judge const& a, Judge const& b) { return of(mpfr_sub, a, b); }
  friend Judge operator*(Judge const& a, Judge const& b) { return of(mpfr_mul, a, b); }
  friend Judge operator/(Judge const& a, Judge const& b) { return of(mpfr_div, a, b); }
  friend Judge sqrt(Judge const& a) {
    Judge r;
    mpfr_sqrt(r.x_, a.x_, MPFR_RNDN);
    return r;
  }

  /// Rounded to T; subnormal numbers and overflow as IEEE 754 wants them.
  template <class T>
  T as(mpfr_rnd_t rounding) const {
    if constexpr (std::is_same_v<T, float>)
      return mpfr_get_flt(x_, rounding);
    else
      return mpfr_get_d(x_, rounding);
  }

 private:
  template <class F>
  static Judge of(F f, Judge const& a, Judge const& b) {
    Judge r;
    f(r.x_, a.x_, b.x_, MPFR_RNDN);
    return r;
  }
  mpfr_t x_;
};

/// Pairs of numbers that are hard to round: of all sizes, near one another, subnormal, of few bits.
template <class T>
class HardPairs {
 public:
  explicit HardPairs(std::uint64_t seed) : random_(seed) {}

  std::pair<T, T> next() {
    T const a = any();
    switch (random_() % 4) {
      case 0:
        return {a, any()};
      case 1:  // sums cancel
        return {a, T(-a * (1 + T(static_cast<int>(random_() % 9)) * std::numeric_limits<T>::epsilon()))};
      case 2:  // of like size
        return {a, std::ldexp(ordinary(), std::ilogb(a == 0 ? T(1) : a) + static_cast<int>(random_() % 60) - 30)};
      default:
        return {ordinary(), ordinary()};
    }
  }

  /// In ±[1, 2), half of them of 12 bits.
  T ordinary() {
    T const u =
        T(1) + std::ldexp(T(random_() >> 41U), -23) + (sizeof(T) == 8 ? std::ldexp(T(random_() >> 35U), -52) : T(0));
    T const few = random_() % 2 != 0 ? u : std::ldexp(std::floor(std::ldexp(u, 11)), -11);
    return random_() % 2 != 0 ? few : -few;
  }

  /// Any finite number.
  T any() {
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    for (;;)
      if (T const a = std::bit_cast<T>(static_cast<Bits>(random_())); std::isfinite(a)) return a;
  }

 private:
  std::mt19937_64 random_;
};

struct Case {
  Rounding rounding;
  mpfr_rnd_t judged;
};
inline constexpr Case directed_cases[] = {{Rounding::nearest, MPFR_RNDN},
                                          {Rounding::up, MPFR_RNDU},
                                          {Rounding::down, MPFR_RNDD},
                                          {Rounding::toward_zero, MPFR_RNDZ}};

inline OperationContext steps_with(OperationRule const& rule) { return {rule, false, {}}; }

}  // namespace brouwer::testing
