#include "analysis/noise_score.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/distributions.hpp"
#include "analysis/growth_statistics.hpp"
#include "analysis/member_blocks.hpp"

namespace brouwer {
namespace {

/// Of each member, the three numbers that its score is made of.
struct Parts {
  Eigen::VectorXd rough;  ///< |Cᵀr|²
  Eigen::VectorXd size;   ///< |r|²
  Eigen::VectorXd cross;  ///< (s − s̄) uᵀBr
};

/// With Cᵀu = (0, …, 0, 1)ᵀ, so that uᵀBr is the last component of Cᵀr.
Parts parts_of(MemberBlocks const& blocks, MeanMember const& centre) {
  Parts parts{Eigen::VectorXd(blocks.members()), Eigen::VectorXd(blocks.members()), Eigen::VectorXd(blocks.members())};
  Eigen::Index first = 0;
  blocks.for_each([&](MemberBlock block) {
    auto const rows = block.rest.rows(), last = block.rest.cols() - 1;
    block.rest.rowwise() -= centre.rest;
    parts.size.segment(first, rows) = block.rest.rowwise().squaredNorm();
    block.rest.array().rowwise() /= blocks.u().transpose();
    parts.cross.segment(first, rows) = (block.slopes.array() - centre.slope) * block.rest.col(last).array();
    parts.rough.segment(first, rows) =
        (block.rest.leftCols(last) - block.rest.rightCols(last)).rowwise().squaredNorm() +
        block.rest.col(last).rowwise().squaredNorm();
    first += rows;
  });
  return parts;
}

/// tr B − uᵀBu/t_J over J − 1: what |Cᵀr|²/|r|² is for a walk.
double walk_ratio(MemberBlocks const& blocks) {
  auto const inverse = blocks.u().square().inverse();
  auto const J = static_cast<double>(blocks.u().size());
  return (2 * inverse.sum() - inverse[0] - 1 / blocks.duration()) / (J - 1);
}

}  // namespace

double noise_score_p(Ensemble const& ensemble, Units const& units) {
  MemberBlocks const blocks(ensemble, units, GrowthStatistics::most_times);
  auto const centre = mean_member(blocks);
  auto const parts = parts_of(blocks, centre);
  auto const M = static_cast<double>(blocks.members()), J = static_cast<double>(blocks.times().size());
  double const sigma2 = parts.size.sum() / ((M - 1) * (J - 1));
  double spread = 0;
  blocks.for_each([&](MemberBlock const& block) { spread += (block.slopes.array() - centre.slope).square().sum(); });
  double const v = std::max(spread / (M - 1), sigma2 / blocks.duration());
  Eigen::ArrayXd const score = (parts.rough - walk_ratio(blocks) * parts.size).array() / (2 * sigma2) +
                               parts.cross.array() / (blocks.duration() * v);
  double const mean = score.mean(), deviation = std::sqrt((score - mean).square().sum() / (M - 1));
  double const t = mean * std::sqrt(M) / deviation, two_sided = student_two_sided(t, M - 1);
  return t > 0 ? two_sided / 2 : 1 - two_sided / 2;
}

}  // namespace brouwer
