#pragma once
#include <string>
#include <vector>

namespace brouwer {

enum class FigureFormat { svg, png, pdf };

/// One coordinate system of a figure.
struct Panel {
  std::string title, subtitle;        ///< user's words, unquoted
  std::string scale;                  ///< above the vertical axis: "×10⁻¹⁵"
  std::vector<std::string> settings;  ///< gnuplot commands: ranges, logarithmic axes
  std::vector<std::string> curves;    ///< elements of a plot command
  std::string x_label = {};           ///< where the panels of a single row have different ones
};

/// A figure as data: panels in a grid, one title that asks a question, one legend beside them.
struct FigureSheet {
  struct LegendEntry {
    std::string style;  ///< gnuplot: "with lines lc rgb '#0072b2'"
    std::string text;   ///< user's words, unquoted
  };
  std::string stem;  ///< of its files: growth-energy
  std::string title, subtitle;
  std::string x_label, y_label;
  std::vector<Panel> panels;
  std::vector<LegendEntry> legend;
  std::string data;  ///< columns for STEM.dat

  std::string data_file() const { return stem + ".dat"; }
};

/// The gnuplot script of a sheet: runs as it stands in the folder of its data file and writes STEM.FORMAT there.
std::string gnuplot_script(FigureSheet const& sheet, FigureFormat format);

/// A terminal of so many pixels: for PNG a screen that is twice as fine, for PDF a sheet of 96 pixels an inch.
std::string gnuplot_terminal(FigureFormat format, int width, int height, std::string const& stem);

/// What the terminal calls one pixel of a font's size: cairo counts in points, svg in pixels.
double font_unit(FigureFormat format);

/// About how many pixels words take in a font of so many pixels.
int pixels_of(std::string const& text, int font);

std::string extension(FigureFormat format);

/// "svg", "png" or "pdf". @throws InputError for another, with the nearest
FigureFormat figure_format(std::string const& name);

}  // namespace brouwer
