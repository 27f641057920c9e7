#include "tests/benchmarks/text_table.hpp"

#include <algorithm>

namespace brouwer::benchmarks {
namespace {

/// Of UTF-8: bytes that do not continue a character.
std::size_t width(std::string const& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

std::string TextTable::text() const {
  std::vector<std::size_t> widths(lines_.front().size());
  for (auto const& line : lines_)
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], width(line[i]));

  std::string text;
  auto const append = [&](std::vector<std::string> const& line) {
    for (std::size_t i = 0; i < widths.size(); ++i) {
      std::string const padding(widths[i] - width(line[i]), ' ');
      text += "| " + (i == 0 ? line[i] + padding : padding + line[i]) + " ";
    }
    text += "|\n";
  };
  append(lines_.front());
  for (std::size_t i = 0; i < widths.size(); ++i)
    text += i == 0 ? "|:" + std::string(widths[i] + 1, '-') : "|" + std::string(widths[i] + 1, '-') + ":";
  text += "|\n";
  for (std::size_t n = 1; n < lines_.size(); ++n) append(lines_[n]);
  return text;
}

}  // namespace brouwer::benchmarks
