#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace brouwer {

/// A script that teaches bash or zsh this command line, made from its own description.
/// @throws InputError for another shell
std::string completion_script(std::string const& shell, CLI::App const& app);

}  // namespace brouwer
