#include "analysis/probe/local_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <brouwer/error.hpp>
#include <cmath>
#include <limits>

#include "analysis/student_drift.hpp"

namespace brouwer {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr Eigen::Index most_lags = 8;
/// Share of the rounding errors up to which a method's own errors do not spoil their walk.
constexpr double little_truncation = 0.1;
/// Share of σ²_L by which half windows must differ before correlation counts as longer than a window.
constexpr double much_change = 0.1;

/// Members × steps, seen as W windows of L steps each, errors about their member's mean.
class Windows {
 public:
  Windows(ErrorMatrix const& errors, std::int64_t windows)
      : means_(errors.rowwise().mean()),
        about_(errors.colwise() - means_.matrix()),
        windows_(windows),
        length_(errors.cols() / windows) {}

  double members() const { return static_cast<double>(about_.rows()); }
  double windows() const { return static_cast<double>(windows_); }
  double steps() const { return static_cast<double>(about_.cols()); }
  Eigen::Index length() const { return length_; }
  Eigen::ArrayXd const& means() const { return means_; }

  /// σ²ₙ of each member from its sums of n consecutive steps. Σ(sum − n m)² misses what m itself varies; it is given
  /// back: with K = W L/n sums, σ²ₙ = Σ(…)²/(n K) + (n/L) σ²_L/W, and σ²_L = Σ(…)²/(L(W−1)).
  Eigen::ArrayXd walk(Eigen::Index n) const {
    if (n == length_) return squares(n) / (static_cast<double>(n) * (windows() - 1));
    return squares(n) / steps() + static_cast<double>(n) / steps() * walk(length_);
  }

  /// Of errors k steps apart in one window, likewise.
  double covariance(Eigen::Index k) const {
    double sum = 0;
    for (Eigen::Index w = 0; w < windows_; ++w)
      sum += about_.middleCols(w * length_, length_ - k)
                 .cwiseProduct(about_.middleCols(w * length_ + k, length_ - k))
                 .sum();
    return sum / (members() * windows() * static_cast<double>(length_ - k)) + walk(length_).mean() / steps();
  }

 private:
  /// Σ(sum of n consecutive steps about the mean)² of each member.
  Eigen::ArrayXd squares(Eigen::Index n) const {
    Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(about_.rows());
    for (Eigen::Index k = 0; k < about_.cols(); k += n) sum += about_.middleCols(k, n).rowwise().sum().array().square();
    return sum;
  }

  Eigen::ArrayXd means_;
  ErrorMatrix about_;
  Eigen::Index windows_, length_;
};

/// A mean over members with its t.
Drift mean_over_members(Eigen::ArrayXd const& each, Levels const& levels) {
  double const members = static_cast<double>(each.size()), mean = each[0] + (each - each[0]).mean();
  double const error = std::sqrt((each - mean).square().sum() / (members * (members - 1)));
  return student_drift(mean, error, members - 1, levels.confidence);
}

double root(double square) { return std::sqrt(std::max(square, 0.0)); }

bool still_changing(Windows const& steps, Levels const& levels) {
  auto const whole = steps.walk(steps.length());
  auto const change = mean_over_members(whole - steps.walk(steps.length() / 2), levels);
  return change.p < levels.test && std::abs(change.per_step) > much_change * whole.mean();
}

Diffusion diffusion_of(Windows const& steps, bool changing, Levels const& levels) {
  auto const whole = steps.walk(steps.length());
  auto const square =
      mean_over_members(changing ? whole : Eigen::ArrayXd(2 * whole - steps.walk(steps.length() / 2)), levels);
  return {root(square.per_step), {root(square.interval.low), root(square.interval.high)}};
}

Persistence persistence_of(Windows const& steps, Levels const& levels) {
  double const m = steps.members() - 1, n = steps.members() * (steps.windows() - 1);
  double const variance = (steps.means() - steps.means().mean()).square().sum() / m;
  double const of_walk = steps.walk(steps.length()).mean() / steps.steps(), F = variance / of_walk;
  if (!(of_walk > 0)) return {std::sqrt(variance), F, fisher_upper(F, m, n), fisher_lower(F, m, n), {0, undefined}};
  boost::math::fisher_f const law(m, n);
  auto const tau = [&](double quantile) { return root(of_walk * (F / quantile - 1)); };
  double const tail = (1 - levels.confidence) / 2;
  return {tau(1),
          F,
          fisher_upper(F, m, n),
          fisher_lower(F, m, n),
          {tau(quantile(complement(law, tail))), tau(quantile(law, tail))}};
}

std::vector<double> autocorrelation_of(Windows const& steps) {
  std::vector<double> correlation;
  for (Eigen::Index k = 1; k <= std::min(most_lags, steps.length() / 2); ++k)
    correlation.push_back(steps.covariance(k) / steps.covariance(0));
  return correlation;
}

std::vector<double> scales_of(Windows const& steps) {
  std::vector<double> scales;
  for (Eigen::Index n = 1; n <= steps.length(); n *= 2)
    if (steps.length() % n == 0) scales.push_back(root(steps.walk(n).mean()));
  return scales;
}

/// Mean and size only: of single steps, or of windows that are no sample of a walk.
LocalLaw sizes_of(ErrorMatrix const& errors, Levels const& levels) {
  LocalLaw law;
  law.size = std::sqrt(errors.array().square().mean());
  law.bias = mean_over_members(errors.rowwise().mean().array(), levels);
  law.bias.share = law.size > 0 ? std::min(1.0, std::abs(law.bias.per_step) / law.size) : 0;
  law.diffusion = {undefined, {undefined, undefined}};
  law.persistence = {undefined, undefined, undefined, undefined, {undefined, undefined}};
  return law;
}

LocalLaw law_of(ErrorMatrix const& errors, std::int64_t windows, Levels const& levels) {
  LocalLaw law = sizes_of(errors, levels);
  Windows const steps(errors, windows);
  law.still_changing = still_changing(steps, levels);
  law.diffusion = diffusion_of(steps, law.still_changing, levels);
  law.persistence = persistence_of(steps, levels);
  law.autocorrelation = autocorrelation_of(steps);
  law.scales = scales_of(steps);
  return law;
}

}  // namespace

LocalEstimates estimate(LocalErrors const& errors, Levels const& levels) {
  LocalEstimates local{errors.cell,
                       errors.high_precision,
                       errors.quantity,
                       errors.family,
                       errors.unit,
                       errors.of_state,
                       errors.rounding.rows(),
                       errors.failed,
                       errors.windows,
                       errors.length,
                       errors.judged,
                       errors.covered,
                       errors.failures,
                       {},
                       {},
                       {},
                       levels};
  if (local.members < 2)
    throw InputError(fmt::format("{} of {}: {} members came through the probe, expected at least 2 (of {})",
                                 errors.quantity, errors.cell.method, local.members, local.members + local.failed));
  local.rounding =
      errors.of_state ? sizes_of(errors.rounding, levels) : law_of(errors.rounding, errors.windows, levels);
  if (errors.truncation.cols() == 0) return local;
  local.truncation = sizes_of(errors.truncation, levels);
  if (errors.truncation.cols() == errors.rounding.cols())
    local.both = law_of(errors.rounding + errors.truncation, errors.windows, levels);
  return local;
}

std::optional<Prediction> predict(LocalEstimates const& local, std::int64_t steps) {
  if (local.of_state) return std::nullopt;
  LocalLaw const& law = local.both ? *local.both : local.rounding;
  bool const walks = !local.both || local.truncation->size <= little_truncation * local.rounding.size;
  double const N = static_cast<double>(steps), sigma = walks ? law.diffusion.per_sqrt_step : undefined;
  auto persistence = law.persistence;
  if (!walks) persistence = {undefined, undefined, undefined, undefined, {undefined, undefined}};
  persistence.F = 1 + N * std::pow(persistence.per_step / sigma, 2);
  double const beta = law.bias.p < local.levels.test ? law.bias.per_step : 0;
  double const tau = law.persistence.p < local.levels.test ? law.persistence.per_step : 0;
  return Prediction{law.bias, walks ? law.diffusion : Diffusion{undefined, {undefined, undefined}}, persistence,
                    walks ? std::hypot(beta * N, tau * N, sigma * std::sqrt(N)) : std::abs(law.bias.per_step) * N};
}

}  // namespace brouwer
