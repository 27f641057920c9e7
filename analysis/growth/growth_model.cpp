#include "analysis/growth/growth_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/distributions.hpp"
#include "analysis/growth/growth_choice.hpp"
#include "analysis/growth/growth_intervals.hpp"

namespace brouwer {
namespace {

constexpr double only_noise = std::numeric_limits<double>::infinity();  // ρ

GrowthFit fit(GrowthLikelihood const& likelihood, LawTerms const& law) {
  if (law.walk && law.noise) return likelihood.best(law.slopes);
  return likelihood.at(law.walk ? 0 : only_noise, law.slopes);
}

GrowthFits fits_of(GrowthLikelihood const& likelihood) {
  GrowthFits fits;
  for (std::size_t k = 0; k < growth_laws.size(); ++k) fits[k] = fit(likelihood, growth_laws[k]);
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

std::vector<Candidate> candidates_of(GrowthFits const& fits, Units const& units) {
  auto const less = [](GrowthFit const& a, GrowthFit const& b) { return a.deviance < b.deviance; };
  double const least = std::min_element(fits.begin(), fits.end(), less)->deviance;
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < growth_laws.size(); ++k)
    candidates.push_back(candidate(growth_laws[k], fits[k], least, units));
  return candidates;
}

/// Of the mean's course against the rest of the members.
double course_p(GrowthStatistics const& statistics, double rho) {
  auto const r = statistics.at(rho);
  double const m = statistics.times() - 1, n = m * (statistics.members() - 1), epsilon = statistics.sphericity(rho);
  return fisher_upper(r.course / m / ((r.residual - r.course) / n), epsilon * m, epsilon * n);
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

Interval hull(Interval a, Interval b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

/// Slopes that are not excluded leave σ what it is with them, too.
ProfileIntervals intervals_of(GrowthLikelihood const& likelihood, GrowthFits const& fits, LawChoice const& choice,
                              double confidence, double inflation) {
  auto const of = [&](LawTerms const& terms) {
    return profile_intervals(likelihood, fits[place_of(terms)], terms, confidence, inflation);
  };
  auto intervals = of(choice.terms);
  if (choice.slopes_open) intervals.sigma = hull(intervals.sigma, of({true, true, true}).sigma);
  return intervals;
}

/// Members that differ, in their ends and in their ways there.
bool leaves_a_choice(GrowthStatistics const& statistics) {
  auto const closed = statistics.at(0);
  return statistics.slope_spread() > 0 && closed.residual > closed.course && closed.course >= 0;
}

}  // namespace

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
  auto const grounds = grounds_of(ensemble, units, levels, tails);
  auto const choice = choose_law(fits, statistics, grounds, model);
  model.chosen = place_of(choice.terms);
  auto const& chosen = fits[model.chosen];
  model.p_course = course_p(statistics, chosen.rho);
  model.p_end = end_p(statistics, chosen);
  test_drift(model, chosen, statistics, units, levels.confidence);
  auto const intervals = intervals_of(likelihood, fits, choice, levels.confidence, grounds.yardstick.inflation);
  model.diffusion = units.sqrt_rate(intervals.sigma);
  model.slopes = units.rate(intervals.tau);
  model.noise = units.size(intervals.nu);
  return model;
}

}  // namespace brouwer
