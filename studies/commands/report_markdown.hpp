#pragma once
#include <brouwer/ensemble/catalogue.hpp>
#include <filesystem>
#include <vector>

#include "analysis/estimates.hpp"

namespace brouwer {

/// Writes one page of all these results, and their main figures into the folder PAGE-figures beside it. Nothing is
/// written before every result has been read.
/// @throws InputError, RunError as Findings does, and where the page or its folder cannot be written
void write_markdown(std::vector<std::filesystem::path> const& results, std::filesystem::path const& page,
                    Levels const& levels, Catalogue const& catalogue);

}  // namespace brouwer
