#include "analysis/increments/pearson.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

#include "analysis/calm.hpp"

namespace brouwer {
namespace {

constexpr double nearly_zero = 1e-6;  ///< what rounding leaves of cumulants that cancel

BothTails normal_tails(double z) { return {gsl_cdf_ugaussian_P(z), gsl_cdf_ugaussian_Q(z)}; }

/// A gamma variable, less its shape a and over √a, of excess kurtosis 6/a.
BothTails gamma_tails(double z, double excess) {
  double const shape = 6 / excess, x = shape + z * std::sqrt(shape);
  if (x <= 0) return {0, 1};
  return {boost::math::gamma_p(shape, x, Calm()), boost::math::gamma_q(shape, x, Calm())};
}

/// A beta variable whose parameters have the sum r, of squared skewness β₁ and kurtosis β₂.
BothTails beta_tails(double z, double beta1, double beta2) {
  double const r = std::max(6 * (beta2 - beta1 - 1) / (6 + 3 * beta1 - 2 * beta2), nearly_zero);  // 0: two values
  double const root = std::sqrt(beta1 * (r + 2) * (r + 2) + 16 * (r + 1));
  double const lean = (r + 2) * std::sqrt(beta1) / root;
  double const a = r / 2 * (1 - lean), b = r / 2 * (1 + lean);
  double const x = a / r + z / (root / 2);
  if (x <= 0) return {0, 1};
  if (x >= 1) return {1, 0};
  return {boost::math::ibeta(a, b, x, Calm()), boost::math::ibetac(a, b, x, Calm())};
}

BothTails leaning_right(double z, double skewness, double excess) {
  double const beta1 = skewness * skewness;
  if (3 * beta1 - 2 * excess > nearly_zero) return beta_tails(z, beta1, 3 + excess);
  return beta1 > nearly_zero ? gamma_tails(z, excess) : normal_tails(z);
}

}  // namespace

BothTails pearson_tails(double z, double skewness, double excess) {
  if (skewness >= 0) return leaning_right(z, skewness, excess);
  auto const mirrored = leaning_right(-z, -skewness, excess);
  return {mirrored.upper, mirrored.lower};
}

}  // namespace brouwer
