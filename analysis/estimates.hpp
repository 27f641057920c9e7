#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <brouwer/store/record.hpp>

#include "analysis/increment_tests.hpp"
#include "analysis/interval.hpp"
#include "analysis/multiplicity.hpp"

namespace brouwer {

/// How sure: levels of the tests and of the intervals, stated beside every result.
struct Levels {
  double confidence = 0.95;                   ///< of intervals
  double test = 0.001;                        ///< two-sided level at which a drift, or persistence, is called seen
  double power = 0.9;                         ///< chance with which the "smallest visible drift" is seen at that level
  std::optional<Correction> correction = {};  ///< of drifts tested at once; unset: what the study says, or none
};

/// β, the drift shared by the ensemble, per unit of time (per step for our own runs).
struct Drift {
  double per_step = 0;
  Interval interval;
  double t = 0, p = 1;
  double share = 0;  ///< effect size: |β| t_J / RMS at the end, 0 … 1: how much of the final error it explains
  std::optional<double> p_alone = {};  ///< p before it was corrected for the drifts tested beside it, where it was
  double own_p() const { return p_alone.value_or(p); }
};

/// τ, the standard deviation of the members' own persistent drifts; F(M−1, M(J−1)).
struct Persistence {
  double per_step = 0;  ///< √max(0, var(sᵢ) − σ̂²/t_J)
  double F = 1;
  double p = 1;            ///< P(F' ≥ F): small when slopes persist
  double p_low = 1;        ///< P(F' ≤ F): small when the error is bounded rather than diffusing
  Interval interval = {};  ///< of τ
};

/// σ, the standard deviation of the random walk, per √(unit of time).
struct Diffusion {
  double per_sqrt_step = 0;
  Interval interval;
};

/// ν, the standard deviation of noise that does not grow; 0 where the data do not ask for any.
struct BoundedNoise {
  double size = 0;
  Interval interval;
};

/// q in RMS ∝ t^q: least-squares slope of log RMS against log t; interval by bootstrap over members.
struct Growth {
  double exponent = 0;
  Interval interval;
};

/// Which parts a law of growth has beside the drift, which it always has.
struct LawTerms {
  bool walk = false, slopes = false, noise = false;
  bool operator==(LawTerms const&) const = default;
};

/// One law of growth at its restricted maximum likelihood.
struct Candidate {
  LawTerms terms;
  double log_likelihood = 0;  ///< restricted, less that of the richest law: 0 for the best of all, negative below
  double drift = 0, slopes = 0, diffusion = 0, noise = 0;  ///< β, τ, σ, ν
};

/// What the data support of e(t) = (β + b)t + σW(t) + νε(t): see growth_model.hpp.
struct FullModel {
  std::vector<Candidate> candidates = {};  ///< walk, walk + slopes, walk + noise, all three, noise, noise + slopes
  std::size_t chosen = 0;
  double p_noise = 1, p_walk = 1, p_slopes = 1;  ///< of the tests by which it was chosen
  double p_course = 1;  ///< small where the mean of the members moves more than independent members let it
  double p_end = 1;     ///< small where the spread at the end is not what the law says
  /// Profile likelihood, of β, τ, σ, ν; of σ and ν [0, 0] where they were not chosen.
  Interval drift = {}, slopes = {}, diffusion = {}, noise = {};
  double t = 0, p = 1;        ///< of β = 0
  double standard_error = 0;  ///< of β

  Candidate const& law() const { return candidates[chosen]; }
};

/// The mean does not begin as it goes on: another slope until some time, a jump in the first step say.
struct Transient {
  double until = 0;  ///< the sample time after which the mean follows one straight line
  double p = 1;      ///< that it is none at all, for all places together
  Drift after;       ///< β from there on
};

/// The mean of all members is no straight line, whatever its drift: see shared_course.hpp.
struct SharedCourse {
  double size = 0;     ///< ν_s, the standard deviation at a sample of what all members share and does not grow
  double reach = 0;    ///< the largest distance of their mean from its line
  double degrees = 0;  ///< of freedom of the drift's t, whose error allows for it
  Drift whole;         ///< of the slope to the end, as if the mean were straight
};

/// Members far from all others. Set aside where they are few, in which case `drift` and `diffusion` are with them.
struct FarOff {
  std::vector<std::string> members;  ///< their names; of a study, their numbers from 0
  bool set_aside = false;
  Drift drift;
  Diffusion diffusion;
};

/// How the increments are distributed, beside the normal law.
struct Tails {
  double kurtosis = 0;    ///< excess, of the increments over √δ: 0 for normal ones
  double dispersion = 1;  ///< variance of the members' own σ² over that of normal increments
  bool normal = true;     ///< neither is larger than normal increments explain: χ² and F hold as they are
};

/// Numbers of something, iterations per step say, over members and samples.
struct Counted {
  double mean = 0;
  Interval range;  ///< smallest and largest
};

enum class Verdict { exact, random_walk, persistent_slopes, drift, bounded, faster_than_drift, not_resolved, count };

/// "random walk", "persistent slopes", "drift", "bounded", "superlinear", "exact", "not resolved", "count"
std::string to_string(Verdict verdict);

/// Everything that the inference says of one quantity of one cell.
struct Estimates {
  CellLabels cell;
  std::string quantity, family, unit;
  std::int64_t members = 0, failed = 0, samples = 0;
  std::vector<double> times, rms;        ///< RMS over members at the sample times
  std::vector<double> mean, mean_error;  ///< mean over members, and its standard error
  double rms_final = 0;
  Drift drift;
  Persistence persistence;
  Diffusion diffusion;
  BoundedNoise noise;
  Tails tails;
  std::optional<FullModel> model = {};  ///< none where there is too little to choose from
  std::optional<Transient> transient = {};
  std::optional<SharedCourse> course = {};  ///< where the mean of the members is no straight line
  FarOff far_off = {};
  Growth growth;
  double smallest_visible_drift = 0;  ///< per step, at levels.test with chance levels.power
  Levels levels;
  Verdict verdict = Verdict::not_resolved;
  std::string sentence;                      ///< the verdict in words, with the numbers that carry it
  std::string time_unit = "step";            ///< what drift is per, for people: "step", "time unit"
  std::vector<Failures> failures = {};       ///< of the members left out, by reason, those of most members first
  std::optional<IncrementTests> increments;  ///< none where there are no increments, or all are 0
  std::optional<Counted> count;  ///< where it is no error but a number of something: no law of growth is estimated

  double drift_degrees() const { return course ? course->degrees : static_cast<double>(members - 1); }
  /// Of the whole run, its beginning and what members share included.
  Drift const& slope_to_the_end() const { return course ? course->whole : drift; }
};

}  // namespace brouwer
