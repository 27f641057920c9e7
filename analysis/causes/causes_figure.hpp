#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/causes/explanation.hpp"
#include "analysis/figures/plots.hpp"

namespace brouwer {

/// Draws a figure causes-N for each explanation that has a subject: what is left of it in every cell of the design, with
/// its interval, from nothing to all and beyond. Cells with more than three times of it stand at the edge with their
/// number. Scripts and data lie beside the figures, as of all figures (plots.hpp).
Figures draw_causes(std::vector<Explanation> const& explanations, std::filesystem::path const& folder,
                    std::string const& format);

}  // namespace brouwer
