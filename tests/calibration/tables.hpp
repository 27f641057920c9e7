#pragma once
#include <string>
#include <vector>

#include "tests/calibration/experiment.hpp"

namespace brouwer::calibration {

/// Markdown, from the tallies of all models and designs; every text is a function of them alone.

/// A line a claim: what is promised, in how many cases it was tried, and the one that is farthest from it.
std::string summary_table(std::vector<Tally> const& tallies);

/// What is simulated.
std::string model_list();

/// A table a claim: models down, designs across.
std::string claim_tables(std::vector<Tally> const& tallies);

/// Which verdict which model was given, in % of the ensembles of a design.
std::string verdict_tables(std::vector<Tally> const& tallies);

/// A sentence for every promised rate that is out of its bounds on the harmful side.
std::vector<std::string> broken_promises(std::vector<Tally> const& tallies);

}  // namespace brouwer::calibration
