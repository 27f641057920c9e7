#include "studies/commands/text_file.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <brouwer/store/whole_file.hpp>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace brouwer {

std::string read_text(std::filesystem::path const& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream || !text) throw RunError(fmt::format("{}: cannot be read ({})", file.string(), std::strerror(errno)));
  return text.str();
}

void write_text(std::filesystem::path const& file, std::string const& text) { write_whole(file, text); }

}  // namespace brouwer
