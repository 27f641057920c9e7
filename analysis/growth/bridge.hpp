#pragma once
#include <Eigen/Core>

namespace brouwer {

/// Σⱼ (Δⱼ − δⱼs)²/δⱼ of one member: what is left of its path when the straight line to its end is taken away.
template <class Row>
double squared_bridge(Row const& error, Eigen::ArrayXd const& times, double slope) {
  double sum = 0, last_error = 0, last_time = 0;
  for (Eigen::Index j = 0; j < times.size(); ++j) {
    double const delta = times[j] - last_time;
    double const residual = error[j] - last_error - delta * slope;
    sum += residual * residual / delta;
    last_error = error[j];
    last_time = times[j];
  }
  return sum;
}

}  // namespace brouwer
