#include "analysis/growth/growth_intervals.hpp"

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <functional>

#include "analysis/distributions.hpp"

namespace brouwer {
namespace {

using Profile = std::function<double(double)>;  // −2 log L as a function of a variance, minimised over the rest

constexpr double stride = 4;          // of a variance, in search of the far side of an end
constexpr int most_strides = 60;      // 10³⁶ times the estimate: further than any scaled value goes
constexpr std::uintmax_t turns = 40;  // of the root finder, which needs about eight

/// Where the profile passes `bound` between two values of which it is below at one and above at the other.
double crossing(Profile const& profile, double bound, double a, double b) {
  auto const excess = [&](double log_value) { return profile(std::exp(log_value)) - bound; };
  auto const tolerance = boost::math::tools::eps_tolerance<double>(20);
  auto rounds = turns;
  double const low = std::log(std::min(a, b)), high = std::log(std::max(a, b));
  auto const found = boost::math::tools::toms748_solve(excess, low, high, tolerance, rounds);
  return std::exp((found.first + found.second) / 2);
}

/// The end on one side of `inside`: factor > 1 searches upwards, < 1 downwards, where it may end at 0 or nowhere.
double end(Profile const& profile, double bound, double inside, double factor, double otherwise) {
  double last = inside;
  for (int k = 0; k < most_strides; ++k) {
    double const next = last * factor;
    if (profile(next) > bound) return crossing(profile, bound, last, next);
    last = next;
  }
  return otherwise;
}

/// Square roots of the ends. @param start  where the estimate is 0: a variance that is small beside what is seen
Interval interval(Profile const& profile, double bound, double estimate, double start) {
  double inside = estimate > 0 ? estimate : start;
  for (int k = 0; estimate == 0 && profile(inside) > bound; ++k) {
    if (k == most_strides) return {0, 0};
    inside /= stride;
  }
  double const low = profile(0) <= bound ? 0 : end(profile, bound, inside, 1 / stride, 0);
  return {std::sqrt(low), std::sqrt(end(profile, bound, inside, stride, INFINITY))};
}

}  // namespace

ProfileIntervals profile_intervals(GrowthLikelihood const& likelihood, GrowthFit const& fit, LawTerms const& terms,
                                   double confidence, double inflation) {
  double const quantile = inflation * chi_squared_quantile(confidence, 1);
  double const bartlett = 1 + 1 / (3 * (likelihood.statistics().members() - 1));
  ProfileIntervals found;
  auto const bounded = [&](double factor) { return fit.deviance + quantile * factor; };
  if (terms.walk)
    found.sigma =
        interval([&](double x) { return likelihood.with_sigma2(x, fit, terms.slopes); }, bounded(1), fit.sigma2(), 0);
  if (terms.noise)
    found.nu = interval([&](double x) { return likelihood.with_nu2(x, fit, terms.slopes); }, bounded(1), fit.nu2(), 0);
  double const slopes_at_least = fit.slope_variance / 1024;
  GrowthFit const free = terms.slopes ? fit : likelihood.at(fit.rho, true);
  found.tau = interval([&](double x) { return likelihood.with_tau2(x, fit); }, free.deviance + quantile * bartlett,
                       free.tau2, slopes_at_least);
  return found;
}

}  // namespace brouwer
