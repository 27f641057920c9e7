#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "analysis/increment_tests.hpp"
#include "analysis/increments/random_signs.hpp"
#include "analysis/member_ratio.hpp"

namespace brouwer {

/// Neighbouring increments put together to increments over durations in [d, 2d): disjoint blocks of two or more. An
/// increment over a block, less the slope so far, is again standard, and a sum of those in it:
///
///     W = Σₖ cₖ wₖ,   cₖ² = (1/tₖ₋₁ − 1/tₖ)/(1/t_a − 1/t_b),   Σ cₖ² = 1,   for the block from t_a to t_b.
///
/// What is longer than 2d by itself, as late increments of log-spaced samples are, does not belong to this scale. Nor
/// does a block with t_b > 4 t_a: the slope so far is then known so badly that its own error is most of W.
struct Aggregation {
  struct Block {
    Eigen::Index first, length;
  };
  double scale = 0;             ///< mean duration of the blocks
  std::vector<Block> blocks;    ///< of increments
  Eigen::ArrayXd coefficients;  ///< c of every increment, 0 outside of blocks

  /// That change something: of the signs in a block all but one.
  double free_signs() const;
};

/// Scales by factors of two from twice the shortest increment on, as far as the members have `fewest_blocks` together.
/// @param times  increasing, > 0; at least two
std::vector<Aggregation> aggregations(Eigen::ArrayXd const& times, std::int64_t members);

constexpr std::int64_t fewest_blocks = 8;
constexpr double longest_reach = 4;  ///< t_b/t_a of a block

/// Sums over members for the variance ratio at one scale,
///
///     V = Σ W² / Σ cₖ²wₖ²      over all blocks and members,
///
/// which compares each block with the increments in it, so that a σ that changes with time or from member to member
/// does not matter. σ at this scale is √(mean W²). W² − Σ cₖ²wₖ² is tested as the square of a sum of random signs (random_signs.hpp).
class AggregateSums {
 public:
  AggregateSums(Aggregation const& aggregation, std::int64_t members)
      : aggregation_(&aggregation),
        members_(members),
        signs_(static_cast<double>(members) * aggregation.free_signs()) {}

  void add(Eigen::ArrayXd const& w);  ///< one member's increments
  AggregateSums& operator+=(AggregateSums const& other);

  VarianceRatio result(double confidence) const;

 private:
  Aggregation const* aggregation_;
  std::int64_t members_;
  MemberRatio ratio_, size_;  // of ΣW² to Σc²w², and to the number of blocks
  RandomSigns signs_;
};

}  // namespace brouwer
