#include "analysis/growth/tails.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/distributions.hpp"
#include "analysis/growth/member_blocks.hpp"

namespace brouwer {
namespace {

constexpr double level = 0.05;              // at which kurtosis, and dispersion, are seen
constexpr std::int64_t fewest_members = 4;  // of fewer, the fourth moment says nothing

/// Sums over members, and the moments of a sum of random signs.
struct Sums {
  Eigen::ArrayXd squares, fourth, neighbours;  ///< of the centred rest, time by time, and of it and the next one
  double own = 0, own_squares = 0;             ///< of the members' σᵢ²
  double cross = 0, variance = 0, third = 0;   ///< of Σ_{j≠k} bⱼbₖ, and of the same with signs thrown anew

  explicit Sums(Eigen::Index times)
      : squares(Eigen::ArrayXd::Zero(times)), fourth(squares), neighbours(Eigen::ArrayXd::Zero(times - 1)) {}
};

void add_moments(Sums& sums, MemberBlock const& block, MeanMember const& centre) {
  Eigen::ArrayXXd const rest = (block.rest.rowwise() - centre.rest).array();
  auto const before = rest.cols() - 1;
  sums.squares += rest.square().colwise().sum().transpose();
  sums.fourth += rest.square().square().colwise().sum().transpose();
  sums.neighbours += (rest.leftCols(before) * rest.rightCols(before)).colwise().sum().transpose();
}

void add_own(Sums& sums, MemberBlock const& block) {
  Eigen::ArrayXd const own = block.rest.rowwise().squaredNorm().array() / static_cast<double>(block.rest.cols() - 1);
  sums.own += own.sum();
  sums.own_squares += own.square().sum();
}

/// With aⱼ = bⱼ², pₙ = Σ aⱼⁿ: variance 2(p₁² − p₂) and third moment 8(p₁³ − 3p₁p₂ + 2p₃) of Σ_{j≠k} ±bⱼ ±bₖ.
void add_signs(Sums& sums, MemberBlock const& block, MeanMember const& centre, Eigen::ArrayXd const& u) {
  Eigen::VectorXd const slopes = block.slopes.array() - centre.slope;
  Eigen::MatrixXd const x = (block.rest.rowwise() - centre.rest) + slopes * u.matrix().transpose();
  Eigen::ArrayXXd b = x.array();
  b.rowwise() *= u.transpose();
  Eigen::ArrayXXd const a = b.square();
  Eigen::ArrayXd const p1 = a.rowwise().sum(), p2 = a.square().rowwise().sum(), p3 = a.cube().rowwise().sum();
  sums.cross += (b.rowwise().sum().square() - p1).sum();
  sums.variance += 2 * (p1.square() - p2).sum();
  sums.third += 8 * (p1.cube() - 3 * p1 * p2 + 2 * p3).sum();
}

/// Excess kurtosis, the mean over times, with the bias of M normal numbers taken away [Fisher 1930], and its p.
struct Kurtosis {
  double excess = 0, p = 1;
};

Kurtosis kurtosis_of(Sums const& sums, double M) {
  double sum = 0, times = 0;
  for (Eigen::Index j = 0; j < sums.squares.size(); ++j)
    if (sums.squares[j] > 0) {
      sum += M * sums.fourth[j] / (sums.squares[j] * sums.squares[j]) - 3 * (M - 1) / (M + 1);
      ++times;
    }
  double const variance = 24 * M * (M - 2) * (M - 3) / ((M + 1) * (M + 1) * (M + 3) * (M + 5));
  double const excess = times > 0 ? sum / times : 0;
  return {excess, std::erfc(excess / std::sqrt(2 * variance / times)) / 2};
}

/// The same of all times together, which takes increments of a walk to be of one size: more can be seen of few members.
Kurtosis pooled_kurtosis(Sums const& sums, double M, Eigen::ArrayXd const& u) {
  Eigen::ArrayXd const left = 1 - u.square() / u.square().sum();  // of the variance, without the line to the end
  double second = 0, fourth = 0, times = 0;
  for (Eigen::Index j = 0; j < left.size(); ++j)
    if (left[j] > 0.1) {
      second += sums.squares[j] / left[j] / (M - 1);
      fourth += sums.fourth[j] / (left[j] * left[j]) * M / ((M - 1) * (M - 1));
      ++times;
    }
  double const excess = second > 0 ? fourth * times / (second * second) - 3 : 0;
  return {excess, std::erfc(excess / std::sqrt(2 * 24 / (M * times))) / 2};
}

/// P(X ≥ z) of a standardised variable of this skewness, by Pearson's type III law.
double pearson_upper(double z, double skewness) {
  double const dof = 8 / (skewness * skewness);
  return chi_squared_upper(dof + z * std::sqrt(2 * dof), dof);
}

/// Var(σᵢ²) of normal increments with the variances and neighbouring covariances that are seen.
double normal_variance(Sums const& sums, double M) {
  auto const n = static_cast<double>(sums.squares.size() - 1);
  double const squares = sums.squares.square().sum() + 2 * sums.neighbours.square().sum();
  return 2 * squares / ((M - 1) * (M - 1)) / (n * n);
}

/// From the last time backwards, the next one at most half the one before.
std::vector<Eigen::Index> doubling_places(std::vector<double> const& times) {
  std::vector<Eigen::Index> places;
  double limit = times.back();
  for (auto j = std::ssize(times) - 1; j >= 0; --j)
    if (double const time = times[static_cast<std::size_t>(j)]; time <= limit) {
      places.insert(places.begin(), j);
      limit = time / 2;
    }
  return places;
}

}  // namespace

TailInference tails_of(Ensemble const& ensemble, Units const& units) {
  auto const members = ensemble.errors.rows(), times = ensemble.errors.cols();
  if (members < fewest_members || times < 2) return {};
  MemberBlocks const blocks(ensemble, units, times);
  auto const centre = mean_member(blocks);
  Sums sums(times);
  blocks.for_each([&](MemberBlock const& block) {
    add_moments(sums, block, centre);
    add_own(sums, block);
    add_signs(sums, block, centre, blocks.u());
  });
  if (!(sums.own > 0) || !(sums.variance > 0)) return {};
  auto const M = static_cast<double>(members), n = static_cast<double>(times - 1);
  double const mean = sums.own / M, variance = (sums.own_squares - mean * sums.own) / (M - 1);
  auto const kurtosis = kurtosis_of(sums, M), pooled = pooled_kurtosis(sums, M, blocks.u());
  TailInference found;
  found.tails = {kurtosis.excess, variance / normal_variance(sums, M), true};
  found.tails.normal =
      std::min(kurtosis.p, pooled.p) > level && chi_squared_upper((M - 1) * found.tails.dispersion, M - 1) > level;
  double const heavy = 2 * (1 + std::max({0.0, kurtosis.excess, pooled.excess}) / 2) / (M * n);
  double const relative = std::sqrt(std::max(variance / (mean * mean * M), heavy));
  found.log_error = relative / 2;
  found.p_signs = pearson_upper(sums.cross / std::sqrt(sums.variance), sums.third / std::pow(sums.variance, 1.5));
  return found;
}

double doubling_signs_p(Ensemble const& ensemble, Units const& units) {
  auto const places = doubling_places(ensemble.times);
  Ensemble coarse;
  for (auto const place : places) coarse.times.push_back(ensemble.times[static_cast<std::size_t>(place)]);
  coarse.errors = ErrorMatrix(ensemble.errors(Eigen::all, places));
  return tails_of(coarse, units).p_signs;
}

}  // namespace brouwer
