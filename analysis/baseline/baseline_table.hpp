#pragma once
#include <string>

#include "analysis/baseline/baseline.hpp"

namespace brouwer {

/// The history of a baseline, for people: under each quantity of each cell a line an entry, the oldest first; where the
/// bits are those of the entry before, that is all there is to say.
std::string history_table(Baseline const& baseline);

}  // namespace brouwer
