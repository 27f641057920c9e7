#pragma once
#include <atomic>
#include <csignal>

namespace brouwer {

/// While it lives, Ctrl-C and SIGTERM only set a flag, so that finished work is kept; a second one ends the
/// program at once, as usual. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(InterruptGuard const&) = delete;
  InterruptGuard& operator=(InterruptGuard const&) = delete;

  static std::atomic<bool> const& flag();

 private:
  struct sigaction before_interrupt_, before_terminate_;
};

}  // namespace brouwer
