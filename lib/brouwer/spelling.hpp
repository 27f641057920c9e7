#pragma once
#include <string>
#include <vector>

namespace brouwer {

/// The candidate nearest to `word` (Damerau–Levenshtein distance, at most a third of its length), or "" if none is
/// near.
std::string nearest(std::string const& word, std::vector<std::string> const& candidates);

/// "; did you mean 'x'?" where one is near, otherwise "; known are a, b, c": the end of a complaint about a name.
std::string suggestion(std::string const& word, std::vector<std::string> const& candidates);

}  // namespace brouwer
