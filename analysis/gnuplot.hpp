#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace brouwer {

/// Runs `gnuplot SCRIPT` in a folder, without a shell and without the user's own gnuplot settings.
/// @return nothing if it went well, otherwise one sentence that says why not
std::optional<std::string> gnuplot_complaint(std::filesystem::path const& folder, std::string const& script);

}  // namespace brouwer
