#include "analysis/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace brouwer {
namespace {

/// The exponent of the first significant digit: 0 for 1 ≤ |x| < 10.
int decade(double x) { return static_cast<int>(std::floor(std::log10(std::abs(x)))); }

/// x/10^e without underflow on the way.
double scaled(double x, int e) { return static_cast<double>(static_cast<long double>(x) / std::pow(10.0L, e)); }

std::string fixed(double x, int decimals, Notation notation) {
  std::string text = fmt::format("{:.{}f}", x, std::max(decimals, 0));
  if (text.find_first_of("123456789") == std::string::npos && text[0] == '-') text.erase(0, 1);  // no −0.0
  if (notation == Notation::plain && text[0] == '-') text.replace(0, 1, "−");
  return text;
}

/// Numbers from 0.001 up to 99 999 are read without a power of ten.
int written_exponent(int e) { return e >= -3 && e <= 4 ? 0 : e; }

std::string power_of_ten(int e, Notation notation) {
  if (e == 0) return "";
  return notation == Notation::plain ? fmt::format("e{}", e) : fmt::format("\\cdot10^{{{}}}", e);
}

std::string in_math(std::string const& text, Notation notation) {
  return notation == Notation::plain ? text : "$" + text + "$";
}

std::string not_finite(double x, Notation notation) {
  if (std::isnan(x)) return notation == Notation::plain ? "–" : "--";
  std::string const sign = x > 0 ? "" : (notation == Notation::plain ? "−" : "-");
  return in_math(sign + (notation == Notation::plain ? "∞" : "\\infty"), notation);
}

/// Decimals that leave one digit of a half width, two where it begins with 1 or 2; at most four, and at least one
/// where the larger number of the pair has only one digit before the point.
int decimals_for(double half_width, double larger) {
  int const e = decade(half_width), digits = scaled(half_width, e) < 2.5 ? 2 : 1;
  return std::clamp(digits - 1 - e, larger < 10 ? 1 : 0, 4);
}

}  // namespace

std::string number(double x, int digits, Notation notation) {
  if (!std::isfinite(x)) return not_finite(x, notation);
  if (x == 0) return in_math("0", notation);
  double const rounded =
      std::strtod(fmt::format("{:.{}e}", x, digits - 1).c_str(), nullptr);  // 9.99 to two digits is 10
  int const e = decade(std::isfinite(rounded) ? rounded : x), power = written_exponent(e);
  return in_math(fixed(scaled(rounded, power), digits - 1 - (e - power), notation) + power_of_ten(power, notation),
                 notation);
}

std::string measured(double value, Interval interval, Notation notation) {
  double const half_width = (interval.high - interval.low) / 2;
  if (!std::isfinite(value) || !std::isfinite(half_width) || half_width <= 0) return number(value, 3, notation);
  double const larger = std::max(std::abs(value), half_width);
  int const power = written_exponent(decade(larger));
  double const shown_half = scaled(half_width, power);
  int const decimals = decimals_for(shown_half, scaled(larger, power));
  std::string const pair = fixed(scaled(value, power), decimals, notation) +
                           (notation == Notation::plain ? " ± " : " \\pm ") + fixed(shown_half, decimals, notation);
  return in_math(power == 0 ? pair : "(" + pair + ")" + power_of_ten(power, notation), notation);
}

std::string probability(double p) { return p < 1e-300 ? "p < 1e-300" : "p = " + number(p, 2); }

std::string round_trip(double x) { return fmt::format("{:.17g}", x); }

std::string json_number(double x) { return std::isfinite(x) ? round_trip(x) : "null"; }

std::size_t display_width(std::string const& text) {
  auto const between = [](unsigned c, unsigned low, unsigned high) { return c >= low && c <= high; };
  std::size_t width = 0;
  for (std::size_t i = 0; i < text.size();) {
    auto const first = static_cast<unsigned char>(text[i++]);
    unsigned code = first < 0x80 ? first : first < 0xE0 ? first & 0x1Fu : first < 0xF0 ? first & 0x0Fu : first & 0x07u;
    for (; i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0u) == 0x80; ++i)
      code = (code << 6u) | (static_cast<unsigned char>(text[i]) & 0x3Fu);
    bool const combining = between(code, 0x300, 0x36F) || between(code, 0x200B, 0x200F);
    bool const wide = between(code, 0x1100, 0x115F) || between(code, 0x2E80, 0xA4CF) || between(code, 0xAC00, 0xD7A3) ||
                      between(code, 0xF900, 0xFAFF) || between(code, 0xFF00, 0xFF60) ||
                      between(code, 0x1F300, 0x1FAFF) || between(code, 0x20000, 0x3FFFD);
    width += combining ? 0 : wide ? 2 : 1;
  }
  return width;
}

std::string left_aligned(std::string const& text, std::size_t width) {
  return text + std::string(width - std::min(width, display_width(text)), ' ');
}

std::string right_aligned(std::string const& text, std::size_t width) {
  return std::string(width - std::min(width, display_width(text)), ' ') + text;
}

}  // namespace brouwer
