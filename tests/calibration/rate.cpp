#include "tests/calibration/rate.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>

namespace brouwer::calibration {

Interval bounds(Nominal const& nominal, std::int64_t trials) {
  using boost::math::binomial_distribution;
  auto const n = static_cast<double>(trials);
  binomial_distribution<> const lowest(n, std::max(0.0, nominal.rate - nominal.slack));
  binomial_distribution<> const highest(n, std::min(1.0, nominal.rate + nominal.slack));
  return {quantile(lowest, out_of_bounds) / n, quantile(complement(highest, out_of_bounds)) / n};
}

Standing standing(Rate const& rate, Nominal const& nominal) {
  auto const [low, high] = bounds(nominal, rate.trials);
  if (low <= rate.value() && rate.value() <= high) return Standing::holds;
  bool const above = rate.value() > high;
  return above == (nominal.side != Nominal::Side::false_alarm) ? Standing::safe : Standing::fails;
}

}  // namespace brouwer::calibration
