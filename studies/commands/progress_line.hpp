#pragma once
#include <brouwer/ensemble/run.hpp>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace brouwer {

/// "12 of 32 units, 41 %, 3.1e+07 member-steps/s, 12 s left"
std::string progress_text(Progress const& progress, std::chrono::duration<double> elapsed);

/// "3 s", "2 min 05 s", "4 h 10 min", "3 d 4 h"
std::string duration_text(double seconds);

/// Shows progress on standard error while it lives: one line rewritten five times a second on a terminal, a plain
/// line every ten seconds elsewhere.
class ProgressLine {
 public:
  explicit ProgressLine(Progress const& progress);
  ~ProgressLine();
  ProgressLine(ProgressLine const&) = delete;
  ProgressLine& operator=(ProgressLine const&) = delete;

 private:
  void watch(std::stop_token const& finished);
  void show() const;

  Progress const& progress_;
  bool terminal_;
  std::chrono::steady_clock::time_point begin_;
  std::mutex mutex_;
  std::condition_variable_any woken_;
  std::jthread watcher_;  // last: it uses all of the above
};

}  // namespace brouwer
