#include "studies/reading/complaints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>

namespace brouwer {

void Complaints::raise() const {
  if (empty()) return;
  std::size_t const shown = std::min<std::size_t>(size(), 10);
  std::string text = fmt::format("{}", fmt::join(sentences_.begin(), sentences_.begin() + std::ptrdiff_t(shown), "\n"));
  if (shown < size()) text += fmt::format("\n… and {} more", size() - shown);
  throw InputError(text);
}

}  // namespace brouwer
