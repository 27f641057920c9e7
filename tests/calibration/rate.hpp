#pragma once
#include <cstdint>

#include "analysis/estimates.hpp"

namespace brouwer::calibration {

/// How often something was so.
struct Rate {
  std::int64_t hits = 0, trials = 0;

  void add(bool hit) {
    hits += hit;
    ++trials;
  }
  double value() const { return static_cast<double>(hits) / static_cast<double>(trials); }
};

/// What a claim says of a rate.
struct Nominal {
  double rate = 0;
  double slack = 0;  ///< an approximation is promised to within this
  enum class Side { told, coverage, false_alarm, power } side = Side::told;  ///< told: no rate is nominal
};

/// The chance with which a rate that is nominal leaves its bounds, on one side. So small, because hundreds are shown.
constexpr double out_of_bounds = 1e-4;

/// Smallest and largest share of hits that is consistent with the nominal rate: quantiles of the binomial law at
/// rate ± slack, rounded outwards.
Interval bounds(Nominal const& nominal, std::int64_t trials);

enum class Standing {
  holds,
  safe,   ///< out of its bounds on the harmless side: covers more often, cries wolf less often, sees more
  fails,  ///< out of its bounds on the other
};

Standing standing(Rate const& rate, Nominal const& nominal);

}  // namespace brouwer::calibration
