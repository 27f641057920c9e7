#pragma once
#include <Eigen/Core>
#include <cstdint>

#include "analysis/increment_tests.hpp"
#include "analysis/increments/random_signs.hpp"
#include "analysis/member_ratio.hpp"

namespace brouwer {

/// Sums over members for the correlation of increments at one lag k:
///
///     ρ̂_k = (J−1)/(J−1−k) · Σᵢⱼ wᵢⱼ wᵢ,ⱼ₊ₖ / Σᵢⱼ wᵢⱼ²
///
/// The signs of the products wⱼwⱼ₊ₖ are as free as those of the w themselves: their sum is tested as one of random
/// signs (random_signs.hpp).
class LagSums {
 public:
  /// @param length  increments a member, J − 1, more than the lag
  LagSums(std::int64_t lag, std::int64_t members, std::int64_t length)
      : lag_(lag), members_(members), length_(length), signs_(static_cast<double>(members * (length - lag))) {}

  /// One member's increments, and the sum of their squares.
  void add(Eigen::ArrayXd const& w, double squares);
  LagSums& operator+=(LagSums const& other);

  Autocorrelation result(double confidence) const;

 private:
  std::int64_t lag_, members_, length_;
  MemberRatio ratio_;
  RandomSigns signs_;
};

}  // namespace brouwer
