// The verdicts in words. Every sentence is built from the same few phrases, so that equal facts read equally.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/numbers.hpp"
#include "analysis/verdict/failures.hpp"
#include "analysis/verdict/phrases.hpp"
#include "analysis/verdict/verdict.hpp"

namespace brouwer {
namespace {

std::string exponent(Estimates const& e) {
  if (std::isnan(e.growth.exponent)) return "too few samples are not zero to fit a law of growth";
  return fmt::format("RMS ∝ t^{} ({} … {})", decimal(e.growth.exponent), decimal(e.growth.interval.low),
                     decimal(e.growth.interval.high));
}

std::string t_test(Estimates const& e) {
  std::string const adjusted = e.drift.p_alone ? ", adjusted " + probability(e.drift.p) : "";
  return fmt::format("t = {}, {}{}", number(e.drift.t, 3), probability(e.drift.own_p()), adjusted);
}

/// Where the full model has noise, the other numbers are its own.
std::string beside_noise(Estimates const& e) {
  if (!noise_in_force(e)) return "";
  return fmt::format(", told apart from bounded noise of {}) by restricted maximum likelihood",
                     with_interval(e.noise.size, e.noise.interval, "", e));
}

std::string diffusion(Estimates const& e) {
  if (e.diffusion.per_sqrt_step == 0 && noise_in_force(e)) return "no random walk" + beside_noise(e);
  return with_interval(e.diffusion.per_sqrt_step, e.diffusion.interval, per_root(e), e) + ")" + beside_noise(e);
}

std::string drift(Estimates const& e) {
  return fmt::format("{}; {}), which is {} of the final RMS {}", drift_interval(e.drift, e), t_test(e),
                     percent(e.drift.share), brief(e.rms_final));
}

std::string no_drift(Estimates const& e) {
  if (std::isnan(e.drift.t)) return "every error at the end is zero, so there is no drift";
  if (auto const& whole = e.slope_to_the_end(); whole.p < e.levels.test && e.transient)
    return fmt::format("the slope to the end (t = {}, {}) is no drift: it comes from the beginning", number(whole.t, 3),
                       probability(whole.own_p()));
  return fmt::format("no drift is seen ({}; its estimate explains {} of the final RMS)", t_test(e),
                     percent(e.drift.share));
}

std::string drift_seen_or_not(Estimates const& e) {
  return e.drift.p < e.levels.test ? "a drift is seen as well: " + drift(e) : no_drift(e);
}

std::string visible(Estimates const& e) {
  std::string const levels = fmt::format(" (level {:g}, chance {:g})", e.levels.test, e.levels.power);
  if (std::isnan(e.smallest_visible_drift)) return "the smallest drift it could have seen is not defined" + levels;
  if (e.smallest_visible_drift == 0)
    return "the smallest drift this ensemble could have seen is 0: its members do not differ" + levels;
  return fmt::format("the smallest drift this ensemble could have seen is {}{}{}", brief(e.smallest_visible_drift),
                     per(e), levels);
}

/// What the mean does beside a drift.
std::string course_of(Estimates const& e) {
  return fmt::format("the mean of all members is no straight line ({}): it keeps within ±{} of one",
                     probability(e.model->p_course), brief(e.course->reach));
}

/// And what that may be, where nothing else is seen.
std::string as_an_oscillation(Estimates const& e) {
  return course_of(e) + ", as an oscillation does that the step does not resolve (a truncation error)";
}

/// Beside a law that is seen all the same.
std::string small_course(Estimates const& e) {
  return shares_a_course(e) ? "; " + course_of(e) + ", for which the interval of β allows" : "";
}

std::string drift_sentence(Estimates const& e) {
  if (std::isinf(e.drift.t))
    return fmt::format(
        "all {} members end with the same error, {}{}, so t is infinite and nothing was averaged; if the "
        "members should differ, check what perturbs them",
        e.members, brief(e.drift.per_step), per(e));
  std::string const beside = e.samples > 1 ? "; beside it the error spreads by " + diffusion(e) : "";
  return "the error grows on average by " + drift(e) + beside + small_course(e);
}

std::string slopes_test(Estimates const& e) {
  if (noise_in_force(e)) return "likelihood ratio, " + probability(e.model->p_slopes);
  return fmt::format("F = {}, {}; 1 for a random walk", brief(e.persistence.F), probability(e.persistence.p));
}

std::string persistent_sentence(Estimates const& e) {
  return fmt::format(
      "each member keeps a drift of its own, of standard deviation {}{} ({}), beside a spread of {}; {}; {}{}",
      brief(e.persistence.per_step), per(e), slopes_test(e), diffusion(e), exponent(e), no_drift(e), small_course(e));
}

std::string bounded_sentence(Estimates const& e) {
  return fmt::format(
      "the error does not grow: {}, RMS {} at the end; it is spread less than a random walk of its "
      "increments would be (F = {}, {}){}",
      exponent(e), brief(e.rms_final), brief(e.persistence.F), probability(e.persistence.p_low),
      shares_a_course(e) ? "; " + as_an_oscillation(e)
      : e.transient      ? ""
                         : "; its mean stays");
}

std::string superlinear_sentence(Estimates const& e) {
  return fmt::format(
      "the error grows faster than a drift, {} (3/2: a phase driven by a random walk; 2: by a drift); {}{}",
      exponent(e), drift_seen_or_not(e), small_course(e));
}

std::string walk_sentence(Estimates const& e) {
  std::string const caveat = e.persistence.p_low < e.levels.test && !noise_in_force(e) && !shares_a_course(e)
                                 ? fmt::format(
                                       "; F = {} is below 1: a part of the error is bounded, and the spread per "
                                       "step is smaller than said",
                                       brief(e.persistence.F))
                                 : "";
  return fmt::format("the error spreads by {}, {}; {}{}{}", diffusion(e), exponent(e), no_drift(e), caveat,
                     small_course(e));
}

/// How many members would bring the interval of the exponent to ±0.1: its width goes with 1/√M. Of a handful of members
/// the width itself says little, and nothing is promised.
std::string members_needed(Estimates const& e) {
  if (e.members < fewest_members) return "";
  double const half = (e.growth.interval.high - e.growth.interval.low) / 2;
  double const needed = static_cast<double>(e.members) * std::pow(half / walk_tolerance, 2);
  return fmt::format("; about {} members would give ±{:g}", brief(std::max(needed, 1.0 * fewest_members)),
                     walk_tolerance);
}

/// What F far below 1 is due to, where the mean is a straight line.
std::string bounded_part(Estimates const& e) {
  if (!e.model) return "noise, an oscillation";
  return e.model->law().terms.noise ? "noise, or an oscillation that each member has for itself"
                                    : "noise, an oscillation";
}

std::string obstacle(Estimates const& e) {
  double const half = (e.growth.interval.high - e.growth.interval.low) / 2;
  if (shares_a_course(e))
    return as_an_oscillation(e) + "; compare with the same method in higher precision, or take a smaller step";
  if (e.members < 2) return "there is one member only, and drift and persistence show in how members differ; run more";
  if (e.samples < 2) return "there is one sample time only, so growth cannot be seen; observe at more times";
  if (std::isnan(half)) return "too few sample times have a non-zero error to fit a law of growth; run longer";
  if (half > widest_exponent_half) return "the exponent is too uncertain, " + exponent(e) + members_needed(e);
  if (e.members < fewest_members)
    return fmt::format("{} members are too few to tell a law of growth ({}); at least {} are needed", e.members,
                       exponent(e), fewest_members);
  if (e.persistence.F < bounded_F && e.persistence.p_low < e.levels.test)
    return fmt::format(
        "a bounded part ({}) hides the law: {}, F = {} instead of 1; run longer, or "
        "compare with the same method in higher precision",
        bounded_part(e), exponent(e), brief(e.persistence.F));
  return fmt::format(
      "{} is neither a random walk's 1/2 nor bounded, and no test of slopes is significant; run longer, "
      "or with more members",
      exponent(e));
}

std::string unresolved_sentence(Estimates const& e) {
  if (e.members < 2) return obstacle(e);
  bool const sloping = e.drift.p < e.levels.test && !e.transient;
  return obstacle(e) + "; " +
         (sloping ? fmt::format("its mean has a slope ({}), as an oscillation has between any two samples", t_test(e))
                  : no_drift(e));
}

/// "14.2 iterations per step in the mean (13.9 … 14.6 over members and samples)".
std::string count_sentence(Estimates const& e) {
  return fmt::format("{} {} in the mean ({} … {} over members and samples)", number(e.count->mean, 3),
                     counted_things(e), number(e.count->range.low, 3), number(e.count->range.high, 3));
}

/// A verdict speaks of those that came through; that there were others must be said.
std::string failures(Estimates const& e) { return e.failed > 0 ? "; " + left_out(e) : ""; }

std::string body(Estimates const& e, Verdict verdict) {
  switch (verdict) {
    case Verdict::exact:
      return fmt::format("all errors of {} members at {} samples are zero", e.members, e.samples);
    case Verdict::random_walk:
      return walk_sentence(e);
    case Verdict::persistent_slopes:
      return persistent_sentence(e);
    case Verdict::drift:
      return drift_sentence(e);
    case Verdict::bounded:
      return bounded_sentence(e);
    case Verdict::faster_than_drift:
      return superlinear_sentence(e);
    case Verdict::count:
      return count_sentence(e);
    case Verdict::not_resolved:
      break;
  }
  return unresolved_sentence(e);
}

std::string capitalised(std::string text) {
  text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace

std::string counted_things(Estimates const& e) {
  if (e.unit.empty()) return e.quantity;
  return e.unit.starts_with("per ") ? e.quantity + " " + e.unit : e.unit;
}

std::string sentence_of(Estimates const& e, Verdict verdict) {
  std::string const course = verdict == Verdict::count ? "" : transient_in_words(e);
  std::string const sight = verdict == Verdict::count ? "" : "; " + visible(e);
  return capitalised(to_string(verdict)) + ": " + body(e, verdict) + course + sight + far_off_in_words(e) +
         failures(e) + ".";
}

}  // namespace brouwer
