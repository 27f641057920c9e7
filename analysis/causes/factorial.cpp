#include "analysis/causes/factorial.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "analysis/causes/cell_shares.hpp"
#include "analysis/distributions.hpp"
#include "analysis/multiplicity.hpp"
#include "analysis/student_drift.hpp"

namespace brouwer {
namespace {

/// The product over the effect's factors of + where the cell has them changed, − where not.
double sign(std::size_t effect, std::size_t cell) { return std::popcount(effect & ~cell) % 2 == 0 ? 1 : -1; }

/// Of each member, 2/2ᵏ Σ ± of what `of` takes from a cell.
template <class Of>
Eigen::ArrayXd contrast(std::vector<MemberStatistics> const& cells, std::size_t effect, Of of) {
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(cells.front().members());
  for (std::size_t c = 0; c < cells.size(); ++c) sum += sign(effect, c) * of(cells[c]);
  return sum * 2 / static_cast<double>(cells.size());
}

/// Student's interval of the mean of independent numbers.
Drift mean_of(Eigen::ArrayXd const& x, double confidence) {
  auto const members = static_cast<double>(x.size());
  double const error = std::sqrt((x - x.mean()).square().sum() / (members * (members - 1)));
  return student_drift(x.mean(), error, members - 1, confidence);
}

/// Contrast of ln σ̂ = ½ ln of the mean of σ̂ᵢ².
Drift log_diffusion(std::vector<MemberStatistics> const& cells, std::size_t effect, double confidence) {
  auto const influence = [](MemberStatistics const& s) -> Eigen::ArrayXd {
    double const mean = s.walk.mean();
    return 0.5 * (std::log(mean) + s.walk / mean - 1);
  };
  return mean_of(contrast(cells, effect, influence), confidence);
}

FactorialEffect effect_of(std::vector<MemberStatistics> const& cells, std::size_t effect, double confidence) {
  FactorialEffect found;
  auto const slope = [](MemberStatistics const& s) { return s.slope; };
  found.drift = mean_of(contrast(cells, effect, slope), confidence);
  found.drift.share = std::abs(found.drift.per_step / cells.front().slope.mean());
  auto const slopes = mean_of(contrast(cells, effect, slope_variances), confidence);
  double const tau2 = slope_variances(cells.front()).mean();
  if (tau2 > 0) found.slopes = {slopes.per_step / tau2, {slopes.interval.low / tau2, slopes.interval.high / tau2}};
  found.p_slopes = slopes.p;
  auto const diffusion = log_diffusion(cells, effect, confidence);
  found.diffusion = {std::exp(diffusion.per_step),
                     {std::exp(diffusion.interval.low), std::exp(diffusion.interval.high)}};
  found.p_diffusion = diffusion.p;
  return found;
}

/// Holm over one question of all effects.
template <class P>
void correct(std::vector<FactorialEffect>& effects, P p) {
  std::vector<double> alone;
  for (auto& effect : effects) alone.push_back(p(effect));
  auto const together = adjusted(alone, Correction::holm);
  for (std::size_t i = 0; i < effects.size(); ++i) p(effects[i]) = together[i];
}

}  // namespace

std::vector<FactorialEffect> factorial_effects(std::vector<MemberStatistics> const& cells,
                                               std::vector<std::string> const& names, double confidence) {
  std::vector<std::size_t> subsets;
  for (std::size_t effect = 1; effect < cells.size(); ++effect) subsets.push_back(effect);
  std::stable_sort(subsets.begin(), subsets.end(),
                   [](std::size_t a, std::size_t b) { return std::popcount(a) < std::popcount(b); });
  std::vector<FactorialEffect> effects;
  for (auto const subset : subsets) {
    effects.push_back(effect_of(cells, subset, confidence));
    for (std::size_t j = 0; j < names.size(); ++j)
      if (subset >> j & 1) effects.back().factors.push_back(names[j]);
  }
  correct(effects, [](FactorialEffect& e) -> double& { return e.drift.p; });
  correct(effects, [](FactorialEffect& e) -> double& { return e.p_slopes; });
  correct(effects, [](FactorialEffect& e) -> double& { return e.p_diffusion; });
  return effects;
}

}  // namespace brouwer
