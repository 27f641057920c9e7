#include "analysis/distributions.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_gamma.h>

#include <cmath>
#include <limits>

namespace brouwer {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// GSL's default handler aborts; an underflow in a tail is no reason to. Once for the process, from any thread.
void keep_gsl_calm() { [[maybe_unused]] static auto const former = gsl_set_error_handler_off(); }

/// Cornish–Fisher expansion of the quantile in 1/√n [Goldberg & Levine, Ann. Math. Stat. 17 (1946) 216]: its first
/// neglected term is below 1e-13 of the value from 10⁴ degrees of freedom on.
double large_chi_squared_quantile(double p, double n) {
  double const z = gsl_cdf_ugaussian_Pinv(p), z2 = z * z, root = std::sqrt(2 * n);
  return n + root * z + 2 * (z2 - 1) / 3 + z * (z2 - 7) / (9 * root) - ((6 * z2 + 14) * z2 - 32) / (405 * n) +
         z * ((9 * z2 + 256) * z2 - 433) / (4860 * n * root);
}

}  // namespace

double student_two_sided(double t, double dof) {
  keep_gsl_calm();
  if (std::isnan(t) || !(dof >= 1)) return undefined;
  if (std::isinf(t)) return 0;
  // GSL expands its tail asymptotically from 30 degrees of freedom on: 4·10⁻⁹ off at t = 10. The incomplete beta
  // function [DLMF 8.17] holds its digits there, but loses some near t = 0.
  if (std::abs(t) > 3) return gsl_sf_beta_inc(dof / 2, 0.5, dof / (dof + t * t));
  return 2 * gsl_cdf_tdist_Q(std::abs(t), dof);
}

double student_upper_quantile(double tail, double dof) {
  keep_gsl_calm();
  return dof >= 1 ? gsl_cdf_tdist_Qinv(tail, dof) : undefined;
}

double normal_upper_quantile(double tail) { return gsl_cdf_ugaussian_Qinv(tail); }

double fisher_upper(double F, double m, double n) {
  keep_gsl_calm();
  if (std::isnan(F) || !(m >= 1) || !(n >= 1)) return undefined;
  return std::isinf(F) ? 0 : gsl_cdf_fdist_Q(F, m, n);
}

double fisher_lower(double F, double m, double n) {
  keep_gsl_calm();
  if (std::isnan(F) || !(m >= 1) || !(n >= 1)) return undefined;
  return std::isinf(F) ? 1 : gsl_cdf_fdist_P(F, m, n);
}

double chi_squared_quantile(double p, double dof) {
  keep_gsl_calm();
  if (!(dof >= 1)) return undefined;
  // GSL 2.7's own inverse fails to converge from about 10⁵ degrees of freedom on, and its distribution function is
  // 10⁻⁴ off at 2·10⁷.
  return dof < 1e4 ? gsl_cdf_chisq_Pinv(p, dof) : large_chi_squared_quantile(p, dof);
}

}  // namespace brouwer
