#pragma once
#include <string>
#include <vector>

namespace brouwer {

/// What is held when many tests are made at once.
///     none  each test has its level
///     holm  the chance of any false alarm among them is at most the level, however they depend
///     fdr   of the alarms at most this share is false in the mean; for tests that are independent or depend positively
enum class Correction { none, holm, fdr };

/// "none", "holm", "fdr".
std::string to_string(Correction correction);
std::vector<std::string> correction_names();

/// @throws InputError for another name, with the nearest one
Correction correction_of(std::string const& name);

/// Adjusted p values, in the order given: a test is significant at a level where its adjusted p is below it. Of m tests
/// with p₍₁₎ ≤ … ≤ p₍ₘ₎
///
///     holm   max over j ≤ i of min(1, (m − j + 1) p₍ⱼ₎)     [S. Holm, Scand. J. Stat. 6 (1979) 65]
///     fdr    min over j ≥ i of min(1, m p₍ⱼ₎/j)             [Y. Benjamini & Y. Hochberg, J. R. Stat. Soc. B 57 (1995)
///            289; under positive dependence: Y. Benjamini & D. Yekutieli, Ann. Stat. 29 (2001) 1165]
///
/// NaN is no test: it stays NaN and does not count.
std::vector<double> adjusted(std::vector<double> const& p, Correction correction);

}  // namespace brouwer
