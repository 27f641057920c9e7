#pragma once
#include <string>
#include <vector>

#include "analysis/probe/probe_words.hpp"

namespace brouwer {

/// For people: a block of lines for each row, of one cell.
std::string probe_text(std::vector<ProbedRow> const& rows);

/// An array with an object a row; numbers that are not known are null.
std::string probe_json(std::vector<ProbedRow> const& rows);

}  // namespace brouwer
