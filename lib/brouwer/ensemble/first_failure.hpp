#pragma once
#include <atomic>
#include <exception>
#include <mutex>

namespace brouwer {

/// The first failure of any thread, rethrown when all have left.
class FirstFailure {
 public:
  void keep_current() {
    std::lock_guard const lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    seen_ = true;
  }
  bool seen() const { return seen_; }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::atomic<bool> seen_ = false;
};

}  // namespace brouwer
