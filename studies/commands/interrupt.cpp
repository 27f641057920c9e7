#include "studies/commands/interrupt.hpp"

namespace brouwer {
namespace {

std::atomic<bool> asked_to_stop = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // what a signal handler may touch

void ask_to_stop(int) { asked_to_stop = true; }

}  // namespace

InterruptGuard::InterruptGuard() {
  asked_to_stop = false;
  struct sigaction action = {};
  action.sa_handler = ask_to_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, &before_interrupt_);
  sigaction(SIGTERM, &action, &before_terminate_);
}

InterruptGuard::~InterruptGuard() {
  sigaction(SIGINT, &before_interrupt_, nullptr);
  sigaction(SIGTERM, &before_terminate_, nullptr);
}

std::atomic<bool> const& InterruptGuard::flag() { return asked_to_stop; }

}  // namespace brouwer
