#include "analysis/distributions.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_gamma.h>

#include <boost/math/special_functions/gamma.hpp>

#include <cmath>
#include <limits>

#include "analysis/calm.hpp"

namespace brouwer {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// GSL's default handler aborts; an underflow in a tail is no reason to. Once for the process, from any thread.
void keep_gsl_calm() { [[maybe_unused]] static auto const former = gsl_set_error_handler_off(); }

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
  if (!(dof >= 1)) return undefined;
  // not gsl_cdf_chisq_Pinv: GSL 2.7's fails to converge for scattered degrees of freedom (2320 at 0.975) and for all
  // large ones. Not gamma_p_inv as it stands either: it may throw where it runs out of iterations.
  return 2 * boost::math::gamma_p_inv(dof / 2, p, Calm());
}

double chi_squared_upper(double x, double dof) {
  keep_gsl_calm();
  if (std::isnan(x) || !(dof > 0)) return undefined;
  return x > 0 ? gsl_cdf_chisq_Q(x, dof) : 1;
}

double chi_squared_lower(double x, double dof) {
  keep_gsl_calm();
  if (std::isnan(x) || !(dof > 0)) return undefined;
  return x > 0 ? gsl_cdf_chisq_P(x, dof) : 0;
}

}  // namespace brouwer
