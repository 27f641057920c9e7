#include "analysis/increments/increments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "analysis/increments/autocorrelation.hpp"
#include "analysis/increments/free_increments.hpp"
#include "analysis/increments/histogram.hpp"
#include "analysis/increments/normality.hpp"
#include "analysis/increments/variance_ratio.hpp"
#include "analysis/multiplicity.hpp"
#include "analysis/power_law.hpp"

namespace brouwer {
namespace {

using Index = Eigen::Index;

constexpr Index most_lags = 5;
constexpr Index most_parts =
    64;  ///< of the members, summed each by itself: their number decides on bits, threads do not
constexpr Index fewest_in_part = 32;

/// The ensemble as numbers near 1, in which no power of an increment over- or underflows.
struct Scaled {
  explicit Scaled(Ensemble const& ensemble)
      : errors(ensemble.errors),
        error_unit(exact_scale(largest_magnitude(ensemble.errors))),
        time_unit(exact_scale(ensemble.times.back())),
        times(time_unit * Eigen::Map<Eigen::ArrayXd const>(ensemble.times.data(), std::ssize(ensemble.times))),
        free(times) {}

  Eigen::ArrayXd increments(Index member) const { return free(errors.row(member), error_unit); }
  Index members() const { return errors.rows(); }
  Index count() const { return members() * free.count(); }

  /// In the ensemble's own units.
  VarianceRatio restored(VarianceRatio ratio) const {
    double const per_root = std::sqrt(time_unit) / error_unit;
    ratio.scale /= time_unit;
    for (double* sigma : {&ratio.sigma, &ratio.sigma_interval.low, &ratio.sigma_interval.high}) *sigma *= per_root;
    return ratio;
  }

  ErrorMatrix const& errors;
  double error_unit, time_unit;  // what errors and times are multiplied by
  Eigen::ArrayXd times;
  FreeIncrements free;
};

/// Sums over the members of one part, or of all.
struct Sums {
  Sums(Scaled const& scaled, std::vector<Aggregation> const& scales) {
    auto const members = scaled.members(), length = scaled.free.count();
    for (Index lag = 1; lag <= std::min(most_lags, length - 1); ++lag) lags.emplace_back(lag, members, length);
    for (auto const& scale : scales) aggregates.emplace_back(scale, members);
  }

  void add(Eigen::ArrayXd const& w) {
    Eigen::ArrayXd const squares = w.square();
    double const sum = squares.sum();
    for (auto& lag : lags) lag.add(w, sum);
    for (auto& aggregate : aggregates) aggregate.add(w);
    powers += {static_cast<double>(w.size()), w.sum(), sum, (w * squares).sum(), squares.square().sum()};
  }

  Sums& operator+=(Sums const& other) {
    for (std::size_t k = 0; k < lags.size(); ++k) lags[k] += other.lags[k];
    for (std::size_t k = 0; k < aggregates.size(); ++k) aggregates[k] += other.aggregates[k];
    powers += other.powers;
    return *this;
  }

  std::vector<LagSums> lags;
  std::vector<AggregateSums> aggregates;
  PowerSums powers;
};

/// Values over their σ: all of them counted, and some of them kept.
struct Shape {
  explicit Shape(Index count) : histogram(static_cast<std::size_t>(count)) {}

  Shape& operator+=(Shape const& other) {
    histogram.add(other.histogram);
    sample.insert(sample.end(), other.sample.begin(), other.sample.end());
    return *this;
  }

  Histogram histogram;
  std::vector<double> sample;
};

/// Part by part over the members, in parallel; the parts are then summed in their order.
template <class Part, class Add>
Part summed(Index members, Part const& empty, Add add) {
  Index const parts = std::clamp<Index>(members / fewest_in_part, 1, most_parts);
  std::vector<Part> each(static_cast<std::size_t>(parts), empty);
#pragma omp parallel for schedule(dynamic) if (parts == most_parts)
  for (Index part = 0; part < parts; ++part)
    for (Index i = part * members / parts; i < (part + 1) * members / parts; ++i)
      add(each[static_cast<std::size_t>(part)], i);
  Part total = empty;
  for (auto const& part : each) total += part;
  return total;
}

/// The least distance at which so many values leave at most the sample, and all sample times the same share of it.
Index stride_of(Index count, Index increments) {
  auto const most = static_cast<Index>(most_for_normality);
  Index stride = (count + most - 1) / most;
  while (std::gcd(stride, increments) > 1) ++stride;
  return stride;
}

Shape shape_of(Scaled const& scaled, double sigma) {
  Index const increments = scaled.free.count(), stride = stride_of(scaled.count(), increments);
  return summed(scaled.members(), Shape(scaled.count()), [&](Shape& shape, Index member) {
    Eigen::ArrayXd const z = scaled.increments(member) / sigma;
    for (double const value : z) shape.histogram.add(value);
    Index const before = member * increments;
    for (Index n = (before + stride - 1) / stride * stride; n < before + increments; n += stride)
      shape.sample.push_back(z[n - before]);
  });
}

void describe_shape(Scaled const& scaled, PowerSums const& powers, IncrementTests& tests) {
  auto shape = shape_of(scaled, std::sqrt(powers.second / powers.count));
  tests.normality = normality(std::move(shape.sample), powers);
  tests.histogram_density = shape.histogram.density();
  for (std::size_t bin = 0; bin < shape.histogram.bins(); ++bin)
    tests.histogram_z.push_back(shape.histogram.centre(bin));
}

/// Of the ratios at all scales together, whatever they have to do with one another.
double joint_p(std::vector<VarianceRatio> const& ratios) {
  std::vector<double> p;
  for (auto const& ratio : ratios) p.push_back(ratio.p);
  double least = std::numeric_limits<double>::quiet_NaN();
  for (double const one : adjusted(p, Correction::holm)) least = std::fmin(least, one);
  return least;
}

}  // namespace

std::optional<IncrementTests> increment_tests(Ensemble const& ensemble, Levels const& levels) {
  if (ensemble.times.size() < 2) return std::nullopt;
  Scaled const scaled(ensemble);
  auto const members = scaled.members();
  auto const scales = aggregations(scaled.times, members);
  auto const sums =
      summed(members, Sums(scaled, scales), [&](Sums& part, Index member) { part.add(scaled.increments(member)); });
  if (!(sums.powers.second > 0)) return std::nullopt;
  IncrementTests tests;
  tests.count = scaled.count();
  for (auto const& lag : sums.lags) tests.autocorrelations.push_back(lag.result(levels.confidence));
  for (auto const& aggregate : sums.aggregates)
    tests.variance_ratios.push_back(scaled.restored(aggregate.result(levels.confidence)));
  tests.variance_ratio_p = joint_p(tests.variance_ratios);
  describe_shape(scaled, sums.powers, tests);
  return tests;
}

}  // namespace brouwer
