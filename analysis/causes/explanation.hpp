#pragma once
#include <limits>
#include <string>
#include <vector>

#include "analysis/estimates.hpp"

namespace brouwer {

/// How much of a property of the nominal cell there is in another cell: 1 is all of it, 0 nothing. NaN where the nominal
/// cell does not have it; an interval without ends where its own size is not known from zero.
struct Share {
  double value = std::numeric_limits<double>::quiet_NaN();
  Interval interval = {value, value};
};

/// A cell of the design beside the nominal one, over the members that both have.
struct ComparedCell {
  CellLabels cell;
  int bits = 0;                      ///< of its significands
  std::vector<std::string> changed;  ///< names of the factors (factors.hpp) in which it differs from the nominal cell
  std::int64_t lost = 0;             ///< members of the nominal cell that failed here
  Drift drift;                       ///< β there
  double p = 1;                      ///< of β there being the nominal β: paired t
  Share drift_left;                  ///< β/β₀
  Share slopes_left;                 ///< τ²/τ₀²
  Share diffusion_left;              ///< σ/σ₀, of the increments about each member's line
  Share size_left;                   ///< RMS at the end over the nominal one
};

/// A main effect or an interaction of a 2ᵏ factorial, 2/2ᵏ Σ ± over its cells: a main effect is the mean change when the
/// factor is changed.
struct FactorialEffect {
  std::vector<std::string> factors;  ///< in words, one for a main effect: "exact constants", "stochastic rounding"
  Drift drift;                       ///< on β; share: of |β₀|
  Share slopes;                      ///< on τ², as a share of τ₀²
  double p_slopes = 1;
  Share diffusion;  ///< factor on σ: 1 is none
  double p_diffusion = 1;
};

/// What of a nominal cell asks for an explanation.
enum class Subject { drift, slopes, size, nothing };

/// Where it comes from.
enum class Cause {
  none_seen,               ///< there is nothing to explain
  truncation,              ///< the method itself: most of it is there in higher precision
  rounding_mode,           ///< a directed rounding
  constants,               ///< rounded constants of the method, by themselves
  repeated_rounding,       ///< rounding to nearest makes errors that are alike in every step, by themselves
  constants_or_rounding,   ///< it takes both of these: either remedy suffices
  constants_and_rounding,  ///< each of these makes one of its own
  needs_constants,         ///< exact constants suffice; whether unbiased rounding would, too, is not known
  needs_rounding,          ///< the other way round
  coefficients,
  functions,
  summation,
  contraction,
  unnamed,    ///< round-off, and there in all of these
  round_off,  ///< gone in higher precision; more is not known
  not_resolved
};

/// "rounded constants"
std::string to_string(Cause cause);
std::string to_string(Subject subject);

/// One quantity of one nominal cell, and what becomes of it when the arithmetic is changed.
struct Explanation {
  Estimates nominal;
  int bits = 53;             ///< of the nominal cell's significands
  std::int64_t members = 0;  ///< compared: those that every cell has
  double confidence = 0.95;  ///< of all intervals of the compared cells together
  std::vector<ComparedCell> cells;
  std::vector<FactorialEffect> effects;  ///< none where the factorial is not complete
  std::vector<std::string> left_out;     ///< cells and members that are not compared, a sentence each
  std::vector<std::string> not_run;      ///< cells of the design that do not exist, a reason each
  Subject subject = Subject::nothing;
  Cause cause = Cause::none_seen;
  std::string sentence;  ///< the cause with the numbers that show it
};

}  // namespace brouwer
