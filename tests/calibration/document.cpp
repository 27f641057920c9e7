#include "tests/calibration/document.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>
#include <brouwer/store/whole_file.hpp>

namespace brouwer::calibration {

void replace_part(std::filesystem::path const& file, std::string const& name, std::string const& part) {
  auto text = read_whole(file);
  auto const opening = text.find("<!-- " + name + ": ");
  auto const begin = opening == std::string::npos ? opening : text.find('\n', opening);
  auto const end = begin == std::string::npos ? begin : text.find("<!-- end of " + name + " -->", begin);
  if (end == std::string::npos)
    throw InputError(fmt::format("{} has no lines <!-- {}: … --> and <!-- end of {} -->, between which the tables go",
                                 file.string(), name, name));
  text.replace(begin, end - begin, "\n\n" + part + "\n");
  write_whole(file, text);
}

}  // namespace brouwer::calibration
