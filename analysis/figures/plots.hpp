#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/estimates.hpp"

namespace brouwer {

struct Figures {
  std::vector<std::filesystem::path> files;  ///< the figures that were drawn
  std::string
      note;  ///< a sentence, where gnuplot is missing or failed (scripts and data are kept), or not all is drawn
};

/// Draws the figures of each quantity (its components and all cells together) with gnuplot: growth-NAME (RMS on
/// logarithmic axes with its band, the fitted law and Brouwer's σ√t), histogram-NAME and increments-NAME (final errors and
/// increments, standardised, against the normal law), mean-NAME (mean over members with its interval, fitted drift) and, where steps h of a method
/// end at the same time, precision-NAME (error against steps and against CPU time); of a count, count-NAME alone. Beside
/// each figure lie its script NAME.gp, which runs as it stands, and its data NAME.dat.
/// @param final_errors  row by row of the estimates, the members' errors at the last sample; where empty, no histogram
/// @param cpu_seconds   row by row, what a member took; NaN or missing where not known
/// @param folder        made if it does not exist
/// @param format        svg, png or pdf
/// @throws InputError for another format, RunError where the folder cannot be written
Figures draw_figures(std::vector<Estimates> const& estimates, std::vector<std::vector<double>> const& final_errors,
                     std::filesystem::path const& folder, std::string const& format,
                     std::vector<double> const& cpu_seconds = {});

/// Writes STEM.gp and draws STEM.EXTENSION with it; the note says where that fails.
/// @throws RunError where the script cannot be written
void draw_script(std::filesystem::path const& folder, std::string const& stem, std::string const& extension,
                 std::string const& script, Figures& figures);

/// "a; b", or one of them where it says the other as well.
std::string joined_notes(std::string const& a, std::string const& b);

/// @throws RunError where it cannot be made
void make_figure_folder(std::filesystem::path const& folder);

}  // namespace brouwer
