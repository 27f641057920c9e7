#pragma once
#include <string>

#include "analysis/causes/explanation.hpp"

namespace brouwer {

/// What becomes of something when the arithmetic is changed. It is gone where less than half of it is left, and there
/// where more than half of it is (of either sign), each proven by the interval; unknown where the interval allows both.
enum class Remainder { unknown, gone, there };

Remainder remainder_of(Share const& left);

/// The verb that the interval allows, with it: "vanishes (−3 … 4 %)", "falls to 12 % (9 … 15 %)"; "persists (97 … 103 %)",
/// "shrinks to 70 % (62 … 78 %)", /// "grows to 144 % (138 … 151 %)", "turns to −98 % (−103 … −93 %)", "may be gone or not (−20 … 130 %)".
std::string in_words(Share const& left);

/// The same in a table: "gone", "falls"; "stays", "shrinks", "grows", "turns"; "?"
std::string in_a_word(Share const& left);

/// "97 … 103 %", with as many digits as tell its ends apart.
std::string percent_range(Interval const& interval);

}  // namespace brouwer
