#include "analysis/baseline/baseline_row.hpp"

#include <algorithm>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <cmath>
#include <limits>

#include "analysis/distributions.hpp"
#include "analysis/growth/bridge.hpp"
#include "analysis/units.hpp"
#include "analysis/verdict/verdict.hpp"

namespace brouwer {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// Beyond, a baseline would be megabytes; and so many members see a change without being paired.
constexpr Eigen::Index most_paired = 4096;

struct Mean {
  double value = 0, error = 0;  ///< and its standard error
  double variance = 0;          ///< of one number
};

/// @param numbers  near 1, so that no square under- or overflows
Mean mean_of(Eigen::ArrayXd const& numbers) {
  auto const n = static_cast<double>(numbers.size());
  double const mean = numbers[0] + (numbers - numbers[0]).mean();  // equal numbers have exactly their value as mean
  double const variance = n > 1 ? (numbers - mean).square().sum() / (n - 1) : undefined;
  return {mean, std::sqrt(variance / n), variance};
}

double median(Eigen::ArrayXd numbers) {
  std::sort(numbers.begin(), numbers.end());
  auto const n = numbers.size();
  return n % 2 == 1 ? numbers[n / 2] : (numbers[n / 2 - 1] + numbers[n / 2]) / 2;
}

/// Of each member (J−1) times its own estimate of σ².
Eigen::ArrayXd bridges(ErrorMatrix const& errors, Eigen::ArrayXd const& times) {
  Eigen::ArrayXd sums(errors.rows());
  Eigen::ArrayXd const slopes = errors.rightCols<1>().array() / times[times.size() - 1];
  for (Eigen::Index i = 0; i < errors.rows(); ++i) sums[i] = squared_bridge(errors.row(i), times, slopes[i]);
  return sums;
}

/// Standard error of ln σ = ½ ln σ²: half the relative one of the mean of the members' σ̂ᵢ².
void describe_increments(Ensemble const& ensemble, double scale, BaselineRow& row) {
  auto const samples = ensemble.errors.cols();
  if (samples < 2) return;
  auto const mean = mean_of(bridges(scale * ensemble.errors, scaled_times(ensemble, {})));
  row.increment_size = std::sqrt(mean.value / static_cast<double>(samples - 1)) / scale;
  row.increment_log_error = mean.error / (2 * mean.value);
}

void describe_slopes(Ensemble const& ensemble, double scale, BaselineRow& row) {
  Eigen::ArrayXd const slopes = scale * ensemble.errors.rightCols<1>().array() / ensemble.times.back();
  auto const mean = mean_of(slopes);
  auto const spread = mean_of((slopes - median(slopes)).abs());
  row.slope_mean = mean.value / scale;
  row.slope_error = mean.error / scale;
  row.slope_variance = mean.variance / scale / scale;
  row.slope_spread = spread.value / scale;
  row.slope_spread_error = spread.error / scale;
  Eigen::ArrayXd const own = slopes / scale;
  if (own.size() <= most_paired) row.slopes.assign(own.begin(), own.end());
}

/// [0, 0] is an interval that nobody has estimated.
void put(Interval const& interval, double& low, double& high) {
  bool const known = interval.low != 0 || interval.high != 0;
  low = known ? interval.low : undefined;
  high = known ? interval.high : undefined;
}

BaselineRow described(Estimates const& e) {
  BaselineRow row;
  row.cell = e.cell;
  row.quantity = e.quantity;
  row.unit = e.unit;
  row.time_unit = e.time_unit;
  row.verdict = to_string(e.verdict);
  row.members = e.members;
  row.failed = e.failed;
  row.samples = e.samples;
  row.duration = e.times.empty() ? undefined : e.times.back();
  row.rms_final = e.rms_final;
  row.drift = e.drift.per_step;
  row.diffusion = e.diffusion.per_sqrt_step;
  row.persistence = e.persistence.per_step;
  row.F = e.persistence.F;
  row.noise = e.noise.size;
  row.exponent = e.growth.exponent;
  row.count_mean = e.count ? e.count->mean : undefined;
  put(e.drift.interval, row.drift_low, row.drift_high);
  put(e.diffusion.interval, row.diffusion_low, row.diffusion_high);
  put(e.persistence.interval, row.persistence_low, row.persistence_high);
  put(e.noise.interval, row.noise_low, row.noise_high);
  put(e.growth.interval, row.exponent_low, row.exponent_high);
  return row;
}

void leave_comparison_undefined(BaselineRow& row) {
  for (double* number : {&row.slope_mean, &row.slope_error, &row.slope_variance, &row.slope_spread,
                         &row.slope_spread_error, &row.increment_size, &row.increment_log_error, &row.exponent_error})
    *number = undefined;
}

}  // namespace

bool same_place(BaselineRow const& a, BaselineRow const& b) { return a.cell == b.cell && a.quantity == b.quantity; }

BaselineRow baseline_row(Ensemble const& ensemble, Estimates const& estimates) {
  BaselineRow row = described(estimates);
  row.digest = digest_of(ensemble);
  leave_comparison_undefined(row);
  if (ensemble.errors.rows() == 0 || ensemble.count) return row;
  double const scale = exact_scale(largest_magnitude(ensemble.errors));
  describe_slopes(ensemble, scale, row);
  describe_increments(ensemble, scale, row);
  row.exponent_error = (row.exponent_high - row.exponent_low) / 2 /
                       student_upper_quantile((1 - estimates.levels.confidence) / 2,
                                              static_cast<double>(std::min(row.members, most_groups) - 1));
  return row;
}

std::string digest_of(Ensemble const& ensemble) {
  boost::uuids::name_generator_sha1 const generator(boost::uuids::ns::oid());
  auto const bytes = [](double const* first, std::size_t count) {
    return std::string(reinterpret_cast<char const*>(first), count * sizeof(double));
  };
  return to_string(generator(bytes(ensemble.times.data(), ensemble.times.size()) +
                             bytes(ensemble.errors.data(), static_cast<std::size_t>(ensemble.errors.size()))));
}

}  // namespace brouwer
