#include "tests/calibration/claim.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/expectations/decision.hpp"

namespace brouwer::calibration {
namespace {

using Answer = std::optional<bool>;
using Names = std::vector<std::string>;
using Side = Nominal::Side;

// --- what is asked of a trial -----------------------------------------------------------------------------------------

Answer covers(Interval interval, std::optional<double> truth) {
  if (!truth || !(interval.low <= interval.high)) return {};
  return interval.low <= *truth && *truth <= interval.high;
}

/// Asked only where a law of growth was chosen.
template <class Question>
Answer of_model(Trial const& t, Question const& question) {
  return t.estimates.model ? Answer(question(*t.estimates.model)) : Answer();
}

Answer beta(Trial const& t) { return covers(t.estimates.drift.interval, t.truth.drift); }
Answer sigma(Trial const& t) { return covers(t.estimates.diffusion.interval, t.truth.diffusion); }
Answer tau(Trial const& t) { return covers(t.estimates.persistence.interval, t.truth.persistence); }
Answer q(Trial const& t) { return covers(t.estimates.growth.interval, t.truth.time_exponent); }
Answer q_of_sweep(Trial const& t) { return t.sweep ? covers(t.sweep->time_interval, t.truth.time_exponent) : Answer(); }
Answer p_of_sweep(Trial const& t) { return t.sweep ? covers(t.sweep->step_interval, t.truth.step_exponent) : Answer(); }
Answer nu(Trial const& t) {
  return t.estimates.noise.size > 0 ? covers(t.estimates.noise.interval, t.truth.noise) : Answer();
}

Answer drift_at_5(Trial const& t) { return t.estimates.drift.p < 0.05; }
Answer drift_at_01(Trial const& t) { return t.estimates.drift.p < 0.001; }
Answer slopes_at_5(Trial const& t) { return t.estimates.persistence.p < 0.05; }
Answer slopes_at_01(Trial const& t) { return t.estimates.persistence.p < 0.001; }
Answer low_F_at_5(Trial const& t) { return t.estimates.persistence.p_low < 0.05; }

Answer noise_chosen(Trial const& t) {
  return of_model(t, [](FullModel const& m) { return m.law().terms.noise; });
}
Answer slopes_chosen(Trial const& t) {
  return of_model(t, [](FullModel const& m) { return m.law().terms.slopes; });
}
/// Asked only where noise was found: without it there always is a walk.
Answer walk_beside_noise(Trial const& t) {
  if (!t.estimates.model || !t.estimates.model->law().terms.noise) return {};
  return t.estimates.model->law().terms.walk;
}
Answer slopes_beside_noise(Trial const& t) {
  if (!t.estimates.model || !t.estimates.model->law().terms.noise) return {};
  return t.estimates.model->law().terms.slopes && t.estimates.model->p_slopes < t.estimates.levels.test;
}
Answer course_at_5(Trial const& t) {
  return of_model(t, [](FullModel const& m) { return m.p_course < 0.05; });
}
Answer end_at_5(Trial const& t) {
  return of_model(t, [](FullModel const& m) { return m.p_end < 0.05; });
}
/// Asked only where there are increments, and the test is defined.
template <class PValue>
Answer of_increments(Trial const& t, PValue const& p_value) {
  if (!t.estimates.increments) return {};
  double const p = p_value(*t.estimates.increments);
  return std::isnan(p) ? Answer() : Answer(p < 0.05);
}
double first_p(IncrementTests const& i) { return i.autocorrelations.empty() ? std::nan("") : i.autocorrelations[0].p; }

Answer correlated_at_5(Trial const& t) { return of_increments(t, first_p); }
Answer ratio_at_5(Trial const& t) {
  return of_increments(t, [](IncrementTests const& i) { return i.variance_ratio_p; });
}
Answer not_normal_at_5(Trial const& t) {
  return of_increments(t, [](IncrementTests const& i) { return i.normality.p; });
}

Answer transient_found(Trial const& t) { return t.estimates.transient.has_value(); }
Answer members_far_off(Trial const& t) { return !t.estimates.far_off.members.empty(); }
/// Two one-sided tests at the drift that there is: |β| < δ is then wrong.
Answer proven_small(Trial const& t) { return equivalence(t.estimates, std::abs(t.truth.drift), 0.05).p < 0.05; }
Answer called_drift(Trial const& t) { return t.estimates.verdict == Verdict::drift; }
Answer called_walk(Trial const& t) { return t.estimates.verdict == Verdict::random_walk; }

// --- of which models --------------------------------------------------------------------------------------------------

Names operator+(Names some, Names const& others) {
  some.insert(some.end(), others.begin(), others.end());
  return some;
}

Names const brownian = {"walk", "drift", "visible drift", "strong drift"};
Names const brownian_or_slopes = brownian + Names{"slopes"};
Names const correlated = {"AR +0.3", "AR −0.3"};
Names const heavy = {"t(5)", "t(3)", "skewed", "unequal", "wild"};
Names const waves = {"oscillation", "slow wave", "fast wave", "drift + wave", "wave of all"};
Names const shared = waves + Names{"transient"};
Names const noisy_heavy = {"t(3) + noise", "unequal + noise"};
Names const noisy = {"noise", "all"};
/// Members are independent and their errors normal: the laws of β and t are exact whatever else grows or does not.
Names const normal = brownian + correlated + noisy + Names{"slopes", "bounded"};
Names const uncorrelated = brownian_or_slopes + heavy;
Names const gaussian = brownian_or_slopes + correlated;
Names const drifting = {"drift", "visible drift", "strong drift", "all"};
Names const still_waves = {"oscillation", "slow wave", "fast wave"};
Names const still = Names{"walk", "slopes", "noise", "bounded", "transient"} + correlated + heavy + noisy_heavy;
Names const no_drift = still + still_waves;
Names const no_slopes = brownian + Names{"noise"} + correlated + heavy + still_waves + Names{"transient"} + noisy_heavy;
Names const no_noise = brownian_or_slopes + correlated + heavy + still_waves + Names{"transient"};

/// Means of members are straight lines.
Names const straight = normal + heavy + noisy_heavy + Names{"phase", "sweep"};

// --- and how often it is to be so -------------------------------------------------------------------------------------

constexpr Nominal covered{0.95, 0, Side::coverage};
constexpr Nominal nearly_covered{0.95, 0.025, Side::coverage};  // approximations, as their docstrings say
constexpr Nominal at_5{0.05, 0, Side::false_alarm};
constexpr Nominal at_01{0.001, 0, Side::false_alarm};
constexpr Nominal at_1{0.01, 0.003, Side::false_alarm};  // two bounds, each of half of it
constexpr Nominal visible{0.9, 0.003, Side::power};
constexpr Nominal told{};

std::vector<Claim> const all = {
    {"95 % interval of β", covered, beta, straight, normal},
    {"95 % interval of σ", covered, sigma, brownian_or_slopes + correlated + heavy + Names{"bounded"} + noisy_heavy,
     brownian_or_slopes},
    {"95 % interval of β where all share a course", nearly_covered, beta, shared, shared, 8, 16},
    {"95 % interval of σ where all share a course", nearly_covered, sigma, shared, still_waves + Names{"transient"}, 8,
     8},
    {"95 % interval of σ beside noise", nearly_covered, sigma, noisy, noisy, 8, 32},
    {"95 % interval of τ", nearly_covered, tau, {}, brownian_or_slopes, 8},
    {"95 % interval of ν, where noise is found", nearly_covered, nu, noisy + Names{"bounded"}, noisy + Names{"bounded"},
     8, 16},
    {"95 % interval of q", nearly_covered, q, {}, {"walk", "bounded", "sweep"}, 4},
    {"95 % interval of p in a sweep", nearly_covered, p_of_sweep, {}, {"sweep"}, 4},
    {"95 % interval of q in a sweep", nearly_covered, q_of_sweep, {}, {"sweep"}, 4},
    {"drift where there is none, p < 0.05", at_5, drift_at_5, no_drift, normal},
    {"drift where there is none, p < 0.001", at_01, drift_at_01, no_drift, normal, 2, 2, true},
    {"slopes where there are none, p < 0.05", at_5, slopes_at_5, no_slopes, brownian},
    {"slopes where there are none, p < 0.001", at_01, slopes_at_01, no_slopes, brownian, 2, 2, true},
    {"F too small for a walk, p < 0.05", at_5, low_F_at_5, no_slopes, brownian},
    {"noise chosen where there is none", at_01, noise_chosen, no_noise, brownian_or_slopes, 2, 2, true},
    {"slopes found beside noise where there are none",
     at_01,
     slopes_beside_noise,
     Names{"noise", "bounded"} + noisy_heavy,
     {"noise"},
     8},
    {"a walk found beside noise where there is none", at_01, walk_beside_noise, {"bounded"}, {"bounded"}, 8},
    {"mean of the members not straight, p < 0.05", at_5, course_at_5, normal + heavy, brownian_or_slopes},
    {"spread at the end not the law's, p < 0.05", at_5, end_at_5, normal + heavy, {}},
    {"increments correlated where they are not, p < 0.05", at_5, correlated_at_5, uncorrelated, brownian_or_slopes},
    {"variance ratios not 1 where they are, p < 0.05", at_5, ratio_at_5, uncorrelated, brownian_or_slopes},
    {"increments not normal where they are, p < 0.05", at_5, not_normal_at_5, gaussian, brownian_or_slopes},
    {"members called far off, none is", at_1, members_far_off, normal + Names{"t(5)", "t(3)", "skewed", "unequal"},
     brownian + Names{"t(5)"}, 64},
    {"transient found where there is none", at_01, transient_found, normal + heavy, normal, 2, 2, true},
    {"|β| < δ proven where β = δ, p < 0.05", at_5, proven_small, drifting, drifting},
    {"verdict 'drift' where there is none", at_01, called_drift, still, {"walk", "slopes", "noise"}, 2, 2, true},
    {"the smallest visible drift is seen, p < 0.001", visible, drift_at_01, {"visible drift"}, {"visible drift"}},
    {"verdict 'drift' where all share a wave", at_01, called_drift, still_waves, still_waves, 8, 16},
    {"verdict 'random walk' where all share a wave", told, called_walk, waves, {}},
    {"power: a drift is seen beside a wave", told, called_drift, {"drift + wave"}, {}},
    {"power: noise is chosen", told, noise_chosen, noisy + Names{"bounded"} + noisy_heavy, {}},
    {"power: slopes are chosen", told, slopes_chosen, {"slopes", "all", "wave of all"}, {}},
    {"power: a transient is found", told, transient_found, shared, {}},
    {"power: increments are correlated, p < 0.05", told, correlated_at_5, correlated + noisy, {}},
    {"power: variance ratios are not 1, p < 0.05", told, ratio_at_5, correlated + noisy, {}},
    {"power: increments are not normal, p < 0.05", told, not_normal_at_5, heavy, {}},
    {"power: members are called far off", told, members_far_off, {"wild"}, {}},
    {"power: the verdict is 'random walk'", told, called_walk, {"walk", "noise", "t(5)", "wild"}, {}},
};

bool contains(Names const& names, Model const& model) {
  return std::find(names.begin(), names.end(), model.name) != names.end();
}

}  // namespace

std::span<Claim const> claims() { return all; }

bool is_asked(Claim const& claim, Model const& model) {
  return claim.asked_of.empty() || contains(claim.asked_of, model);
}

bool is_promised(Claim const& claim, Model const& model, Design const& design) {
  return contains(claim.promised_for, model) && design.members >= claim.fewest_members &&
         design.samples >= claim.fewest_samples;
}

}  // namespace brouwer::calibration
