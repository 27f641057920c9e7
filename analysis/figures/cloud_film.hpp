#pragma once
#include <string>
#include <vector>

#include "analysis/estimates.hpp"
#include "analysis/figures/cloud.hpp"

namespace brouwer {

/// Clouds as frames: everything that is drawn of them, as data.
struct CloudFilm {
  struct Cell {
    std::string title;                ///< what tells it from the others; "" where there is one only
    std::vector<std::string> times;   ///< of the frames, "12.5", in the system's unit
    std::vector<std::size_t> unseen;  ///< in each frame, how many points are outside the axes
    std::vector<std::size_t> ended;   ///< in each frame, how many members have failed by then
    std::size_t points = 0;
  };
  std::string x, y, subtitle;
  Interval x_range, y_range;  ///< that the picture shows: no side is shorter than 3/4 of the other
  std::vector<Cell> cells;
  std::vector<std::size_t> moments;  ///< of the frames: sample of the cell with most samples
  std::string data;                  ///< a block a frame and cell, frames outside: x  y  0xrrggbb

  std::size_t frames() const { return moments.size(); }
};

/// @param cells  each with members; the film is of the first most_cells
/// @throws InputError for a component that the state does not have
CloudFilm film_of(std::vector<Orbits> const& cells, std::optional<Plane> const& plane);

/// At most this many of a cell's members are drawn, evenly chosen; the subtitle says so.
constexpr std::size_t most_points = 600;
constexpr std::size_t most_frames = 120;
/// At most this many cells: a picture of more is too high to be looked at, and for Cairo. The subtitle says so.
constexpr std::size_t most_cells = 12;

}  // namespace brouwer
