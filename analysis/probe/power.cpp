#include "analysis/probe/power.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

#include "analysis/distributions.hpp"
#include "analysis/growth/inference.hpp"

namespace brouwer {
namespace {

constexpr std::int64_t most_members = 1'000'000'000'000'000;

/// Density of s/σ for `dof` degrees of freedom: √(χ²(dof)/dof).
double density_of_spread(double s, double dof) {
  return 2 * dof * s * boost::math::pdf(boost::math::chi_squared(dof), dof * s * s);
}

/// P(|z| + t s < δ), z ~ N(0, 1), s as above: that the interval lies inside ±δ standard errors.
double chance_to_exclude(double delta, double t, double dof) {
  auto const integrand = [&](double s) {
    return std::erf((delta - t * s) / std::sqrt(2.0)) * density_of_spread(s, dof);
  };
  // all but 1e-20 of s lies within ten of its standard deviations, 1/√(2 dof), of 1
  double const low = std::max(0.0, 1 - 10 / std::sqrt(2 * dof)),
               high = std::min(delta / t, 1 + 10 / std::sqrt(2 * dof));
  if (high <= low) return 0;
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(integrand, low, high, 3, 1e-9);
}

double excluding_noncentrality(double dof, Levels const& levels) {
  double const t = student_upper_quantile((1 - levels.confidence) / 2, dof);
  auto const missing = [&](double delta) { return chance_to_exclude(delta, t, dof) - levels.power; };
  std::uintmax_t turns = 100;
  auto const [low, high] = boost::math::tools::bracket_and_solve_root(
      missing, t + 2, 2.0, true, boost::math::tools::eps_tolerance<double>(40), turns);
  return (low + high) / 2;
}

double variance_of_slope(Spread const& spread, double steps) {
  return spread.diffusion * spread.diffusion / steps + spread.persistence * spread.persistence;
}

}  // namespace

double needed_noncentrality(Question question, std::int64_t members, Levels const& levels) {
  double const dof = static_cast<double>(members - 1);
  return question == Question::see ? visible_noncentrality(dof, levels) : excluding_noncentrality(dof, levels);
}

double answerable_drift(Question question, Spread const& spread, std::int64_t members, std::int64_t steps,
                        Levels const& levels) {
  if (members < 2) return std::numeric_limits<double>::quiet_NaN();
  return needed_noncentrality(question, members, levels) *
         std::sqrt(variance_of_slope(spread, static_cast<double>(steps)) / static_cast<double>(members));
}

std::optional<double> steps_needed(Question question, double drift, Spread const& spread, std::int64_t members,
                                   Levels const& levels) {
  double const error = std::abs(drift) / needed_noncentrality(question, members, levels);
  double const left = static_cast<double>(members) * error * error - spread.persistence * spread.persistence;
  if (!(left > 0)) return std::nullopt;
  return std::ceil(spread.diffusion * spread.diffusion / left);
}

std::optional<std::int64_t> members_needed(Question question, double drift, Spread const& spread, double steps,
                                           Levels const& levels) {
  auto const enough = [&](std::int64_t members) {
    double const error = std::sqrt(variance_of_slope(spread, steps) / static_cast<double>(members));
    return needed_noncentrality(question, members, levels) * error <= std::abs(drift);
  };
  std::int64_t high = 2;
  while (!enough(high)) {
    if (high >= most_members) return std::nullopt;
    high *= 2;
  }
  for (std::int64_t low = high / 2; low + 1 < high;) {
    std::int64_t const middle = low + (high - low) / 2;
    (enough(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace brouwer
