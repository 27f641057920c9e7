#include "analysis/verdict/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/distributions.hpp"

namespace brouwer {
namespace {

bool is_count(Estimates const& e) { return e.count.has_value(); }

bool every_error_is_zero(Estimates const& e) {
  return std::all_of(e.rms.begin(), e.rms.end(), [](double rms) { return rms == 0; });
}

/// A slope that the first samples alone make is none of the law.
bool drift_is_seen(Estimates const& e) {
  return e.drift.p < e.levels.test && (!e.transient || e.transient->after.p < e.levels.test);
}

bool too_little_to_tell(Estimates const& e) { return e.members < 2 || (e.samples < 2 && !drift_is_seen(e)); }

bool exponent_counts(Estimates const& e) { return e.members >= fewest_members; }

bool superlinear(Estimates const& e) { return exponent_counts(e) && e.growth.interval.low > superlinear_exponent; }

bool far_below_a_walk(Estimates const& e) { return e.persistence.F < bounded_F && e.persistence.p_low < e.levels.test; }

/// The first sample time past the middle of the run in log t, but not the last: growth since then is growth that goes
/// on. For at least two sample times.
std::size_t middle(Estimates const& e) {
  double const time = std::sqrt(e.times.front()) * std::sqrt(e.times.back());
  auto const found = std::lower_bound(e.times.begin(), e.times.end() - 2, time);
  return static_cast<std::size_t>(found - e.times.begin());
}

/// Bounded errors at two samples are independent or share an offset: this is the standard error of the difference of
/// their means, or more than it.
bool mean_has_moved(Estimates const& e, std::size_t since) {
  double const difference = std::abs(e.mean.back() - e.mean[since]);
  double const error = std::hypot(e.mean_error.back(), e.mean_error[since]);
  return difference > error * student_upper_quantile(e.levels.test / 2, static_cast<double>(e.members - 1));
}

/// The ratio of mean squares of M independent normal errors at two samples is F(M, M); nearer to 1 if they depend.
bool spread_has_grown(Estimates const& e, std::size_t since) {
  double const ratio = e.rms.back() / e.rms[since];
  auto const members = static_cast<double>(e.members);
  return fisher_upper(ratio * ratio, members, members) < e.levels.test;
}

bool has_settled(Estimates const& e) { return !mean_has_moved(e, middle(e)) && !spread_has_grown(e, middle(e)); }

/// F and the exponent both contradict growth of any kind: a slope of the mean is then the phase of an oscillation.
bool does_not_grow(Estimates const& e) {
  return exponent_counts(e) && far_below_a_walk(e) && e.growth.interval.high < bounded_exponent;
}

/// The law of the members' own, beside noise or what all share, has a walk that is a considerable part at the end.
bool walks_all_the_same(Estimates const& e) {
  double const walk = e.diffusion.interval.low * std::sqrt(e.times.back());
  return (noise_in_force(e) || shares_a_course(e)) && e.model->law().terms.walk && walk > considerable * e.rms_final;
}

bool bounded(Estimates const& e) { return does_not_grow(e) && has_settled(e) && !walks_all_the_same(e); }

/// Of errors that are not 0 at two samples at least.
bool slopes_persist(Estimates const& e) {
  return e.persistence.p < e.levels.test && (e.samples < 2 || !std::isnan(e.growth.exponent));
}

/// The members' differences tell of σ, τ and ν, but no law of growth can be read from errors of which what all share is a
/// large part. (A small part is a sixteenth of the mean square, and β's interval allows for it.)
bool course_prevails(Estimates const& e) {
  return shares_a_course(e) && !(e.course->reach < considerable * e.rms_final);
}

bool drifts_beside_a_course(Estimates const& e) { return course_prevails(e) && drift_is_seen(e); }

bool drifts_beside_noise(Estimates const& e) { return noise_in_force(e) && drift_is_seen(e); }

/// In the law, and seen.
bool slopes_beside_noise(Estimates const& e) {
  return noise_in_force(e) && e.model->law().terms.slopes && e.model->p_slopes < e.levels.test;
}

bool walks_beside_noise(Estimates const& e) {
  return noise_in_force(e) && e.model->law().terms.walk && !e.model->law().terms.slopes;
}

bool walks(Estimates const& e) {
  auto const [low, high] = e.growth.interval;
  bool const holds_half = low <= walk_exponent && walk_exponent <= high;
  bool const near_half = low >= walk_exponent - walk_tolerance && high <= walk_exponent + walk_tolerance;
  bool const tight = high - low <= 2 * widest_exponent_half;
  bool const spreads = !far_below_a_walk(e) || shares_a_course(e);  // F is of the errors with what all share
  return exponent_counts(e) && tight && (holds_half || near_half) && spreads;
}

struct Rule {
  Verdict verdict;
  bool (*applies)(Estimates const&);
};

constexpr std::array<Rule, 14> rules = {{
    {Verdict::count, is_count},
    {Verdict::exact, every_error_is_zero},
    {Verdict::not_resolved, too_little_to_tell},
    {Verdict::faster_than_drift, superlinear},
    {Verdict::bounded, bounded},
    {Verdict::drift, drifts_beside_a_course},
    {Verdict::not_resolved, course_prevails},
    {Verdict::drift, drifts_beside_noise},
    {Verdict::persistent_slopes, slopes_beside_noise},
    {Verdict::random_walk, walks_beside_noise},
    {Verdict::not_resolved, does_not_grow},
    {Verdict::drift, drift_is_seen},
    {Verdict::persistent_slopes, slopes_persist},
    {Verdict::random_walk, walks},
}};

}  // namespace

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::exact:
      return "exact";
    case Verdict::random_walk:
      return "random walk";
    case Verdict::persistent_slopes:
      return "persistent slopes";
    case Verdict::drift:
      return "drift";
    case Verdict::bounded:
      return "bounded";
    case Verdict::faster_than_drift:
      return "superlinear";
    case Verdict::count:
      return "count";
    case Verdict::not_resolved:
      break;
  }
  return "not resolved";
}

bool shares_a_course(Estimates const& e) { return e.course && !e.transient; }

bool noise_in_force(Estimates const& e) {
  if (!exponent_counts(e) || e.samples < fewest_times || !e.model || !e.model->law().terms.noise) return false;
  return (e.course || e.model->p_course >= e.levels.test) && e.model->p_end >= e.levels.test;
}

Verdict verdict_of(Estimates const& e) {
  auto const rule = std::find_if(rules.begin(), rules.end(), [&](Rule const& r) { return r.applies(e); });
  return rule == rules.end() ? Verdict::not_resolved : rule->verdict;
}

Judgement judge(Estimates const& e) {
  auto const verdict = verdict_of(e);
  return {verdict, sentence_of(e, verdict)};
}

}  // namespace brouwer
