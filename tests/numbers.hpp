#pragma once
#include <brouwer/scalar/wider.hpp>
#include <random>

// What the numerical tests share: the judge's arithmetic, reproducible random numbers, errors in ulps.
namespace brouwer::testing_support {

/// 77 decimal digits: more than the 50 that every claim is tested against.
using Judge = Mpfr<256>;

/// |computed − exact| in units of ε(T)·|exact|, that is in ulps up to a factor of two.
template <class T, class E>
double relative_ulps(T const& computed, E const& exact) {
  return static_cast<double>(E(abs(E(E(computed) - exact) / exact))) / static_cast<double>(epsilon<T>());
}

/// |computed − exact| in units of ε(T), for functions of size one.
template <class T, class E>
double absolute_ulps(T const& computed, E const& exact) {
  return static_cast<double>(E(abs(E(E(computed) - exact)))) / static_cast<double>(epsilon<T>());
}

/// Reproducible across machines: std::mt19937_64 is specified bit by bit, the standard's distributions are not.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace brouwer::testing_support
