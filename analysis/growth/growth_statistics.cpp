#include "analysis/growth/growth_statistics.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "analysis/growth/member_blocks.hpp"

namespace brouwer {
namespace {

/// Eigenvalues and vectors of B, the covariance of white noise's increments over √δ: tridiagonal.
Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> noise_spectrum(Eigen::ArrayXd const& u) {
  Eigen::VectorXd diagonal = 2 / u.square(), beside = -1 / (u.head(u.size() - 1) * u.tail(u.size() - 1));
  diagonal[0] /= 2;  // the error at time 0 is exactly 0
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>().computeFromTridiagonal(diagonal, beside);
}

}  // namespace

GrowthStatistics::GrowthStatistics(Ensemble const& ensemble, Units const& units, MeanCourse course)
    : members_(static_cast<double>(ensemble.errors.rows())),
      rests_(course == MeanCourse::free ? members_ - 1 : members_) {
  MemberBlocks const blocks(ensemble, units, most_times);
  duration_ = blocks.duration();
  auto const J = blocks.times().size();
  Eigen::VectorXd sum_rest = Eigen::VectorXd::Zero(J), slope_by_rest = sum_rest;
  Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(J, J);
  double const first_slope = units.error * ensemble.errors(0, ensemble.errors.cols() - 1) / blocks.duration();
  double slope_sum = 0, slope_squares = 0;  // about the first slope, so that equal slopes have no spread
  blocks.for_each([&](MemberBlock block) {
    block.slopes.array() -= first_slope;
    slope_sum += block.slopes.sum();
    slope_squares += block.slopes.squaredNorm();
    sum_rest += block.rest.colwise().sum().transpose();
    slope_by_rest += block.rest.transpose() * block.slopes;
    scatter.selfadjointView<Eigen::Lower>().rankUpdate(block.rest.transpose());
  });
  double const off = slope_sum / members_;
  mean_slope_ = first_slope + off;
  slope_spread_ = std::max(0.0, slope_squares - slope_sum * off);
  auto const spectrum = noise_spectrum(blocks.u());
  Eigen::MatrixXd const& Q = spectrum.eigenvectors();
  // all are positive; the smallest may not come out so where the times span more than 15 decades
  eigenvalues_ = spectrum.eigenvalues().array().max(1e-16 * spectrum.eigenvalues()[J - 1]);
  w_ = Q.transpose() * blocks.u().matrix();
  if (course == MeanCourse::free) sum_rest.setZero();  // but for rounding it is
  mean_rest_ = Q.transpose() * sum_rest / members_;
  slope_by_rest_ = Q.transpose() * (slope_by_rest - off * sum_rest);
  scatter_ = Q.transpose() * scatter.selfadjointView<Eigen::Lower>() * Q;
  scatter_ -= members_ * mean_rest_ * mean_rest_.transpose();
}

Eigen::ArrayXd GrowthStatistics::metric(double rho) const {
  if (std::isinf(rho)) return eigenvalues_;
  return 1 + rho * eigenvalues_;
}

Reduced GrowthStatistics::at(double rho) const {
  Eigen::ArrayXd const d = metric(rho);
  Eigen::VectorXd const z = w_ / d;
  Reduced r;
  r.log_determinant = d.log().sum();
  r.precision = (w_.square() / d).sum();
  double const squares = z.dot(scatter_ * z), shift = z.dot(mean_rest_);
  // of the weighted slopes against the lines to the ends: sᵢ = sᵢ⁰ + zᵀrᵢ/a
  r.slope = mean_slope_ + shift / r.precision;
  r.spread = slope_spread_ + (2 * z.dot(slope_by_rest_) + squares / r.precision) / r.precision;
  r.course = members_ * ((mean_rest_.array().square() / d).sum() - shift * shift / r.precision);
  r.residual = (scatter_.diagonal().array() / d).sum() - squares / r.precision + r.course;
  return r;
}

double GrowthStatistics::sphericity(double rho) const {
  double const n = members_ - 1, k = times() - 1;
  if (n < 2) return 1 / k;  // nothing tells

  Eigen::VectorXd const scale = metric(rho).rsqrt().matrix();
  Eigen::MatrixXd const A = scale.asDiagonal() * scatter_ * scale.asDiagonal();
  Eigen::VectorXd const slope = scale.cwiseProduct(w_.matrix()).normalized(), image = A * slope;
  double const along = slope.dot(image), trace = A.trace() - along;
  double const squares = A.squaredNorm() - 2 * image.squaredNorm() + along * along;
  double const excess = n * squares - trace * trace;  // n(n−1)(n+2) tr Σ² in the mean
  return excess > 0 ? std::min(1.0, ((n + 1) * trace * trace - 2 * squares) / (k * excess)) : 1;
}

}  // namespace brouwer
