#pragma once
#include <string>
#include <vector>

#include "analysis/baseline/baseline.hpp"
#include "analysis/expectations/expectation.hpp"

namespace brouwer {

/// How an estimate differs between a recorded ensemble and one of now, of which the bits differ.
struct Effect {
  enum class Of { drift, diffusion, slopes, exponent };
  Of of = Of::drift;
  double change = 0;       ///< now − recorded: of β, ln σ, ln spread, q
  double error = 0;        ///< its standard error
  double dof = 0;          ///< degrees of freedom
  bool is_larger = false;  ///< in size: |β|, σ, the spread of slopes, q
  double p = 1;            ///< two-sided, of no change; after Holm's correction where `compare` has made it
};

/// What can be asked of two rows; nothing that is undefined in one of them.
///
///     β           sᵢ paired where the members have the same starts [t(M−1) of their differences], else Welch's t
///     σ           Welch's t of ln σ, with standard errors from how the members' own σ̂ᵢ² differ: no normal increments
///                 are supposed, as the F test of the closed form would
///     slopes      Brown and Forsythe's test: Welch's t of |sᵢ − median|, on the logarithm; it stands for τ
///     exponent    t of the bootstrap's standard errors
///
/// False alarms at the level 0.05, of 1000 pairs a population (walks of 16 and 64 members, drifts, slopes, bounded noise;
/// increments of Student's law with 3 degrees of freedom): β 0.040 … 0.062, σ 0.048 … 0.055 (Student: 0.069), slopes
/// 0.034 … 0.055, exponent 0.046 … 0.072 (Student: 0.088); ±0.014 each.
/// @param paired  the members of both have the same starts, in the same order
std::vector<Effect> effects(BaselineRow const& recorded, BaselineRow const& now, bool paired);

/// One outcome for each row that was recorded, and for each that is new: the same bits, equal within sampling error, or
/// what has changed, by how much, and the smallest change that would have been seen. All questions of all rows are asked
/// at the level of `levels` together. A row fails where |β|, σ or the spread of the slopes has grown, where it is no
/// longer there, and where all its members failed; everything else that has changed is said.
/// @throws InputError where the studies differ in what they ask (study_change.hpp)
std::vector<Outcome> compare(BaselineEntry const& recorded, BaselineEntry const& now, Levels const& levels);

}  // namespace brouwer
