#pragma once
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <concepts>
#include <vector>

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

/// Exact integers over (2n+1)! and over (2n)!, rounded once: the coefficients of g and of cn·dn = (v g)′.
template <Real E>
struct SnTable {
  struct Term {
    E g, slope;
  };
  using Rows = std::array<std::array<Term, sn_series_columns>, sn_series_rows>;

  static Rows const& rows() {
    static Rows const rounded_once = [] {
      using W = Wider<E>;
      auto const integers = sn_series_integers();
      Rows t{};
      W factorial = 1;  // (2n)!
      for (unsigned n = 0; n < sn_series_rows; ++n) {
        if (n > 0) factorial *= 2 * n;
        for (unsigned j = 0; 2 * j <= n; ++j) {
          W const slope = W(integers[n][j]) / factorial;
          t[n][j] = {rounded<E>(W(slope / (2 * n + 1))), rounded<E>(slope)};
        }
        factorial *= 2 * n + 1;
      }
      return t;
    }();
    return rounded_once;
  }
};

}  // namespace detail

/// sn(v, k)/v, and cn(v, k) dn(v, k) − 1 where sn′ = cn dn.
template <Real T>
struct SnValues {
  T g, slope_less_one;
};

/// g(σ, π) = sn(v, k)/v and its companion cn dn = (v g)′ as power series in σ = (1 + k²) v² and π = k² v⁴: with A = v²,
/// B = k² v² both are symmetric in A and B (σ = A + B, π = AB), which is why the two branches of the elliptic solution
/// become one.
///
/// As many terms are summed as the largest σ needs for full precision, in each lane of a pack its own number: the
/// coefficients of terms that only other lanes need are 0, which leaves a lane's bits alone (0·σ + c = c, σ, π ≥ 0).
/// Only the coefficients in use are held, in the order of their use.
template <Real T>
class SnSeries {
 public:
  static constexpr int most_terms = detail::sn_series_rows - 1;

  /// Terms after which the truncated tails are below a quarter of an ulp of 1 for all 0 ≤ σ ≤ largest_sigma,
  /// 0 ≤ π ≤ σ²/4; most_terms + 1 if the table is too short: then halve the step.
  static int terms_needed(double largest_sigma) {
    double const log_goal = -(significand_bits<T> + 2) * std::log(2.0);
    for (int n = 1; n <= most_terms; ++n)
      if (log_term_bound(n, largest_sigma) <= log_goal) return n;
    return most_terms + 1;
  }

  /// The same number of terms in every lane.
  explicit SnSeries(int terms) : SnSeries([=](int) { return terms; }) {}

  /// @param terms_of  lane → number of its terms
  template <std::invocable<int> F>
  explicit SnSeries(F terms_of) {
    for (int i = 0; i < lanes<T>; ++i) terms_ = std::max(terms_, terms_of(i));
    for (int j = (terms_ - 1) / 2; j >= 0; --j)
      for (int n = terms_ - 1; n >= 2 * j; --n) {
        auto const& term = detail::SnTable<Element<T>>::rows()[at(n)][at(j)];
        auto const where_used = [&](Element<T> const& c) {
          return from_lanes<T>([&](int i) { return n < terms_of(i) ? c : Element<T>(0); });
        };
        terms_in_use_.push_back({where_used(term.g), where_used(n > 0 ? term.slope : Element<T>(0))});
      }
  }

  /// The most of any lane.
  int terms() const { return terms_; }

  /// Horner in σ inside, in π outside.
  SnValues<T> operator()(T const& sigma, T const& pi) const {
    SnValues<T> const* term = terms_in_use_.data();
    int powers = terms_ % 2 == 0 ? 2 : 1;
    auto sum = power_sum(term, powers, sigma);
    while ((powers += 2) <= terms_) {
      auto const inner = power_sum(term, powers, sigma);
      sum = {sum.g * pi + inner.g, sum.slope_less_one * pi + inner.slope_less_one};
    }
    return sum;
  }

 private:
  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

  static SnValues<T> power_sum(SnValues<T> const*& term, int powers, T const& sigma) {
    SnValues<T> sum = *term++;
    for (int i = 1; i < powers; ++i, ++term)
      sum = {sum.g * sigma + term->g, sum.slope_less_one * sigma + term->slope_less_one};
    return sum;
  }

  /// log of Σⱼ |cₙⱼ| σ^{n−2j} (σ²/4)ʲ / (2n)!. All cₙⱼ of one n have the same sign.
  static double log_term_bound(int n, double sigma) {
    double sum = 0, scale = 1;
    for (int j = 0; 2 * j <= n; ++j, scale /= 4)
      sum += scale * std::abs(static_cast<double>(detail::SnTable<Element<T>>::rows()[at(n)][at(j)].slope));
    return std::log(sum) + n * std::log(sigma);
  }

  int terms_ = 1;
  std::vector<SnValues<T>> terms_in_use_;
};

}  // namespace brouwer
