#include "analysis/growth/transient.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/student_drift.hpp"

namespace brouwer {
namespace {

constexpr double early = 0.25;            // of the whole time: what begins later is no beginning
constexpr double bent_level = 0.01;       // of a mean that goes on as a wave: few members, or samples, say little of it
constexpr Eigen::Index fewest_after = 3;  // samples between it and the last: one or none cannot tell a line from a wave

/// Mean and spread over members of some number of each.
struct Sample {
  Eigen::ArrayXd values;

  double members() const { return static_cast<double>(values.size()); }
  double standard_error() const {
    return std::sqrt((values - values.mean()).square().sum() / (members() - 1) / members());
  }
  double p() const { return student_two_sided(values.mean() / standard_error(), members() - 1); }
};

bool is_opposite(Eigen::ArrayXd const& values, double side, double level) {
  Sample const sample{values};
  return sample.values.mean() * side < 0 && sample.p() < level;
}

class Course {
 public:
  Course(Ensemble const& ensemble, Units const& units)
      : errors_(units.error * ensemble.errors), times_(scaled_times(ensemble, units)) {}

  double time(Eigen::Index k) const { return k < 0 ? 0 : times_[k]; }
  Eigen::Index last() const { return times_.size() - 1; }

  /// Slopes of the members from sample a to sample b; −1 is time 0.
  Eigen::ArrayXd slopes(Eigen::Index a, Eigen::Index b) const {
    Eigen::ArrayXd const end = errors_.col(b).array();
    return (a < 0 ? end : Eigen::ArrayXd(end - errors_.col(a).array())) / (time(b) - time(a));
  }

  /// −1 where there is none.
  Eigen::Index last_before(double time) const {
    return std::upper_bound(times_.begin(), times_.end(), time) - times_.begin() - 1;
  }

  /// The p of a straight line from sample `start` on: the smallest over all places, times their number.
  double straight_p(Eigen::Index start) const {
    Eigen::Index const end = last_before((time(start) + time(last())) / 2);
    double smallest = 1;
    for (Eigen::Index k = start + 1; k <= end; ++k)
      if (double const p = Sample{slopes(start, k) - slopes(k, last())}.p(); p < smallest) smallest = p;
    return std::min(1.0, smallest * static_cast<double>(end - start));
  }

  /// Does the mean, on its way to the line that it follows from sample `end` on, leave the ground between that line and
  /// the parallel through 0? Then it swings, and what follows is the next part of a wave.
  bool swings(Eigen::Index end, double level) const {
    Eigen::ArrayXd const slope = slopes(end, last()), offset = errors_.col(end).array() - slope * time(end);
    double const side = offset.mean();
    for (Eigen::Index j = 0; j < end; ++j) {
      Eigen::ArrayXd const above = errors_.col(j).array() - slope * time(j);
      if (is_opposite(above, side, level) || is_opposite(offset - above, side, level)) return true;
    }
    return false;
  }

 private:
  Eigen::MatrixXd errors_;  // by columns: one time of all members is read at once
  Eigen::ArrayXd times_;
};

/// The first sample after which the mean is straight, between one where it is not and one where it is.
Eigen::Index settled(Course const& course, Eigen::Index bent, Eigen::Index straight, double level) {
  while (straight - bent > 1) {
    Eigen::Index const between = (bent + straight) / 2;
    (course.straight_p(between) < level ? bent : straight) = between;
  }
  return straight;
}

Drift drift_of(Sample const& slopes, Units const& units, double confidence) {
  return units.rate(student_drift(slopes.values.mean(), slopes.standard_error(), slopes.members() - 1, confidence));
}

}  // namespace

std::optional<Transient> transient_of(Ensemble const& ensemble, Units const& units, Levels const& levels) {
  if (ensemble.errors.rows() < 2 || ensemble.errors.cols() < 3) return std::nullopt;
  Course const course(ensemble, units);
  if (!(Sample{course.slopes(-1, course.last())}.standard_error() > 0)) return std::nullopt;  // equal members
  double const p = course.straight_p(-1);
  Eigen::Index const latest =
      std::min(course.last_before(early * course.time(course.last())), course.last() - 1 - fewest_after);
  double const bent = std::max(levels.test, bent_level);
  if (!(p < levels.test) || latest < 0 || course.straight_p(latest) < bent) return std::nullopt;
  Eigen::Index const end = settled(course, -1, latest, bent);
  if (course.swings(end, levels.test)) return std::nullopt;
  auto const after = Sample{course.slopes(end, course.last())};
  return Transient{ensemble.times[static_cast<std::size_t>(end)], p, drift_of(after, units, levels.confidence)};
}

}  // namespace brouwer
