#include "analysis/growth/shared_course.hpp"

#include <algorithm>
#include <cmath>

namespace brouwer {
namespace {

/// Mean over members of some number of each, and the variance of that mean.
struct MeanOf {
  double value = 0, variance = 0;

  explicit MeanOf(Eigen::ArrayXd const& numbers) {
    auto const members = static_cast<double>(numbers.size());
    value = numbers[0] + (numbers - numbers[0]).mean();
    variance = (numbers - value).square().sum() / (members - 1) / members;
  }
};

/// Errors since the start, by columns, as shares of the time from there to the end.
struct Way {
  Ensemble const& ensemble;
  Units const& units;
  Eigen::Index start;
  Eigen::ArrayXd const times = scaled_times(ensemble, units);

  double begin() const { return start < 0 ? 0 : times[start]; }
  double duration() const { return times[times.size() - 1] - begin(); }
  double share(Eigen::Index j) const { return (times[j] - begin()) / duration(); }

  Eigen::ArrayXd errors(Eigen::Index j) const {
    Eigen::ArrayXd const there = units.error * ensemble.errors.col(j).array();
    return start < 0 ? there : Eigen::ArrayXd(there - units.error * ensemble.errors.col(start).array());
  }
};

/// Of freedom, that the square of one bounded deviation is worth; of a normal one 1.
constexpr double bounded_degrees = 2;

/// Σ of the formula for ν̂_s².
struct Sums {
  double squares = 0, expected = 0, weight = 0, weight2 = 0, reach = 0;

  void add(double theta, MeanOf const& distance) {
    squares += theta * (distance.value * distance.value - distance.variance);
    expected += theta * (1 + theta * theta + (1 - theta) * (1 - theta));
    weight += theta;
    weight2 += theta * theta;
    reach = std::max(reach, std::abs(distance.value));
  }
  double variance() const { return expected > 0 ? std::max(0.0, squares) / expected : 0; }
  double degrees() const { return bounded_degrees * weight * weight / weight2; }
};

/// Welch & Satterthwaite: of the sum of two estimated variances.
double degrees_of_sum(double a, double of_a, double b, double of_b) {
  return b > 0 ? (a + b) * (a + b) / (a * a / of_a + b * b / of_b) : of_a;
}

}  // namespace

CourseOfMean course_of_mean(Ensemble const& ensemble, Units const& units, Eigen::Index start) {
  Way const way{ensemble, units, start};
  Eigen::Index const last = way.times.size() - 1;
  Eigen::ArrayXd const end = way.errors(last);
  Sums sums;
  for (Eigen::Index j = start + 1; j < last; ++j) {
    double const theta = way.share(j);
    sums.add(theta, MeanOf(way.errors(j) - theta * end));
  }
  MeanOf const slope(end / way.duration());
  double const shared = 2 * sums.variance() / (way.duration() * way.duration());
  auto const dof = static_cast<double>(ensemble.errors.rows() - 1);
  return {std::sqrt(sums.variance()), sums.reach, slope.value, std::sqrt(slope.variance + shared),
          degrees_of_sum(slope.variance, dof, shared, sums.degrees())};
}

Ensemble without_mean(Ensemble const& ensemble) {
  Ensemble apart = ensemble;
  Eigen::RowVectorXd const first = ensemble.errors.row(0);
  Eigen::RowVectorXd const mean = first + (ensemble.errors.rowwise() - first).colwise().mean();
  apart.errors.rowwise() -= mean;
  return apart;
}

}  // namespace brouwer
