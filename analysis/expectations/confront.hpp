#pragma once
#include <string>
#include <vector>

#include "analysis/expectations/expectation.hpp"

namespace brouwer {

/// The parts of an expectation that speak of single rows (drift, growth, persistence, mean, RMS, verdict) against one row.
std::vector<Outcome> confront(Expectation const& expectation, Estimates const& row);

/// "energy, elliptic-naive, double, h = 0.01": the beginning of a claim.
std::string claimed_of(Estimates const& row, bool with_step = true);

/// "; 3 of 64 members are left out: …", or nothing.
std::string but_for_failures(Estimates const& row);

}  // namespace brouwer
