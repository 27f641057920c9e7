#include "studies/commands/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

namespace brouwer {
namespace {

constexpr char const* erase_line = "\r\x1b[K";

std::string time_left(Progress const& progress, double rate) {
  auto const left = progress.steps_total - progress.steps_done.load();
  return rate > 0 ? duration_text(static_cast<double>(left) / rate) + " left" : "";
}

}  // namespace

std::string duration_text(double seconds) {
  if (!(seconds < 1e9)) return "more than 30 years";
  auto const s = static_cast<std::int64_t>(std::ceil(seconds));
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  if (s < 86400) return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
  return fmt::format("{} d {} h", s / 86400, s / 3600 % 24);
}

std::string progress_text(Progress const& progress, std::chrono::duration<double> elapsed) {
  auto const steps = static_cast<double>(progress.steps_done.load());
  double const share = progress.steps_total > 0 ? steps / static_cast<double>(progress.steps_total) : 1;
  double const rate = elapsed.count() > 0 ? steps / elapsed.count() : 0;
  std::string text = fmt::format("{} of {} units, {:.0f} %", progress.units_before + progress.units_done.load(),
                                 progress.units_total, 100 * share);
  if (rate > 0) text += fmt::format(", {:.1e} member-steps/s, {}", rate, time_left(progress, rate));
  return text;
}

ProgressLine::ProgressLine(Progress const& progress)
    : progress_(progress),
      terminal_(isatty(STDERR_FILENO) != 0),
      begin_(std::chrono::steady_clock::now()),
      watcher_([this](std::stop_token finished) { watch(finished); }) {}

ProgressLine::~ProgressLine() {
  watcher_.request_stop();
  watcher_.join();
  if (terminal_) fmt::print(stderr, "{}", erase_line);
}

void ProgressLine::watch(std::stop_token const& finished) {
  auto const pause = terminal_ ? std::chrono::milliseconds(200) : std::chrono::milliseconds(10'000);
  std::unique_lock lock(mutex_);
  while (!woken_.wait_for(lock, finished, pause, [&] { return finished.stop_requested(); })) show();
}

void ProgressLine::show() const {
  auto const text = progress_text(progress_, std::chrono::steady_clock::now() - begin_);
  std::fputs((terminal_ ? erase_line + text : text + "\n").c_str(),
             stderr);  // never throws: a closed stderr is no failure
  std::fflush(stderr);
}

}  // namespace brouwer
