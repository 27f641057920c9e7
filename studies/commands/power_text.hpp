#pragma once
#include <optional>
#include <string>

#include "analysis/probe/local_errors.hpp"
#include "analysis/probe/power.hpp"

namespace brouwer {

/// One quantity of a planned ensemble, as a probe of single steps has found it.
struct PlannedRow {
  LocalEstimates local;
  Prediction prediction;
  std::int64_t members = 0;          ///< that will have this quantity
  double seconds_a_member_step = 0;  ///< of the whole machine
};

/// Lines that say which drifts the ensemble would see and could exclude, and, where a drift is given, what it would take
/// to see and to exclude that one. Persistent slopes count where the probe saw them.
std::string power_text(PlannedRow const& row, std::optional<double> drift);

}  // namespace brouwer
