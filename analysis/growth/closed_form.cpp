#include "analysis/growth/closed_form.hpp"

#include <limits>

#include "analysis/distributions.hpp"
#include "analysis/growth/bridge.hpp"
#include "analysis/student_drift.hpp"

namespace brouwer {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Drift ClosedForm::drift(Units const& units, double confidence) const {
  return units.rate(student_drift(slope, standard_error(), members - 1, confidence));
}

Persistence ClosedForm::persistence(Units const& units) const {
  double const tau2 = variance - sigma2 / duration;
  double const F = duration * variance / sigma2;
  double const m = members - 1, n = degrees();
  return {units.rate(std::sqrt(tau2 < 0 ? 0 : tau2)), F, fisher_upper(F, m, n), fisher_lower(F, m, n)};
}

Diffusion ClosedForm::diffusion(Units const& units, double confidence) const {
  double const tail = (1 - confidence) / 2, total = sigma2 * degrees();
  Interval const sigma = {std::sqrt(total / chi_squared_quantile(1 - tail, degrees())),
                          std::sqrt(total / chi_squared_quantile(tail, degrees()))};
  return {units.sqrt_rate(std::sqrt(sigma2)), units.sqrt_rate(sigma)};
}

ClosedForm closed_form(Ensemble const& ensemble, Units const& units, double rests) {
  Eigen::ArrayXd const times = scaled_times(ensemble, units);
  auto const members = ensemble.errors.rows();
  ClosedForm s{static_cast<double>(members), static_cast<double>(times.size()), rests, times[times.size() - 1]};
  Eigen::ArrayXd const slopes = units.error * ensemble.errors.rightCols<1>().array() / s.duration;
  // The first slope is subtracted before the sum, so that equal slopes have exactly their value as mean.
  s.slope = slopes[0] + (slopes - slopes[0]).mean();
  s.variance = members > 1 ? (slopes - s.slope).square().sum() / (s.members - 1) : undefined;
  for (Eigen::Index i = 0; i < members; ++i)
    s.sigma2 += squared_bridge(units.error * ensemble.errors.row(i), times, slopes[i]);
  s.sigma2 = times.size() > 1 ? s.sigma2 / s.degrees() : undefined;
  return s;
}

}  // namespace brouwer
