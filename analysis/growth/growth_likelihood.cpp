#include "analysis/growth/growth_likelihood.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <tuple>

namespace brouwer {
namespace {

constexpr int bits = 26;           // of the place of a minimum: half a double's, as many as its value can tell
constexpr double grid_step = 0.5;  // of log ρ: three or four points a factor of five
constexpr double reach = 5;        // of log ρ about a known minimum
constexpr double profile_step = 1;
constexpr double scale_reach = 4;  // of log σ² about its best value

/// Place and value of the minimum of a function that has one between the ends.
template <class Function>
std::pair<double, double> least(Function const& function, double low, double high) {
  return boost::math::tools::brent_find_minima(function, low, high, bits);
}

/// … that may have several: the likelihood has two where noise and a walk each explain a part.
template <class Function>
std::pair<double, double> least_of_all(Function const& function, double low, double high, double step) {
  double place = low, smallest = function(low);
  for (double x = low + step; x < high; x += step)
    if (double const found = function(x); found < smallest) std::tie(place, smallest) = std::pair(x, found);
  return least(function, place - step, place + step);
}

}  // namespace

double GrowthLikelihood::deviance(Reduced const& r, double scale, double slope_variance) const {
  double const M = statistics_.members(), J = statistics_.times();
  return statistics_.rests() * (r.log_determinant + std::log(r.precision) + (J - 1) * std::log(scale)) +
         r.residual / scale + (M - 1) * std::log(slope_variance) + r.spread / slope_variance;
}

GrowthFit GrowthLikelihood::at(double rho, bool slopes) const {
  double const M = statistics_.members(), n = statistics_.rests() * (statistics_.times() - 1);
  auto const r = statistics_.at(rho);
  double scale = r.residual / n, variance = r.spread / (M - 1);
  if (!slopes || variance < scale / r.precision) {  // τ = 0: slopes tell of the same scale as the rest
    scale = (r.residual + r.precision * r.spread) / (n + M - 1);
    variance = scale / r.precision;
  }
  double const tau2 = slopes ? std::max(0.0, variance - scale / r.precision) : 0;
  return {deviance(r, scale, variance), rho, scale, variance, tau2, r.slope};
}

GrowthFit GrowthLikelihood::best(bool slopes) const {
  auto const value = [&](double log_rho) { return at(std::exp(log_rho), slopes).deviance; };
  double const low = std::log(1e-6 / statistics_.largest_eigenvalue());
  double const high = std::log(1e6 / statistics_.smallest_eigenvalue());
  return at(std::exp(least_of_all(value, low, high, grid_step).first), slopes);
}

/// With the scale held, v alone is free.
double GrowthLikelihood::held(double rho, double scale, bool slopes) const {
  auto const r = statistics_.at(rho);
  double const tied = scale / r.precision, free = r.spread / (statistics_.members() - 1);
  return deviance(r, scale, slopes ? std::max(tied, free) : tied);
}

double GrowthLikelihood::with_sigma2(double value, GrowthFit const& fit, bool slopes) const {
  if (fit.rho == 0) return held(0, value, slopes);
  if (value == 0) return at(INFINITY, slopes).deviance;
  double const centre = std::log(fit.nu2() / value);
  auto const of_rho = [&](double log_rho) { return held(std::exp(log_rho), value, slopes); };
  return least_of_all(of_rho, centre - reach, centre + reach, profile_step).second;
}

double GrowthLikelihood::with_nu2(double value, GrowthFit const& fit, bool slopes) const {
  if (std::isinf(fit.rho)) return held(INFINITY, value, slopes);
  if (value == 0) return at(0, slopes).deviance;
  double const centre = std::log(value / fit.scale);
  auto const of_rho = [&](double log_rho) { return held(std::exp(log_rho), value / std::exp(log_rho), slopes); };
  return least_of_all(of_rho, centre - reach, centre + reach, profile_step).second;
}

double GrowthLikelihood::with_tau2(double value, GrowthFit const& fit) const {
  auto const at_rho = [&](double rho) {
    auto const r = statistics_.at(rho);
    double const centre = std::log(r.residual / (statistics_.rests() * (statistics_.times() - 1)));
    auto const of_scale = [&](double log_scale) {
      double const scale = std::exp(log_scale);
      return deviance(r, scale, value + scale / r.precision);
    };
    return least(of_scale, centre - scale_reach, centre + scale_reach).second;
  };
  if (fit.rho == 0 || std::isinf(fit.rho)) return at_rho(fit.rho);
  double const centre = std::log(fit.rho);
  auto const of_rho = [&](double log_rho) { return at_rho(std::exp(log_rho)); };
  return least_of_all(of_rho, centre - reach, centre + reach, profile_step).second;
}

}  // namespace brouwer
