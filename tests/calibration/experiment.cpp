#include "tests/calibration/experiment.hpp"

#include <omp.h>

namespace brouwer::calibration {

void Tally::add(Trial const& trial) {
  rates.resize(claims().size());
  for (std::size_t k = 0; k < rates.size(); ++k)
    if (is_asked(claims()[k], *model))
      if (auto const answer = claims()[k].asked(trial)) rates[k].add(*answer);
  ++verdicts[static_cast<std::size_t>(trial.estimates.verdict)];
}

void Tally::add(Tally const& other) {
  rates.resize(claims().size());
  for (std::size_t k = 0; k < other.rates.size(); ++k) {
    rates[k].hits += other.rates[k].hits;
    rates[k].trials += other.rates[k].trials;
  }
  for (std::size_t v = 0; v < verdict_count; ++v) verdicts[v] += other.verdicts[v];
}

Tally tally(Model const& model, Design const& design) {
  Tally total{&model, design, {}, {}};
#pragma omp parallel
  {
    Tally own{&model, design, {}, {}};
#pragma omp for schedule(dynamic, 8)
    for (int number = 0; number < design.trials; ++number)
      own.add(trial(model, design, static_cast<std::uint32_t>(number)));
#pragma omp critical
    total.add(own);
  }
  return total;
}

}  // namespace brouwer::calibration
