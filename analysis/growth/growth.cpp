#include "analysis/growth/growth.hpp"

#include <cmath>

#include "analysis/power_law.hpp"

namespace brouwer {

Growth growth_of(Ensemble const& ensemble, double confidence) {
  Eigen::MatrixXd design(std::ssize(ensemble.times), 2);
  for (Eigen::Index j = 0; j < design.rows(); ++j)
    design.row(j) << 1, std::log(ensemble.times[static_cast<std::size_t>(j)]);
  auto const members = ensemble.errors.rows();
  auto const squares = grouped_squares(ensemble.errors, members, exact_scale(largest_magnitude(ensemble.errors)));
  auto const law = fit_power_law(squares, members, design, confidence);
  return {law.coefficients[1], law.intervals[1]};
}

}  // namespace brouwer
