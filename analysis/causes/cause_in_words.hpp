#pragma once
#include <string>

#include "analysis/causes/explanation.hpp"

namespace brouwer {

/// The cause of an explanation with the numbers that show it: "The drift comes from the rounded constants: it persists
/// (97 … 103 %) with stochastic rounding and vanishes (−2 … 1 %) with exact constants."; then what the other changes of
/// one factor do, and which of them change σ by more than a factor of two.
std::string cause_in_words(Explanation const& explanation);

}  // namespace brouwer
