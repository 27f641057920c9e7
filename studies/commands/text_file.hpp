#pragma once
#include <filesystem>
#include <string>

namespace brouwer {

/// The whole file. @throws RunError naming it
std::string read_text(std::filesystem::path const& file);
void write_text(std::filesystem::path const& file, std::string const& text);

}  // namespace brouwer
