#pragma once
#include <filesystem>
#include <string>

namespace brouwer::calibration {

/// Puts `part` between the two lines of the file that carry its name, `<!-- NAME: … -->` and `<!-- end of NAME -->`; the
/// rest of the file stays as people wrote it.
/// @throws InputError where the file has no such lines
void replace_part(std::filesystem::path const& file, std::string const& name, std::string const& part);

}  // namespace brouwer::calibration
