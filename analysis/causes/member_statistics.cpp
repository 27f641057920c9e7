#include "analysis/causes/member_statistics.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "analysis/growth/bridge.hpp"
#include "analysis/growth/shared_course.hpp"
#include "analysis/verdict/verdict.hpp"

namespace brouwer {
namespace {

using TimesMap = Eigen::Map<Eigen::VectorXd const>;

TimesMap times_of(std::vector<double> const& times) { return {times.data(), std::ssize(times)}; }

/// min(tⱼ, tₖ), the covariance of a walk with σ = 1.
Eigen::MatrixXd walk_covariance(std::vector<double> const& times) {
  auto const t = times_of(times);
  Eigen::MatrixXd covariance(t.size(), t.size());
  for (Eigen::Index j = 0; j < t.size(); ++j)
    for (Eigen::Index k = 0; k < t.size(); ++k) covariance(j, k) = std::min(t[j], t[k]);
  return covariance;
}

double squared(double x) { return x * x; }

}  // namespace

Eigen::VectorXd slope_weights(Estimates const& e) {
  auto const t = times_of(e.times);
  if (!noise_in_force(e)) return Eigen::VectorXd::Unit(t.size(), t.size() - 1) / e.times.back();
  double const walk = squared(e.diffusion.per_sqrt_step / e.noise.size);  // σ²/ν²
  Eigen::MatrixXd covariance = walk * walk_covariance(e.times);
  covariance.diagonal().array() += 1;
  Eigen::VectorXd const w = covariance.ldlt().solve(t);
  return w / w.dot(t);
}

MemberStatistics member_statistics(Ensemble const& ensemble, Eigen::VectorXd const& weights, Estimates const& e,
                                   double scale) {
  auto const members = ensemble.errors.rows();
  Eigen::ArrayXd const times = times_of(ensemble.times).array();
  double const end = times[times.size() - 1], degrees = static_cast<double>(times.size() - 1);
  double const walk_part = weights.dot(walk_covariance(ensemble.times) * weights);
  double const noise_part = squared(scale * e.noise.size) * weights.squaredNorm();
  double const fitted = squared(scale * e.diffusion.per_sqrt_step) * walk_part + noise_part;
  double const unbiased = static_cast<double>(members) / std::max(1.0, static_cast<double>(members - 1));
  Eigen::ArrayXd const none(members);
  MemberStatistics s{none, none, none, none};
  if (members == 0) return s;
  auto const apart = without_mean(ensemble);  // what members share is no walk of theirs
  for (Eigen::Index i = 0; i < members; ++i) {
    Eigen::RowVectorXd const error = scale * ensemble.errors.row(i), own = scale * apart.errors.row(i);
    s.slope[i] = error.dot(weights);
    s.walk[i] = unbiased * squared_bridge(own, times, own[own.size() - 1] / end) / degrees;
    s.disturbance[i] = noise_in_force(e) ? fitted : s.walk[i] * walk_part;
    s.square[i] = squared(error[error.size() - 1]);
  }
  return s;
}

MemberStatistics of_members(MemberStatistics const& all, std::vector<Eigen::Index> const& rows) {
  return {all.slope(rows), all.disturbance(rows), all.walk(rows), all.square(rows)};
}

}  // namespace brouwer
