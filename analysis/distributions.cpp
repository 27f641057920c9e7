#include "analysis/distributions.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_sf_gamma.h>

#include <cmath>
#include <limits>

namespace brouwer {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// GSL's default handler aborts; an underflow in a tail is no reason to. Once for the process, from any thread.
void keep_gsl_calm() { [[maybe_unused]] static auto const former = gsl_set_error_handler_off(); }

/// Wilson & Hilferty (1931), polished by Newton steps on GSL's distribution function.
double large_chi_squared_quantile(double p, double dof) {
  double const c = 2 / (9 * dof);
  double x = dof * std::pow(1 - c + gsl_cdf_ugaussian_Pinv(p) * std::sqrt(c), 3);
  for (int i = 0; i < 3; ++i) {
    double const excess = p < 0.5 ? gsl_cdf_chisq_P(x, dof) - p : (1 - p) - gsl_cdf_chisq_Q(x, dof);
    x -= excess / gsl_ran_chisq_pdf(x, dof);
  }
  return x;
}

}  // namespace

double student_two_sided(double t, double dof) {
  keep_gsl_calm();
  if (std::isnan(t) || !(dof >= 1)) return undefined;
  if (std::isinf(t)) return 0;
  // GSL expands its tail asymptotically from 30 degrees of freedom on: 4·10⁻⁹ off at t = 10. The incomplete beta
  // function [DLMF 8.17] is exact there, but loses digits near t = 0 and for very many degrees of freedom.
  if (dof < 200 && std::abs(t) > 3) return gsl_sf_beta_inc(dof / 2, 0.5, dof / (dof + t * t));
  return 2 * gsl_cdf_tdist_Q(std::abs(t), dof);
}

double student_upper_quantile(double tail, double dof) {
  keep_gsl_calm();
  return dof >= 1 ? gsl_cdf_tdist_Qinv(tail, dof) : undefined;
}

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
  // GSL 2.7's own inverse fails to converge from about 10⁵ degrees of freedom on.
  return dof < 1e4 ? gsl_cdf_chisq_Pinv(p, dof) : large_chi_squared_quantile(p, dof);
}

}  // namespace brouwer
