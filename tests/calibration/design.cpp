#include "tests/calibration/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/analysis/simulated.hpp"
#include "tests/calibration/philox.hpp"

namespace brouwer::calibration {
namespace {

constexpr auto logarithmic = Spacing::logarithmic;

constexpr std::array<Design, 10> all = {{
    {2, 8, logarithmic, 2000},
    {4, 8, logarithmic, 2000},
    {8, 8, logarithmic, 2000, false, true},
    {8, 64, logarithmic, 600},
    {64, 2, logarithmic, 2000},
    {64, 8, Spacing::linear, 1000},
    {64, 64, logarithmic, 1000, false, true},
    {64, 64, Spacing::irregular, 400},
    {512, 64, logarithmic, 100, false, true},
    {8, 8, logarithmic, 20'000, true},
}};

std::vector<double> linear(int count) {
  std::vector<double> times;
  for (int j = 1; j <= count; ++j) times.push_back(std::round(duration * j / count));
  return times;
}

/// Gaps of exponential length, as of events that come at random; never two in one step.
std::vector<double> irregular(int count) {
  Normal random(static_cast<unsigned long>(count), philox());
  std::vector<double> times;
  double sum = 0;
  for (int j = 0; j < count; ++j)
    times.push_back(sum += random([](gsl_rng* rng) { return gsl_ran_exponential(rng, 1); }));
  double last = 0;
  for (double& time : times) last = time = std::max(std::round(time / sum * duration), last + 1);
  return times;
}

}  // namespace

std::string Design::name() const {
  constexpr std::array<char const*, 3> words = {"log", "lin", "irr"};
  return fmt::format("{} × {} {}", members, samples, words[static_cast<std::size_t>(spacing)]);
}

std::vector<double> Design::times() const {
  switch (spacing) {
    case Spacing::linear:
      return linear(samples);
    case Spacing::irregular:
      return irregular(samples);
    case Spacing::logarithmic:
      break;
  }
  return log_spaced(samples, duration);
}

std::span<Design const> designs() { return all; }

}  // namespace brouwer::calibration
