#pragma once
#include <string>

#include "analysis/estimates.hpp"

namespace brouwer {

/// Where a number is to be read: on a terminal (and in HTML, Markdown), or in LaTeX.
enum class Notation { plain, latex };

/// `digits` significant digits: "0.51", "−167", "2.3e-17"; "∞" and, where there is no number, "–".
std::string number(double x, int digits, Notation notation = Notation::plain);

/// A value with the half width of its interval, one power of ten for both: "(−2.31 ± 0.02)e-17", "0.51 ± 0.02".
std::string measured(double value, Interval interval, Notation notation = Notation::plain);

/// "p = 0.84", or "p < 1e-300", below which doubles end; "p = –" where there is no test.
std::string probability(double p);

/// 17 significant digits: read back, it is the same double. "nan" and "inf" where it is none.
std::string round_trip(double x);

/// The same for JSON, which has no number that is none: null.
std::string json_number(double x);

/// How many columns of a terminal a UTF-8 text fills.
std::size_t display_width(std::string const& text);

/// Padded with blanks to `width` columns, at its right or at its left.
std::string left_aligned(std::string const& text, std::size_t width);
std::string right_aligned(std::string const& text, std::size_t width);

}  // namespace brouwer
