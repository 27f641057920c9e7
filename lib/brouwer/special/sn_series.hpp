#pragma once
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include <brouwer/scalar/wider.hpp>

namespace brouwer {

namespace detail {

/// Terms of the series that are tabulated: n = 0 … 16, each with powers 0 … ⌊n/2⌋ of π; the last bounds the tail only.
inline constexpr int sn_series_rows = 17;
inline constexpr int sn_series_columns = sn_series_rows / 2 + 1;
using SnIntegers = std::array<std::array<boost::multiprecision::cpp_int, sn_series_columns>, sn_series_rows>;

/// Integers cₙⱼ with sn(v)/v = Σₙ Σⱼ cₙⱼ σ^{n−2j} πʲ / (2n+1)!, from sn″ = −(1+k²) sn + 2k² sn³:
/// cₙ₊₁ = −σ cₙ + 2π Σ_{a+b+c=n−1} (2n+1)! / ((2a+1)!(2b+1)!(2c+1)!) cₐ c_b c_c.
inline SnIntegers sn_series_integers() {
  using boost::multiprecision::cpp_int;
  std::array<cpp_int, 2 * sn_series_rows + 2> factorial;
  factorial[0] = 1;
  for (unsigned i = 1; i < factorial.size(); ++i) factorial[i] = factorial[i - 1] * i;

  SnIntegers c{};
  c[0][0] = 1;
  for (unsigned n = 0; n + 1 < sn_series_rows; ++n) {
    for (unsigned j = 0; 2 * j <= n; ++j) c[n + 1][j] -= c[n][j];
    for (unsigned p = 0; p < n; ++p)
      for (unsigned q = 0; p + q < n; ++q) {
        unsigned const r = n - 1 - p - q;
        cpp_int const ways =
            2 * factorial[2 * n + 1] / (factorial[2 * p + 1] * factorial[2 * q + 1] * factorial[2 * r + 1]);
        for (unsigned i = 0; 2 * i <= p; ++i)
          for (unsigned j = 0; 2 * j <= q; ++j)
            for (unsigned k = 0; 2 * k <= r; ++k) c[n + 1][i + j + k + 1] += ways * c[p][i] * c[q][j] * c[r][k];
      }
  }
  return c;
}

}  // namespace detail

/// g(σ, π) = sn(v, k)/v as a power series in σ = (1 + k²) v² and π = k² v⁴: with A = v², B = k² v² it is symmetric
/// in A and B (σ = A + B, π = AB), which is why the two branches of the elliptic solution become one.
///
/// The coefficients are exact integers over (2n+1)!, rounded once. As many terms are summed as `largest_sigma`
/// needs for full precision; terms beyond those are zeros for a lane of a pack that needs fewer.
template <Real T>
class SnSeries {
 public:
  static constexpr int most_terms = detail::sn_series_rows - 1;

  /// Terms after which the truncated tail is below a quarter of an ulp of g for all 0 ≤ σ ≤ largest_sigma,
  /// 0 ≤ π ≤ σ²/4; most_terms + 1 if the table is too short: then halve the step.
  static int terms_needed(double largest_sigma) {
    double const log_goal = -(significand_bits<T> + 2) * std::log(2.0);
    for (int n = 1; n <= most_terms; ++n)
      if (log_term_bound(n, largest_sigma) <= log_goal) return n;
    return most_terms + 1;
  }

  explicit SnSeries(int terms) : terms_(terms) {
    for (int n = 0; n < terms; ++n)
      for (int j = 0; 2 * j <= n; ++j) row(j)[n - 2 * j] = table()[at(n)][at(j)];
  }

  int terms() const { return terms_; }

  /// g(σ, π); Horner in σ inside, in π outside.
  T operator()(T const& sigma, T const& pi) const {
    T g = T(0);
    for (int j = (terms_ - 1) / 2; j >= 0; --j) {
      auto const& powers = coefficients_[at(j)];
      T inner = T(0);
      for (int i = terms_ - 1 - 2 * j; i >= 0; --i) inner = inner * sigma + powers[at(i)];
      g = g * pi + inner;
    }
    return g;
  }

 private:
  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }
  T* row(int j) { return coefficients_[at(j)].data(); }

  using Table = std::array<std::array<T, detail::sn_series_columns>, detail::sn_series_rows>;

  static Table const& table() {
    static Table const rounded_once = [] {
      auto const integers = detail::sn_series_integers();
      Table t{};
      Wider<T> factorial = 1;
      for (int n = 0; n < detail::sn_series_rows; ++n) {
        if (n > 0) factorial *= (2 * n) * (2 * n + 1);
        for (int j = 0; 2 * j <= n; ++j) t[at(n)][at(j)] = rounded<T>(Wider<T>(integers[at(n)][at(j)]) / factorial);
      }
      return t;
    }();
    return rounded_once;
  }

  /// log of Σⱼ |cₙⱼ| σ^{n−2j} (σ²/4)ʲ / (2n+1)!. All cₙⱼ of one n have the same sign.
  static double log_term_bound(int n, double sigma) {
    double sum = 0, scale = 1;
    for (int j = 0; 2 * j <= n; ++j, scale /= 4) sum += scale * std::abs(static_cast<double>(table()[at(n)][at(j)]));
    return std::log(sum) + n * std::log(sigma);
  }

  int terms_;
  std::array<std::array<T, most_terms>, most_terms / 2> coefficients_{};
};

}  // namespace brouwer
