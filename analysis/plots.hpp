#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/estimates.hpp"

namespace brouwer {

struct Figures {
  std::vector<std::filesystem::path> files;  ///< the figures that were drawn
  std::string note;  ///< a sentence, where gnuplot is missing or failed; scripts and data are kept
};

/// Draws three figures of each quantity (its components and all cells together) with gnuplot: growth-NAME (RMS on
/// logarithmic axes with its band, the fitted law and Brouwer's σ√t), histogram-NAME (final errors, standardised,
/// against the normal law) and mean-NAME (mean over members with its interval, fitted drift). Beside each figure lie
/// its script NAME.gp, which runs as it stands, and its data NAME.dat.
/// @param final_errors  row by row of the estimates, the members' errors at the last sample; where empty, no histogram
/// @param folder        made if it does not exist
/// @param format        svg, png or pdf
/// @throws InputError for another format, RunError where the folder cannot be written
Figures draw_figures(std::vector<Estimates> const& estimates, std::vector<std::vector<double>> const& final_errors,
                     std::filesystem::path const& folder, std::string const& format);

}  // namespace brouwer
