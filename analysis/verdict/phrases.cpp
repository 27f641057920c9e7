#include "analysis/verdict/phrases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

/// Two significant digits, and more where the interval would otherwise not show.
int digits(double value, Interval i) {
  double const half = (i.high - i.low) / 2;
  if (!(half > 0) || !std::isfinite(value) || value == 0) return 2;
  return std::clamp(2 + static_cast<int>(std::floor(std::log10(std::abs(value) / half))), 2, 6);
}

}  // namespace

std::string brief(double x) { return number(x, 2); }

std::string with_interval(double value, Interval i, std::string const& unit, Estimates const& e) {
  int const n = digits(value, i);
  return fmt::format("{}{} ({:g} %: {} … {}", number(value, n), unit, 100 * e.levels.confidence, number(i.low, n),
                     number(i.high, n));
}

std::string decimal(double x) {
  double const rounded = std::round(100 * x) / 100;
  return (rounded < 0 ? "−" : "") + fmt::format("{:.2f}", std::abs(rounded));
}

std::string percent(double share) { return fmt::format("{:.0f} %", 100 * share); }

std::string per(Estimates const& e) { return " per " + e.time_unit; }

std::string per_root(Estimates const& e) {
  return e.time_unit.find(' ') == std::string::npos ? " per √" + e.time_unit : " per √(" + e.time_unit + ")";
}

std::string drift_interval(Drift const& drift, Estimates const& e) {
  return with_interval(drift.per_step, drift.interval, per(e), e);
}

}  // namespace brouwer
