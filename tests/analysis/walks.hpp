#pragma once
#include <Eigen/Core>

#include "tests/analysis/simulated.hpp"

namespace brouwer {

inline Eigen::ArrayXd as_array(std::vector<double> const& x) {
  return Eigen::Map<Eigen::ArrayXd const>(x.data(), std::ssize(x));
}

/// Ensembles of which the increments are asked.
inline Ensemble walks(int members = 16, int samples = 24) {
  return simulated({.drift = 1e-17, .persistence = 1e-17, .diffusion = 2e-16}, members, log_spaced(samples, 1e5), 7ul);
}

}  // namespace brouwer
