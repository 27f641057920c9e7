#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/estimates.hpp"
#include "analysis/figures/plots.hpp"

namespace brouwer {

/// Of all figures those that carry the answer: growth, increments, work and precision, and counts of the families of these
/// quantities (of all where there are none), and the still clouds. Of a sweep over many cells growth and increments are left out.
/// @param quantities  families or components
std::vector<std::filesystem::path> main_figures(Figures const& figures, std::vector<Estimates> const& estimates,
                                                std::vector<std::string> const& quantities);

}  // namespace brouwer
