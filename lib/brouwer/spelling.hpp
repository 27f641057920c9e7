#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace brouwer {

/// Is the word among them, spelt the same?
bool contains(std::vector<std::string> const& words, std::string const& word);

/// ASCII letters in lower case.
std::string lower_case(std::string_view text);

/// The candidate nearest to `word`, or "" if none is near: optimal string alignment distance, at most 2 or a third of the
/// word's length, whichever is more; case, hyphens and underscores do not count.
std::string nearest(std::string const& word, std::vector<std::string> const& candidates);

/// "; did you mean 'x'?" where one is near, otherwise "; known are a, b, c": the end of a complaint about a name.
std::string suggestion(std::string const& word, std::vector<std::string> const& candidates);

}  // namespace brouwer
