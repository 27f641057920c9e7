#pragma once
#include <string>

namespace brouwer {

// Two studies, by their canonical texts (one `key = value` a line), and whether their estimates may be compared. What
// the members start from, how they are perturbed, when they are observed and with what they are compared must agree;
// methods, steps and quantities only decide which cells there are, which their labels tell; other members of the same
// population, or more of them, are another sample of the same estimates.

/// @throws InputError that says what differs where estimates may not be compared
void require_same_question(std::string const& there, std::string const& here);

/// What else differs, for people: "members was 64 there and is 128 here"; "" where nothing does.
std::string harmless_changes(std::string const& there, std::string const& here);

/// Are member i's starts the same in both, so that members can be compared one by one?
bool same_members(std::string const& there, std::string const& here);

}  // namespace brouwer
