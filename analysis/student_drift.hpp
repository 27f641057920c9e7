#pragma once
#include "analysis/distributions.hpp"
#include "analysis/estimates.hpp"

namespace brouwer {

/// A mean with its interval and its test by Student's law; what it explains of the final error is left open.
/// @param error  its standard error, of `dof` degrees of freedom
inline Drift student_drift(double mean, double error, double dof, double confidence) {
  double const half = student_upper_quantile((1 - confidence) / 2, dof) * error, t = mean / error;
  return {mean, {mean - half, mean + half}, t, student_two_sided(t, dof), 0};
}

}  // namespace brouwer
