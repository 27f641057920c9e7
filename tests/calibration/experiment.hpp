#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "tests/calibration/claim.hpp"

namespace brouwer::calibration {

constexpr std::size_t verdict_count = static_cast<std::size_t>(Verdict::count) + 1;

/// What came of all trials of one model in one design.
struct Tally {
  Model const* model = nullptr;
  Design design;
  std::vector<Rate> rates;                             ///< one a claim; no trials where it was not asked
  std::array<std::int64_t, verdict_count> verdicts{};  ///< how often each was said

  void add(Trial const& trial);
  void add(Tally const& other);
};

/// All trials of the design, on all processors. Counts are whole numbers and a trial is a function of its number, so that
/// threads change nothing.
Tally tally(Model const& model, Design const& design);

}  // namespace brouwer::calibration
