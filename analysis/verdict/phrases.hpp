#pragma once
#include <string>

#include "analysis/estimates.hpp"

namespace brouwer {

/// Pieces that sentences are made of, so that equal facts read equally.

/// Two significant digits.
std::string brief(double x);

/// "1.9e-16 per √step (95 %: 1.8e-16 … 2.0e-16": two digits, more where the interval would otherwise not show; the
/// caller closes the bracket.
std::string with_interval(double value, Interval i, std::string const& unit, Estimates const& e);

/// An exponent with two decimals, and no −0.00.
std::string decimal(double x);

std::string percent(double share);

/// " per step", " per √step" in the ensemble's unit of time.
std::string per(Estimates const& e);
std::string per_root(Estimates const& e);

/// A drift with its interval, the bracket open.
std::string drift_interval(Drift const& drift, Estimates const& e);

}  // namespace brouwer
