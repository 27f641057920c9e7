#include "analysis/causes/cell_shares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/distributions.hpp"
#include "analysis/member_ratio.hpp"
#include "analysis/student_drift.hpp"

namespace brouwer {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Interval anything{-infinite, infinite};

double mean_product(Eigen::ArrayXd const& a, Eigen::ArrayXd const& b) {
  return ((a - a.mean()) * (b - b.mean())).sum() / static_cast<double>(a.size() - 1);
}

MemberRatio ratio_of(Eigen::ArrayXd const& a, Eigen::ArrayXd const& b) {
  MemberRatio ratio;
  for (Eigen::Index i = 0; i < a.size(); ++i) ratio.add(a[i], b[i]);
  return ratio;
}

/// √ of a ratio of two sums of squares.
Share root_ratio(Eigen::ArrayXd const& a, Eigen::ArrayXd const& b, double confidence) {
  auto const ratio = ratio_of(a, b);
  if (!(ratio.a >= 0 && ratio.b > 0)) return {};
  if (ratio.a == 0) return {0, {0, 0}};
  auto const squares = ratio.log_interval(a.size(), confidence);
  return {std::sqrt(ratio.value()), {std::sqrt(squares.low), std::sqrt(squares.high)}};
}

}  // namespace

Share share_of_means(Eigen::ArrayXd const& a, Eigen::ArrayXd const& b, double confidence) {
  auto const members = static_cast<double>(a.size());
  double const t = student_upper_quantile((1 - confidence) / 2, members - 1), g = t * t / members;
  Eigen::ArrayXd const difference = a - b;
  bool const near_one = std::abs(difference.mean()) < 0.5 * std::abs(b.mean());
  double const base = near_one ? 1 : 0;
  Eigen::ArrayXd const& d = near_one ? difference : a;
  double const db = d.mean(), bb = b.mean();
  double const A = bb * bb - g * mean_product(b, b), B = db * bb - g * mean_product(d, b),
               C = db * db - g * mean_product(d, d);
  if (!(A > 0)) return {base + db / bb, anything};
  double const root = std::sqrt(std::max(0.0, B * B - A * C));
  return {base + db / bb, {base + (B - root) / A, base + (B + root) / A}};
}

Eigen::ArrayXd slope_variances(MemberStatistics const& s) {
  auto const members = static_cast<double>(s.members());
  return (s.slope - s.slope.mean()).square() * members / (members - 1) - s.disturbance;
}

ComparedCell compared(MemberStatistics const& nominal, MemberStatistics const& other, double confidence) {
  ComparedCell cell;
  auto const members = static_cast<double>(nominal.members());
  auto const error = [&](Eigen::ArrayXd const& x) { return std::sqrt(mean_product(x, x) / members); };
  Eigen::ArrayXd const change = other.slope - nominal.slope;
  double const changed = change.mean(), changed_error = error(change);
  cell.drift = student_drift(other.slope.mean(), error(other.slope), members - 1, confidence);
  cell.p = changed_error > 0 ? student_two_sided(changed / changed_error, members - 1) : changed == 0 ? 1 : 0;
  cell.drift_left = share_of_means(other.slope, nominal.slope, confidence);
  Eigen::ArrayXd const slopes = slope_variances(nominal);
  if (slopes.mean() > 0) cell.slopes_left = share_of_means(slope_variances(other), slopes, confidence);
  cell.diffusion_left = root_ratio(other.walk, nominal.walk, confidence);
  cell.size_left = root_ratio(other.square, nominal.square, confidence);
  return cell;
}

}  // namespace brouwer
