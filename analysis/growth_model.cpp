#include "analysis/growth_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/distributions.hpp"
#include "analysis/growth_intervals.hpp"
#include "analysis/growth_likelihood.hpp"

namespace brouwer {
namespace {

constexpr double only_noise = std::numeric_limits<double>::infinity();  // ρ

constexpr std::array<LawTerms, 6> laws = {{{true, false, false},
                                           {true, true, false},
                                           {true, false, true},
                                           {true, true, true},
                                           {false, false, true},
                                           {false, true, true}}};

using Fits = std::array<GrowthFit, laws.size()>;

std::size_t place_of(LawTerms const& terms) {
  return static_cast<std::size_t>(std::find(laws.begin(), laws.end(), terms) - laws.begin());
}

GrowthFit fit(GrowthLikelihood const& likelihood, LawTerms const& law) {
  if (law.walk && law.noise) return likelihood.best(law.slopes);
  return likelihood.at(law.walk ? 0 : only_noise, law.slopes);
}

Fits fits_of(GrowthLikelihood const& likelihood) {
  Fits fits;
  for (std::size_t k = 0; k < laws.size(); ++k) fits[k] = fit(likelihood, laws[k]);
  return fits;
}

Candidate candidate(LawTerms const& terms, GrowthFit const& fit, double least_deviance, Units const& units) {
  return {terms,
          (least_deviance - fit.deviance) / 2,
          units.rate(fit.slope),
          units.rate(std::sqrt(fit.tau2)),
          units.sqrt_rate(std::sqrt(fit.sigma2())),
          units.size(std::sqrt(fit.nu2()))};
}

std::vector<Candidate> candidates_of(Fits const& fits, Units const& units) {
  auto const less = [](GrowthFit const& a, GrowthFit const& b) { return a.deviance < b.deviance; };
  double const least = std::min_element(fits.begin(), fits.end(), less)->deviance;
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < laws.size(); ++k) candidates.push_back(candidate(laws[k], fits[k], least, units));
  return candidates;
}

/// What twice a log-likelihood ratio is measured by.
struct Yardstick {
  double inflation = 1;  ///< how much more uncertain variances are than those of normal increments
  double dof = 0;        ///< of the inflation, where it is estimated; 0: normal increments

  double p(double twice_ratio) const {
    double const x = twice_ratio / inflation;
    if (dof == 0 || !(x > 0)) return boundary_p(x);
    return student_two_sided(std::sqrt(x), dof) / 2;
  }
};

Yardstick yardstick(Tails const& tails, double members) {
  if (tails.normal) return {};
  return {std::max({1.0, tails.dispersion, 1 + tails.kurtosis / 2}), members - 1};
}

/// The p of the smaller one of two laws.
double p_between(Fits const& fits, LawTerms const& smaller, LawTerms const& larger, Yardstick const& yardstick) {
  return yardstick.p(fits[place_of(smaller)].deviance - fits[place_of(larger)].deviance);
}

/// Of the variance of the errors at the end, T²Σ(sᵢ⁰ − s̄⁰)²/(M−1), against what the law says.
double end_p(GrowthStatistics const& statistics, GrowthFit const& fit, double inflation) {
  double const time = statistics.duration(), dof = (statistics.members() - 1) / inflation;
  double const expected = fit.tau2 + fit.sigma2() / time + fit.nu2() / (time * time);
  double const chi2 = statistics.slope_spread() / expected / inflation;
  return std::min(1.0, 2 * std::min(chi_squared_upper(chi2, dof), chi_squared_lower(chi2, dof)));
}

/// Do the members end further apart than walk and noise let them?
bool only_slopes_explain(Fits const& fits, GrowthStatistics const& statistics, double level,
                         Yardstick const& yardstick) {
  return end_p(statistics, fits[place_of({true, false, true})], yardstick.inflation) < level;
}

/// Beside noise a few late samples of a walk look like slopes, and either may do without the other: slopes are called
/// so where they are needed beside a walk; what grows otherwise is a walk. Needed they are where the signs agree, or,
/// as noise blurs these, where walk and noise alone do not reach the spread at the end.
/// @param p_signs  of slopes, where they and the walk are both needed
LawTerms choose_beside_noise(Fits const& fits, GrowthStatistics const& statistics, double level, double p_signs,
                             Yardstick const& yardstick, FullModel& model) {
  LawTerms terms{true, true, true};
  model.p_walk = p_between(fits, {false, true, true}, terms, yardstick);
  model.p_slopes = p_between(fits, {true, false, true}, terms, yardstick);
  if (model.p_walk < level && !only_slopes_explain(fits, statistics, level, yardstick))
    model.p_slopes = std::max(model.p_slopes, p_signs);
  terms.slopes = model.p_slopes < level;
  if (!terms.slopes) model.p_walk = p_between(fits, {false, false, true}, {true, false, true}, yardstick);
  terms.walk = model.p_walk < level;
  return terms;
}

/// model.p_slopes is that of F, which decides where there is no noise.
LawTerms choose(Fits const& fits, GrowthStatistics const& statistics, double level, double p_signs,
                Yardstick const& yardstick, FullModel& model) {
  model.p_noise = p_between(fits, {true, true, false}, {true, true, true}, yardstick);
  if (model.p_noise < level) return choose_beside_noise(fits, statistics, level, p_signs, yardstick, model);
  model.p_walk = 0;
  return {true, model.p_slopes < level, false};
}

/// Of the mean's course against the rest of the members.
double course_p(GrowthStatistics const& statistics, double rho) {
  auto const r = statistics.at(rho);
  double const m = statistics.times() - 1, n = m * (statistics.members() - 1);
  return fisher_upper(r.course / m / ((r.residual - r.course) / n), m, n);
}

void test_drift(FullModel& model, GrowthFit const& fit, GrowthStatistics const& statistics, Units const& units,
                double confidence) {
  double const spread = statistics.at(fit.rho).spread, dof = statistics.members() - 1;
  double const error = std::sqrt(spread / dof / statistics.members());
  double const half = error * student_upper_quantile((1 - confidence) / 2, dof);
  model.standard_error = units.rate(error);
  model.t = fit.slope / error;
  model.p = student_two_sided(model.t, dof);
  model.drift = units.rate(Interval{fit.slope - half, fit.slope + half});
}

/// Members that differ, in their ends and in their ways there.
bool leaves_a_choice(GrowthStatistics const& statistics) {
  auto const closed = statistics.at(0);
  return statistics.slope_spread() > 0 && closed.residual > closed.course && closed.course >= 0;
}

}  // namespace

double boundary_p(double twice_ratio) {
  if (!(twice_ratio > 0)) return 1;
  return std::erfc(std::sqrt(twice_ratio / 2)) / 2;  // half of P(χ²(1) ≥ x)
}

std::optional<FullModel> growth_model(Ensemble const& ensemble, Units const& units, Levels const& levels,
                                      Tails const& tails, double slopes_p, MeanCourse course) {
  if (ensemble.errors.rows() < 2 || ensemble.errors.cols() < 3) return std::nullopt;
  GrowthStatistics const statistics(ensemble, units, course);
  if (!leaves_a_choice(statistics)) return std::nullopt;
  GrowthLikelihood const likelihood(statistics);
  auto const fits = fits_of(likelihood);
  FullModel model;
  model.candidates = candidates_of(fits, units);
  model.p_slopes = slopes_p;
  auto const measure = yardstick(tails, statistics.members());
  auto const terms = choose(fits, statistics, levels.test, doubling_signs_p(ensemble, units), measure, model);
  model.chosen = place_of(terms);
  auto const& chosen = fits[model.chosen];
  model.p_course = course_p(statistics, chosen.rho);
  model.p_end = end_p(statistics, chosen, 1);
  test_drift(model, chosen, statistics, units, levels.confidence);
  auto const intervals = profile_intervals(likelihood, chosen, terms, levels.confidence, measure.inflation);
  model.diffusion = units.sqrt_rate(intervals.sigma);
  model.slopes = units.rate(intervals.tau);
  model.noise = units.size(intervals.nu);
  return model;
}

}  // namespace brouwer
