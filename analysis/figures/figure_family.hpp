#pragma once
#include <string>
#include <vector>

#include "analysis/estimates.hpp"
#include "analysis/figures/figure_sheet.hpp"

namespace brouwer {

/// The rows that share a figure: all components of one quantity in all cells.
struct Family {
  struct Row {
    Estimates const* estimates;
    std::vector<double> const* final_errors;  ///< null where they are not known
    std::size_t cell, component;              ///< indices below
    double cpu_seconds;                       ///< of a member; NaN where not known
  };
  std::string name, stem, unit;
  std::vector<std::string> cells;       ///< labels: what tells a cell from the others
  std::vector<std::string> colours;     ///< of the cells
  std::vector<int> marks;               ///< of the cells: which point type tells cells of one colour apart
  std::vector<std::string> components;  ///< {"energy"} or {"spatial-momentum-1", …}
  std::vector<Row> rows;                ///< cell by cell
  std::string shared;                   ///< what all cells have in common, for the subtitle
  std::string members;                  ///< "64 members" or "39 of 100 members"; "" where cells differ
  bool in_steps = true;                 ///< the unit of time

  std::string time_label() const { return in_steps ? "steps" : "time"; }
  std::string error_label(std::string const& what) const;
};

/// In the order in which quantities first appear. Pointers into the arguments are kept.
std::vector<Family> families(std::vector<Estimates> const& rows, std::vector<std::vector<double>> const& final_errors,
                             std::vector<double> const& cpu_seconds = {});

/// Does it grow as a walk or as a drift? RMS on logarithmic axes, a panel a component, a curve a cell.
FigureSheet growth_sheet(Family const& family);

/// Are the final errors normal? A panel a cell.
FigureSheet histogram_sheet(Family const& family);

/// Are the increments normal? A panel a cell.
FigureSheet increments_sheet(Family const& family);

/// Does the mean leave zero? A panel a cell, a curve a component.
FigureSheet mean_sheet(Family const& family);

/// What does precision cost? Error at the end against steps, and against CPU time where it is known, a line a method.
/// No panels where fewer than two steps h end at the same time.
FigureSheet precision_sheet(Family const& family);

/// Of a count: mean over members with their spread. A panel a component, a curve a cell.
FigureSheet count_sheet(Family const& family);

/// Colours that readers with any kind of colour vision tell apart (Okabe & Ito 2008), up to seven.
std::string distinct_colour(std::size_t index);

/// From dark violet over blue and green to orange, for 0 … 1: ordered also for those who see no hue.
std::string ordered_colour(double position);

/// "#rrggbb" mixed with white: 0 leaves it, 1 is white.
std::string paler(std::string const& colour, double white);

/// 1, 2 or 5 times a power of ten, so that an axis of this length has three to five tics.
double tic_distance(double length);

/// "NaN" as gnuplot reads it, otherwise nine digits.
std::string plot_number(double x);

/// "[low:high]" for set xrange: never empty, never reversed.
std::string plot_range(double low, double high);

}  // namespace brouwer
