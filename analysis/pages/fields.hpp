#pragma once
#include <string>
#include <vector>

#include "analysis/estimates.hpp"

namespace brouwer {

/// One row a quantity, every field at full precision. Both read the same list of fields: json nests
/// "drift.per_step" and writes an interval as [lo, hi], csv has columns drift_per_step, drift_ci_low, drift_ci_high.
std::string fields_as_json(std::vector<Estimates> const& rows);
std::string fields_as_csv(std::vector<Estimates> const& rows);

}  // namespace brouwer
