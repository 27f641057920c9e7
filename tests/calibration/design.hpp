#pragma once
#include <span>
#include <string>
#include <vector>

namespace brouwer::calibration {

/// How sample times are chosen.
enum class Spacing { logarithmic, linear, irregular };

/// The size of an ensemble and how often it is made.
struct Design {
  int members = 0, samples = 0;
  Spacing spacing = Spacing::logarithmic;
  int trials = 0;
  bool strict = false;    ///< for rates at the level 0.001 alone: many trials of one model
  bool verdicts = false;  ///< has a table of verdicts

  bool operator==(Design const&) const = default;

  std::string name() const;
  /// Increasing, the last is `duration`.
  std::vector<double> times() const;
};

constexpr double duration = 10'000;  ///< steps of every run

/// Those of docs/statistics.md.
std::span<Design const> designs();

}  // namespace brouwer::calibration
