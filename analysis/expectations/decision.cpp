#include "analysis/expectations/decision.hpp"

#include <algorithm>
#include <boost/math/distributions/non_central_t.hpp>
#include <cmath>
#include <limits>

#include "analysis/calm.hpp"
#include "analysis/distributions.hpp"
#include "analysis/growth/inference.hpp"

namespace brouwer {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr double surely_seen = 40;  ///< a noncentrality beyond this many critical values; Boost's law ends soon after

double chance_beyond(double critical, double dof, double noncentrality) {
  if (noncentrality > surely_seen * std::max(1.0, critical)) return 1;
  boost::math::non_central_t_distribution<double, Calm> const law(dof, noncentrality);
  return cdf(complement(law, critical)) + cdf(law, -critical);
}

}  // namespace

double standard_error(Estimates const& e) {
  return e.smallest_visible_drift / visible_noncentrality(e.drift_degrees(), e.levels);
}

double chance_to_see(double drift, Estimates const& e) {
  double const noncentrality = std::abs(drift) / standard_error(e);
  if (drift == 0) return std::isnan(standard_error(e)) ? undefined : e.levels.test;
  if (std::isnan(noncentrality)) return undefined;
  return chance_beyond(student_upper_quantile(e.levels.test / 2, e.drift_degrees()), e.drift_degrees(), noncentrality);
}

double drift_seen_with(double chance, Estimates const& e) {
  Levels levels = e.levels;
  levels.power = chance;
  return standard_error(e) * visible_noncentrality(e.drift_degrees(), levels);
}

PowerCurve power_curve(Estimates const& e) {
  PowerCurve curve;
  if (std::isnan(e.smallest_visible_drift)) return curve;
  for (double const multiple : {0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0}) {
    curve.drifts.push_back(multiple * e.smallest_visible_drift);
    curve.chances.push_back(chance_to_see(curve.drifts.back(), e));
  }
  return curve;
}

Equivalence equivalence(Estimates const& e, double bound, double level) {
  double const s = standard_error(e), beta = e.drift.per_step,
               half = student_upper_quantile(level, e.drift_degrees()) * s;
  Equivalence found{(beta + bound) / s, (bound - beta) / s, 1, {beta - half, beta + half}, std::abs(beta) + half};
  double const t = (bound - std::abs(beta)) / s;  // the smaller of the two; of NaN neither would be
  double const beyond = student_two_sided(t, e.drift_degrees()) / 2;
  found.p = t < 0 ? 1 - beyond : beyond;
  return found;
}

double smallest_provable_drift(Estimates const& e) { return equivalence(e, 0, e.levels.test).provable; }

}  // namespace brouwer
