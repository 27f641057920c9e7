#pragma once
#include <cstdint>

#include "analysis/interval.hpp"

namespace brouwer {

/// Σ aᵢ / Σ bᵢ over members i, which are independent.
struct MemberRatio {
  double a = 0, b = 0, aa = 0, ab = 0, bb = 0;  ///< Σaᵢ, Σbᵢ, Σaᵢ², Σaᵢbᵢ, Σbᵢ²

  void add(double member_a, double member_b);
  MemberRatio& operator+=(MemberRatio const& other);

  double value() const { return a / b; }
  /// The ratio ± t(M−1) times its standard error √(M/(M−1) Σ(aᵢ − r bᵢ)²)/Σbᵢ [W. G. Cochran, Sampling Techniques
  /// (1977), 6.4]. NaN for one member.
  Interval interval(std::int64_t members, double confidence) const;
  /// The same of the logarithm of a ratio that is positive.
  Interval log_interval(std::int64_t members, double confidence) const;

 private:
  double half_width(std::int64_t members, double confidence) const;
};

}  // namespace brouwer
