#pragma once
#include <string>
#include <vector>

namespace brouwer {

/// What is wrong with an input, one sentence each, in the order found: all of it in one pass, so that a file
/// is mended in one go.
class Complaints {
 public:
  void add(std::string sentence) { sentences_.push_back(std::move(sentence)); }
  bool empty() const { return sentences_.empty(); }
  std::size_t size() const { return sentences_.size(); }

  /// @throws InputError one sentence a line, at most ten, if there are any
  void raise() const;

 private:
  std::vector<std::string> sentences_;
};

}  // namespace brouwer
