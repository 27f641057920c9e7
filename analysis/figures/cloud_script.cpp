#include "analysis/figures/cloud_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/escape.hpp"
#include "analysis/figures/figure_family.hpp"
#include "analysis/figures/figure_sheet.hpp"

namespace brouwer {
namespace {

using Words = std::vector<std::string>;

constexpr int film_centiseconds = 900, held_centiseconds = 220;

/// A grid of equal panels, in pixels from the lower left corner; a unit of x is as long as one of y.
struct Grid {
  int columns = 1, rows = 1, panel_width = 0, panel_height = 0;
  int between = 62, above = 26, least_width = 0;  // between panels; above each; of the whole
  double font_unit = 1;                           // what a terminal calls one pixel of a font's size
  bool smooth = true;
  static constexpr int head = 64, left = 62, right = 22, below = 44, foot = 4;

  int width() const { return std::max(least_width, left + columns * panel_width + (columns - 1) * between + right); }
  int height() const { return head + rows * (above + panel_height + below) + foot; }
  std::string x(int pixels) const { return fmt::format("{:.5f}", static_cast<double>(pixels) / width()); }
  std::string y(int pixels) const { return fmt::format("{:.5f}", static_cast<double>(pixels) / height()); }
  int panel_left(int column) const { return left + column * (between + panel_width); }
  int panel_top(int row) const { return height() - head - row * (above + panel_height + below) - above; }
  std::string font(int pixels) const { return fmt::format("font ',{:g}'", pixels * font_unit); }
  std::string bold(int pixels) const { return fmt::format("font ':Bold,{:g}'", pixels * font_unit); }
};

/// Titles stand beside one another, and the subtitle stands on one line.
Grid grid_of(CloudFilm const& film, std::size_t columns, std::size_t rows, double font_unit) {
  double const width = film.x_range.high - film.x_range.low, height = film.y_range.high - film.y_range.low;
  double const longest = columns <= 2 ? 420 : columns == 3 ? 330 : 290;
  auto const pixels = [&](double side) {
    return static_cast<int>(std::lround(longest * side / std::max(width, height)));
  };
  Grid g{static_cast<int>(columns), static_cast<int>(rows), pixels(width), pixels(height)};
  for (auto const& cell : film.cells)
    g.between = std::max(g.between, pixels_of(cell.title, 12) + Grid::right - g.panel_width);
  g.least_width = pixels_of(film.subtitle, 12) + 28;
  g.font_unit = font_unit;
  return g;
}

/// `text` is an expression of gnuplot: a quoted string or a variable.
std::string label(std::string const& text, std::string const& x, std::string const& y, std::string const& how) {
  return fmt::format("set label {} at screen {}, screen {} {} noenhanced\n", text, x, y, how);
}

/// User's words become variables, outside of loops, where no brace in them can end anything.
std::string variable(std::string const& name, std::string const& text) {
  return fmt::format("{} = {}\n", name, gnuplot_string(text));
}

std::string variables(CloudFilm const& film) {
  std::string text = variable("question", "Where does the ensemble go?") + variable("subtitle", film.subtitle) +
                     variable("x_name", film.x) + variable("y_name", film.y);
  for (std::size_t c = 0; c < film.cells.size(); ++c) {
    text += variable(fmt::format("title{}", c), film.cells[c].title);
    text += variable(fmt::format("times{}", c), fmt::format("{}", fmt::join(film.cells[c].times, " ")));
    text += variable(fmt::format("unseen{}", c), fmt::format("{}", fmt::join(film.cells[c].unseen, " ")));
    text += variable(fmt::format("ended{}", c), fmt::format("{}", fmt::join(film.cells[c].ended, " ")));
  }
  return text;
}

bool equal_times(CloudFilm const& film) {
  return std::all_of(film.cells.begin(), film.cells.end(),
                     [&](auto const& cell) { return cell.times == film.cells.front().times; });
}

double shorter_side(CloudFilm const& film) {
  return std::min(film.x_range.high - film.x_range.low, film.y_range.high - film.y_range.low);
}

std::string prologue(CloudFilm const& film, Grid const& g, std::string const& stem, std::string const& extension,
                     std::string const& terminal) {
  return fmt::format("# gnuplot {0}.gp  draws {0}.{1} from cloud.dat\nreset\nset encoding utf8\nset terminal {2}\n",
                     stem, extension, terminal) +
         fmt::format("set output '{}.{}'\n", stem, extension) + variables(film) +
         "set border 3 lc rgb '#444444'; set tics nomirror out scale 0.5 " + g.font(10) +
         "; set grid lc rgb '#ececec' lt 1; unset key\n" +
         fmt::format("set xrange {0}; set yrange {1}; set xtics {2:g}; set ytics {2:g}\n",
                     plot_range(film.x_range.low, film.x_range.high), plot_range(film.y_range.low, film.y_range.high),
                     tic_distance(0.75 * shorter_side(film)));
}

std::string quiet(Grid const& g, int pixels) { return g.font(pixels) + " textcolor rgb '#555555'"; }

std::string head(Grid const& g) {
  return label("question", g.x(14), g.y(g.height() - 22), "left " + g.bold(16)) +
         label("subtitle", g.x(14), g.y(g.height() - 46), "left " + quiet(g, 12));
}

/// Many points are small ones; in a GIF, which smooths no edges, larger.
double point_size(CloudFilm const& film, bool smooth) {
  std::size_t most = 1;
  for (auto const& cell : film.cells) most = std::max(most, cell.points);
  double const size = std::clamp(9 / std::sqrt(static_cast<double>(most)), 0.4, 0.8);
  return smooth ? size : 1.4 * size;
}

/// "12 of 600 out of sight, 3 of 600 ended" where points are outside the axes, or have failed.
std::string missing_of(CloudFilm const& film, std::size_t cell, std::string const& frame) {
  auto const unseen = fmt::format("word(unseen{}, {} + 1)", cell, frame);
  auto const ended = fmt::format("word(ended{}, {} + 1)", cell, frame);
  auto const part = [&](std::string const& number, char const* what) {
    return fmt::format("({0} eq '0' ? '' : {0}.' of {1} {2}')", number, film.cells[cell].points, what);
  };
  return fmt::format("{}.({} eq '0' || {} eq '0' ? '' : ', ').{}", part(unseen, "out of sight"), unseen, ended,
                     part(ended, "ended"));
}

std::string time_of(std::size_t cell, std::string const& frame) {
  return fmt::format("'t = '.word(times{}, {} + 1)", cell, frame);
}

/// One panel: the start in grey, and above it the frame; `frame` is an expression of gnuplot.
std::string panel(CloudFilm const& film, Grid const& g, int column, int row, std::size_t cell, std::string const& frame,
                  std::string const& title) {
  int const left = g.panel_left(column), top = g.panel_top(row);
  auto const points = [&](std::string const& block, std::string const& colour) {
    return fmt::format("'cloud.dat' index {} using {} with points pt 7 ps {:.3g} lc rgb {}", block,
                       colour == "variable" ? "1:2:3" : "1:2", point_size(film, g.smooth), colour);
  };
  return fmt::format(
             "set lmargin at screen {}; set rmargin at screen {}; set tmargin at screen {}; set bmargin at "
             "screen {}\n",
             g.x(left), g.x(left + g.panel_width), g.y(top), g.y(top - g.panel_height)) +
         label(title, g.x(left), g.y(top + 12), "left " + g.font(12)) +
         label(missing_of(film, cell, frame), g.x(left + 8), g.y(top - g.panel_height + 12),
               "left front " + quiet(g, 11)) +
         label("x_name", g.x(left + g.panel_width / 2), g.y(top - g.panel_height - 34), "center " + g.font(12)) +
         label("y_name", g.x(left - 46), g.y(top - g.panel_height / 2), "center rotate by 90 " + g.font(12)) +
         fmt::format("plot {}, \\\n     {}\nunset label\n", points(fmt::format("{}", cell), "'#dcdcdc'"),
                     points(fmt::format("({})*{}+{}", frame, film.cells.size(), cell), "variable"));
}

/// Panels side by side, at most four; then in rows.
Grid moving_grid(CloudFilm const& film) {
  auto const cells = film.cells.size(), columns = cells <= 4 ? cells : std::min<std::size_t>((cells + 1) / 2, 4);
  return grid_of(film, columns, (cells + columns - 1) / columns, 0.75);
}

}  // namespace

std::string moving_script(CloudFilm const& film) {
  auto g = moving_grid(film);
  g.smooth = false;
  auto const frames = static_cast<int>(film.frames()), delay = std::clamp(film_centiseconds / frames, 8, 40);
  bool const one_clock = equal_times(film);
  auto text = prologue(film, g, "cloud", "gif",
                       fmt::format("gif animate delay {} loop 0 optimize size {},{} background '#ffffff' font "
                                   "'sans-serif,9' enhanced",
                                   delay, g.width(), g.height()));
  text += fmt::format("do for [k = 0:{}] {{  # the last frame is held\nf = k < {} ? k : {}\nset multiplot\n",
                      frames - 1 + held_centiseconds / delay, frames, frames - 1);
  text += head(g);
  if (one_clock)
    text += label(time_of(0, "f"), g.x(g.width() - Grid::right), g.y(g.height() - 22), "right " + g.bold(16));
  for (std::size_t c = 0; c < film.cells.size(); ++c) {
    auto const at = static_cast<int>(c);
    auto const clock = one_clock ? "" : ".', '." + time_of(c, "f");
    text += panel(film, g, at % g.columns, at / g.columns, c, "f", fmt::format("title{}{}", c, clock));
  }
  return text + "unset multiplot\n}\nunset output\n";
}

std::string still_script(CloudFilm const& film, FigureFormat format) {
  auto g = grid_of(film, 3, film.cells.size(), font_unit(format));
  bool const several = film.cells.size() > 1;
  g.between = Grid::left;  // a cell's title has a line of its own, above the times
  if (several) g.above += 20;
  auto const terminal = gnuplot_terminal(format, g.width(), g.height(), "cloud-still");
  auto text = prologue(film, g, "cloud-still", extension(format), terminal) + "set multiplot\n" + head(g);
  for (std::size_t c = 0; c < film.cells.size(); ++c) {
    auto const row = static_cast<int>(c);
    if (several)
      text += label(fmt::format("title{}", c), g.x(Grid::left), g.y(g.panel_top(row) + 32), "left " + g.bold(12));
    for (int column = 0; column < 3; ++column) {
      auto const frame = fmt::format("{}", (film.frames() - 1) * static_cast<std::size_t>(column) / 2);
      text += panel(film, g, column, row, c, frame, time_of(c, frame));
    }
  }
  return text + "unset multiplot\nunset output\n";
}

}  // namespace brouwer
