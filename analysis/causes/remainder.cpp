#include "analysis/causes/remainder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

constexpr double half = 0.5;  ///< more of it is there, less is gone
constexpr int most_decimals = 3;
constexpr double little = 0.005;  ///< so little is called nothing, and no difference, however surely it is some

bool holds(Interval const& i, double x) { return i.low <= x && x <= i.high; }

/// A way to be, the condition for it, and its words; the first whose condition holds.
struct Way {
  char const* word;
  char const* verb;
  bool says_how_much;
  bool (*is)(Interval const&);
};

bool is_within(Interval const& i, double x) { return x - little < i.low && i.high < x + little; }

bool is_gone(Interval const& i) { return -half < i.low && i.high < half; }
bool is_nothing(Interval const& i) { return is_gone(i) && (holds(i, 0) || is_within(i, 0)); }
bool is_there(Interval const& i) { return i.low > half || i.high < -half; }

constexpr Way ways[] = {
    {"gone", "vanishes", false, is_nothing},
    {"falls", "falls to", true, is_gone},
    {"stays", "persists", false, [](Interval const& i) { return is_there(i) && (holds(i, 1) || is_within(i, 1)); }},
    {"turns", "turns to", true, [](Interval const& i) { return is_there(i) && i.high < 0; }},
    {"shrinks", "shrinks to", true, [](Interval const& i) { return is_there(i) && i.high < 1; }},
    {"grows", "grows to", true, is_there},
    {"?", "may be gone or not", false, [](Interval const&) { return true; }},
};

Way const& way_of(Share const& left) {
  return *std::find_if(std::begin(ways), std::end(ways), [&](Way const& way) { return way.is(left.interval); });
}

/// Decimals of a percentage whose interval is so wide: two digits of the width.
int decimals(Interval const& i) {
  double const width = 100 * (i.high - i.low);
  if (width == 0) return most_decimals;
  if (!std::isfinite(width)) return 0;
  return std::clamp(static_cast<int>(std::floor(1 - std::log10(width))), 0, most_decimals);
}

std::string hundredfold(double share, int digits) {
  if (!std::isfinite(share)) return share > 0 ? "∞" : share < 0 ? "−∞" : "–";
  if (std::abs(share) >= 1e4) return number(100 * share, 3);
  std::string text = fmt::format("{:.{}f}", 100 * std::abs(share), digits);
  bool const zero = text.find_first_of("123456789") == std::string::npos;
  return (share < 0 && !zero ? "−" : "") + text;
}

}  // namespace

Remainder remainder_of(Share const& left) {
  if (is_gone(left.interval)) return Remainder::gone;
  return is_there(left.interval) ? Remainder::there : Remainder::unknown;
}

std::string percent_range(Interval const& interval) {
  if (is_within(interval, 0) && decimals(interval) == most_decimals) return "0 %";
  if (is_within(interval, 1) && decimals(interval) == most_decimals) return "100 %";
  int const digits = decimals(interval);
  return fmt::format("{} … {} %", hundredfold(interval.low, digits), hundredfold(interval.high, digits));
}

std::string in_words(Share const& left) {
  auto const& way = way_of(left);
  std::string const much =
      way.says_how_much ? fmt::format(" {} %", hundredfold(left.value, decimals(left.interval))) : "";
  return fmt::format("{}{} ({})", way.verb, much, percent_range(left.interval));
}

std::string in_a_word(Share const& left) { return way_of(left).word; }

}  // namespace brouwer
