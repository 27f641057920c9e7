#include "analysis/probe/probe_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/distributions.hpp"
#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

double standard_error(Interval const& interval, Levels const& levels) {
  return (interval.high - interval.low) / 2 / normal_upper_quantile((1 - levels.confidence) / 2);
}

Agreement agreement(double predicted, Interval const& its, double observed, Interval const& seen,
                    Levels const& levels) {
  double const error = std::hypot(standard_error(its, levels), standard_error(seen, levels));
  double const z = (predicted - observed) / error;
  return {z, predicted / observed, !(std::abs(z) > normal_upper_quantile(levels.test / 2))};
}

bool is_biased(LocalLaw const& law, Levels const& levels) { return law.bias.p < levels.test; }

/// Why σ may differ, as far as the probe itself or the run shows it.
std::string reason_of_diffusion(ProbedRow const& row) {
  auto const& local = row.local;
  if (row.observed->verdict == Verdict::bounded) return "the observed error is bounded and does not walk";
  LocalLaw const& law = local.both ? *local.both : local.rounding;
  auto const [least, most] = std::minmax_element(law.scales.begin(), law.scales.end());
  double const seen = row.observed->diffusion.per_sqrt_step;
  if (law.still_changing || (*least < seen && seen < *most))
    return fmt::format(
        "local errors are correlated, so that σ depends on the time over which it is taken, {} to {} for "
        "1 to {} steps, and a run's samples mix such times",
        number(law.scales.front(), 2), number(law.scales.back(), 2), local.length);
  if (law.persistence.p < row.local.levels.test && seen > *most)
    return fmt::format(
        "members keep slopes of their own over the {} steps that the windows lie in (τ {}), which count as "
        "diffusion where they change later in the run",
        row.local.covered, number(law.persistence.per_step, 2));
  return "";
}

std::string reason_of_cover(ProbedRow const& row) {
  double const share = static_cast<double>(row.local.covered) / static_cast<double>(row.observed->cell.steps);
  return share < 1 ? fmt::format("the windows lie in the first {:.2g} % of the run only", 100 * share)
                   : "the cause is not among what a probe sees";
}

std::string difference_in_words(char const* what, Agreement const& a, std::string const& reason) {
  return fmt::format("{} differs by {} standard errors (predicted/observed {}): {}", what, number(std::abs(a.z), 2),
                     number(a.ratio, 3), reason);
}

}  // namespace

std::string bias_in_words(LocalLaw const& law) { return measured(law.bias.per_step, law.bias.interval); }

Agreement drift_agreement(ProbedRow const& row) {
  if (!row.prediction || !row.observed) return {};
  return agreement(row.prediction->drift.per_step, row.prediction->drift.interval, row.observed->drift.per_step,
                   row.observed->drift.interval, row.local.levels);
}

Agreement diffusion_agreement(ProbedRow const& row) {
  if (!row.prediction || !row.observed) return {};
  return agreement(row.prediction->diffusion.per_sqrt_step, row.prediction->diffusion.interval,
                   row.observed->diffusion.per_sqrt_step, row.observed->diffusion.interval, row.local.levels);
}

std::string cause_in_words(LocalEstimates const& local) {
  if (local.of_state) return "Errors of a state are changed by the steps that follow: nothing is predicted.";
  bool const rounds = is_biased(local.rounding, local.levels);
  bool const errs = local.both && is_biased(*local.truncation, local.levels);
  std::string const of_method = !local.both
                                    ? "the method conserves it"
                                    : (errs ? fmt::format("the method itself changes it by {} per step in the mean",
                                                          bias_in_words(*local.truncation))
                                            : "the method's own errors oscillate, no drift of them is seen");
  std::string const of_rounding =
      rounds ? fmt::format("Rounding is biased by {} per step", bias_in_words(local.rounding))
             : fmt::format("No bias of rounding is seen ({} per step)", bias_in_words(local.rounding));
  return local.truncation ? fmt::format("{}; {}.", of_rounding, of_method) : of_rounding + ".";
}

std::string comparison_in_words(ProbedRow const& row) {
  if (!row.prediction || !row.observed) return "";
  std::vector<std::string> parts;
  auto const drift = drift_agreement(row), diffusion = diffusion_agreement(row);
  auto const reason = reason_of_diffusion(row);
  if (!drift.agrees) parts.push_back(difference_in_words("β", drift, reason_of_cover(row)));
  if (!diffusion.agrees)
    parts.push_back(difference_in_words("σ", diffusion, reason.empty() ? reason_of_cover(row) : reason));
  if (!parts.empty()) return fmt::format("The run: {}.", fmt::join(parts, "; "));
  if (std::isnan(diffusion.z)) return "The run agrees within sampling error in β.";
  return "The run agrees within sampling error.";
}

}  // namespace brouwer
