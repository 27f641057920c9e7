#pragma once
#include <string>
#include <vector>

#include "analysis/causes/explanation.hpp"

namespace brouwer {

/// For people: of each explanation what was asked, a line a cell, the effects of the factorial, the cause in a sentence.
/// Ends with a legend.
std::string explain_text(std::vector<Explanation> const& explanations);
std::string explain_markdown(std::vector<Explanation> const& explanations);

/// An array with an object an explanation, all numbers with 17 digits; those that are not known are null.
std::string explain_json(std::vector<Explanation> const& explanations);

/// "energy, elliptic-naive, h = 0.01": what is explained, without what all of these share.
std::string subject_line(Explanation const& explanation, std::vector<Explanation> const& all);

}  // namespace brouwer
