#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace brouwer {

/// Runs `gnuplot SCRIPT` in a folder, without a shell and without the user's own gnuplot settings. Where it fails, or
/// leaves an empty figure (Cairo does of one that is too large, and gnuplot is content), what it left of it is removed.
/// @param figure  the file that the script draws, in the same folder
/// @return nothing if it went well, otherwise one sentence that says why not
std::optional<std::string> gnuplot_complaint(std::filesystem::path const& folder, std::string const& script,
                                             std::string const& figure);

}  // namespace brouwer
