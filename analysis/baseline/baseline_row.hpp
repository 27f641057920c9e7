#pragma once
#include <brouwer/store/results.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "analysis/estimates.hpp"

namespace brouwer {

/// What is recorded of one quantity of one cell, and what it takes to compare it with another ensemble: estimates with
/// intervals, and standard errors that rest on nothing but the independence of members. Plain numbers, one a key of the
/// file; NaN where an estimate is not defined. Times are those of the ensemble, steps for our own runs.
struct BaselineRow {
  CellLabels cell;
  std::string quantity, unit, time_unit, verdict;
  std::string digest;  ///< of the members' errors: equal digests, equal bits
  std::int64_t members = 0, failed = 0, samples = 0;
  double duration = 0, rms_final = 0;

  double drift = 0, drift_low = 0, drift_high = 0;                    ///< β
  double diffusion = 0, diffusion_low = 0, diffusion_high = 0;        ///< σ
  double persistence = 0, persistence_low = 0, persistence_high = 0;  ///< τ
  double F = 0;
  double noise = 0, noise_low = 0, noise_high = 0;  ///< ν
  double exponent = 0, exponent_low = 0, exponent_high = 0;
  double count_mean = 0;  ///< of a number of something; NaN of errors

  // what is compared: of the closed form, whatever model the estimates above were fitted with
  double slope_mean = 0, slope_error = 0;           ///< mean of sᵢ, and its standard error
  double slope_variance = 0;                        ///< var(sᵢ)
  double slope_spread = 0, slope_spread_error = 0;  ///< mean of |sᵢ − median s|, and its standard error
  double increment_size = 0;                        ///< σ̂ of the increments about each member's slope
  double increment_log_error = 0;  ///< standard error of ln σ̂, from how the members' own σ̂ᵢ² differ
  double exponent_error = 0;       ///< standard error of q, from its interval

  std::vector<double> slopes;  ///< sᵢ of at most 4096 members in their order; empty in all but a file's last entry
};

/// Are they of the same quantity of the same cell?
bool same_place(BaselineRow const& a, BaselineRow const& b);

/// The standard errors of σ and of the slopes' spread are those of means over members: whatever the increments' law or
/// correlation, members are independent [M. B. Brown & A. B. Forsythe, J. Am. Stat. Assoc. 69 (1974) 364, for the
/// spread]. Those of the closed form would be too small where increments are not normal.
BaselineRow baseline_row(Ensemble const& ensemble, Estimates const& estimates);

/// Name-based UUID (RFC 4122, SHA-1) of the bits of times and errors.
std::string digest_of(Ensemble const& ensemble);

}  // namespace brouwer
