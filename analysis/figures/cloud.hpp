#pragma once
#include <brouwer/store/orbits.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/figures/plots.hpp"

namespace brouwer {

/// The two state components that a picture of phase space shows.
struct Plane {
  std::string x, y;
};

/// What a picture in this plane needs. @throws InputError where it shows one component twice, where no cell kept states,
/// and for a component that the states do not have
void check_plane(std::vector<Orbits> const& cells, Plane const& plane);

/// Draws the members of each cell as a cloud in phase space: cloud.gif, a frame a sample from the start on (evenly
/// thinned to at most 120) with the last one held, and cloud-still.FORMAT, the first, the middle and the last frame. A
/// panel a cell, the same axes in equal scale in all of them; of many cells the first 12, and the note says so. Members are coloured by the order of x at their start, so
/// that one sees them mix; the start stays visible in grey. Where a cloud runs away (an unstable method) the axes keep
/// to the others. Scripts and data lie beside, as in draw_figures.
/// @param cells  those without members are passed over; without any nothing is drawn
/// @param plane  the first two state components where not given
/// @param format svg, png or pdf
/// @throws InputError for another format and for a component that the state does not have, RunError where the folder cannot be written
Figures draw_clouds(std::vector<Orbits> const& cells, std::filesystem::path const& folder,
                    std::optional<Plane> const& plane = {}, std::string const& format = "svg");

}  // namespace brouwer
