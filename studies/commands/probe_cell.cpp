#include "studies/commands/probe_cell.hpp"

#include <algorithm>

#include "analysis/probe/local_errors.hpp"

namespace brouwer {
namespace {

bool still_changes(LocalErrors const& errors, Levels const& levels) {
  return !errors.of_state && errors.rounding.rows() > 1 && estimate(errors, levels).rounding.still_changing;
}

bool can_be_longer(Probe const& probed) {
  auto const& design = probed.design;
  return 4 * design.steps() <= design.covered &&
         std::all_of(probed.errors.begin(), probed.errors.end(), [](auto const& errors) { return errors.judged == 1; });
}

}  // namespace

Probe probe_cell(Study const& study, Catalogue const& catalogue, CellLabels const& cell, ProbeDesign design,
                 RunOptions const& options, Levels const& levels) {
  Probe probed = probe(study, catalogue, cell, design, options);
  while (can_be_longer(probed) && std::any_of(probed.errors.begin(), probed.errors.end(),
                                              [&](auto const& errors) { return still_changes(errors, levels); })) {
    double const seconds = probed.seconds;
    design = probed.design;
    design.length *= 4;
    probed = probe(study, catalogue, cell, design, options);
    probed.seconds += seconds;
  }
  return probed;
}

}  // namespace brouwer
