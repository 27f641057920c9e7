#pragma once
#include <string>

#include "analysis/estimates.hpp"

namespace brouwer {

struct Judgement {
  Verdict verdict = Verdict::not_resolved;
  std::string sentence;
};

/// Thresholds of the verdict that are not levels of tests; they are conventions, stated here once.
constexpr std::int64_t fewest_members = 8;     ///< below, no verdict rests on the growth exponent
constexpr std::int64_t fewest_times = 8;       ///< below, none rests on telling noise from a walk
constexpr double superlinear_exponent = 1.2;   ///< between a drift's 1 and the 3/2 of a phase driven by a walk
constexpr double bounded_exponent = 0.25;      ///< between bounded noise's 0 and a walk's 1/2
constexpr double bounded_F = 0.5;              ///< F below it, significantly: more than a walk's bridges explain
constexpr double walk_exponent = 0.5;          ///< Brouwer's law
constexpr double walk_tolerance = 0.1;         ///< an interval inside 0.5 ± 0.1 is called a walk even beside 0.5
constexpr double widest_exponent_half = 0.25;  ///< a wider interval says nothing about the exponent
constexpr double considerable = 0.25;  ///< of the final RMS: a part that is smaller, 1/16 of the square, decides
                                       ///< nothing

/// The verdict on the law of growth: the first line of this table that applies. a = levels.test, q = growth exponent.
///
///     count               it is no error but a number of something
///     exact               every error is zero
///     not resolved        one member, or one sample time without a significant drift
///     superlinear         M ≥ 8 and q's interval lies above 1.2 (also when the drift is significant: both are said)
///     bounded             M ≥ 8, F < 0.5 with P(F' ≤ F) < a, q's interval lies below 0.25, and neither the mean
///                         nor the RMS has changed at the level a since the middle of the run in log t (so an offset
///                         is no drift, and a walk that just emerges from bounded noise is not called bounded); and not
///                         where a law beside noise, or of members about a mean that is bent, has a walk that
///                         surely makes a quarter of the final RMS
///     drift               the mean is no straight line (Estimates::course, without a transient) but leaves it by a
///                         quarter of the final RMS or more, and the t test that allows for that sees one
///     not resolved        it does, and the t test sees no drift: an oscillation that all members share, say
///     drift, persistent   M ≥ 8, J ≥ 8, the full model has noise, and neither its p_end nor, where the mean is
///                         to be a straight line, its p_course is below a: the law
///       slopes, or        beside bounded noise, whatever F and q are. A drift if its p is below a, else what the
///       random walk       model has of slopes and walk
///     not resolved        as bounded, but the mean or the RMS has changed: an oscillation that all members share (a
///                         truncation error, say) has a significant slope between any two samples, and is no drift
///     drift               p of t is below a, after the transient as well if there is one
///     persistent slopes   p of F is below a, and there are two samples whose errors are not all 0
///     random walk         M ≥ 8, q's interval is at most ±0.25 wide and holds 0.5 or lies inside 0.5 ± 0.1, and F is
///                         not far below 1 (as for bounded) but for what all members share
///     not resolved        otherwise
///
/// A pure function of the estimates. The sentence names the verdict, the numbers that carry it with their intervals,
/// the drift's share of the final RMS, and the smallest drift that this ensemble could have seen.
Judgement judge(Estimates const& e);

/// The mean of the members has a course of its own that is no beginning.
bool shares_a_course(Estimates const& e);

/// β, τ, σ are of the full model with noise: of M ≥ 8 members at J ≥ 8 times it was chosen, and neither the course of the
/// mean (unless that was taken away first) nor the spread at the end contradicts it.
bool noise_in_force(Estimates const& e);

/// The verdict alone, and its words.
Verdict verdict_of(Estimates const& e);
std::string sentence_of(Estimates const& e, Verdict verdict);

/// "; 2 members lie far outside the others (17, 203) and are set aside; with them: drift …"; "" where there are none.
std::string far_off_in_words(Estimates const& e);

/// "; until 10 steps the mean moves otherwise than later …"; "" where there is no transient, or no test of the drift
/// depends on it.
std::string transient_in_words(Estimates const& e);

/// What a count is of: "iterations per step", whether its unit says so or only "per step".
std::string counted_things(Estimates const& e);

}  // namespace brouwer
