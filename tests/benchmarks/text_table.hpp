#pragma once
#include <string>
#include <vector>

namespace brouwer::benchmarks {

/// Lines of cells as Markdown that can be read as it stands: padded, the first column to the left, numbers to the right.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> const& header) : lines_{header} {}
  void add(std::vector<std::string> const& line) { lines_.push_back(line); }
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> lines_;
};

}  // namespace brouwer::benchmarks
