#pragma once
#include <Eigen/Core>
#include <vector>

#include "analysis/units.hpp"

namespace brouwer {

/// A few hundred members in the coordinates of the inference, in scaled units.
struct MemberBlock {
  Eigen::MatrixXd rest;    ///< members × times: increments over √δⱼ, less those of the line to the member's end
  Eigen::VectorXd slopes;  ///< sᵢ = eᵢ(t_J)/t_J of these lines
};

/// An ensemble, block by block: a matrix of a block stays in the cache, one of all members would not.
class MemberBlocks {
 public:
  /// @param most_times  more are thinned, evenly in their order and with the last kept
  MemberBlocks(Ensemble const& ensemble, Units const& units, Eigen::Index most_times);

  Eigen::ArrayXd const& times() const { return times_; }
  Eigen::ArrayXd const& u() const { return u_; }  ///< uⱼ = √(tⱼ − tⱼ₋₁)
  double duration() const { return times_[times_.size() - 1]; }
  Eigen::Index members() const { return ensemble_.errors.rows(); }
  std::vector<Eigen::Index> const& columns() const { return columns_; }

  /// Calls visit(block) for all members, in their order.
  template <class Visit>
  void for_each(Visit const& visit) const {
    for (Eigen::Index first = 0; first < members(); first += block_rows) visit(block(first));
  }

 private:
  static constexpr Eigen::Index block_rows = 256;
  MemberBlock block(Eigen::Index first) const;

  Ensemble const& ensemble_;
  double scale_;
  std::vector<Eigen::Index> columns_;
  Eigen::ArrayXd times_, u_;
};

/// Means over members: what all share is no spread.
struct MeanMember {
  Eigen::RowVectorXd rest;
  double slope = 0;
};

MeanMember mean_member(MemberBlocks const& blocks);

/// Column by column, increments in time of what the rows hold, over √δⱼ.
void to_whitened_increments(Eigen::Ref<Eigen::MatrixXd> paths, Eigen::ArrayXd const& u);

}  // namespace brouwer
