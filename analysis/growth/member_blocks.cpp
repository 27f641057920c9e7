#include "analysis/growth/member_blocks.hpp"

#include <algorithm>

namespace brouwer {
namespace {

std::vector<Eigen::Index> thinned(Eigen::Index count, Eigen::Index most) {
  Eigen::Index const kept = std::min(count, most);
  std::vector<Eigen::Index> places;
  for (Eigen::Index k = 1; k <= kept; ++k) places.push_back(k * count / kept - 1);
  return places;
}

Eigen::ArrayXd root_increments(Eigen::ArrayXd const& times) {
  Eigen::ArrayXd delta = times;
  delta.tail(delta.size() - 1) -= times.head(times.size() - 1);
  return delta.sqrt();
}

}  // namespace

void to_whitened_increments(Eigen::Ref<Eigen::MatrixXd> paths, Eigen::ArrayXd const& u) {
  for (Eigen::Index j = paths.cols() - 1; j > 0; --j) paths.col(j) -= paths.col(j - 1);
  paths.array().rowwise() /= u.transpose();
}

MemberBlocks::MemberBlocks(Ensemble const& ensemble, Units const& units, Eigen::Index most_times)
    : ensemble_(ensemble),
      scale_(units.error),
      columns_(thinned(std::ssize(ensemble.times), most_times)),
      times_(scaled_times(ensemble, units)(columns_)),
      u_(root_increments(times_)) {}

MemberBlock MemberBlocks::block(Eigen::Index first) const {
  Eigen::Index const rows = std::min(block_rows, members() - first);
  MemberBlock block{scale_ * ensemble_.errors.middleRows(first, rows)(Eigen::all, columns_), {}};
  block.slopes = block.rest.rightCols<1>() / duration();
  block.rest -= block.slopes * times_.matrix().transpose();
  to_whitened_increments(block.rest, u_);
  return block;
}

MeanMember mean_member(MemberBlocks const& blocks) {
  MeanMember mean{Eigen::RowVectorXd::Zero(blocks.times().size())};
  blocks.for_each([&](MemberBlock const& block) {
    mean.rest += block.rest.colwise().sum();
    mean.slope += block.slopes.sum();
  });
  auto const members = static_cast<double>(blocks.members());
  return {mean.rest / members, mean.slope / members};
}

}  // namespace brouwer
