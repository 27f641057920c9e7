#include "analysis/figures/figure_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>

#include "analysis/escape.hpp"
#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

/// Where things are, in pixels from the lower left corner.
struct Geometry {
  int columns, rows, panel_width, panel_height, legend_width;
  double font_unit;                                       // what a terminal calls one pixel of a font's size
  int head = 58, left = 26, foot = 34, right = 18;        // around the whole
  int tics_left = 62, tics_below = 28, panel_title = 12;  // around each panel
  int width() const { return left + columns * (tics_left + panel_width) + right + legend_width; }
  int height() const { return head + rows * (panel_title + panel_height + tics_below) + foot; }
  int panel_left(int column) const { return left + tics_left + column * (tics_left + panel_width); }
  int panel_top(int row) const {
    return height() - head - row * (panel_title + panel_height + tics_below) - panel_title;
  }
  int legend_left() const { return width() - legend_width; }
  std::string font(int pixels) const { return fmt::format("font ',{:g}'", pixels * font_unit); }
  std::string x(int pixels) const { return fmt::format("{:.5f}", static_cast<double>(pixels) / width()); }
  std::string y(int pixels) const { return fmt::format("{:.5f}", static_cast<double>(pixels) / height()); }
};

/// Nearly square grids, at most five panels wide.
int columns_for(std::size_t panels) {
  constexpr std::size_t widest[] = {0, 1, 2, 3, 2, 3, 3, 4, 4, 3, 4, 4, 4};
  return static_cast<int>(panels < std::size(widest) ? widest[panels] : 5);
}

int legend_height(FigureSheet const& sheet) { return 18 * static_cast<int>(sheet.legend.size()); }

Geometry geometry_of(FigureSheet const& sheet, FigureFormat format) {
  int const count = static_cast<int>(sheet.panels.size()), columns = columns_for(sheet.panels.size());
  Geometry g{};
  g.font_unit = font_unit(format);
  g.columns = columns;
  g.rows = (count + columns - 1) / columns;
  g.panel_width = count == 1 ? 520 : count <= 4 ? 340 : 230;
  g.panel_height = count == 1 ? 360 : count <= 4 ? 250 : 160;
  for (auto const& panel : sheet.panels) {
    g.panel_width = std::max(g.panel_width, std::min(pixels_of(panel.title, 11), 420));
    g.panel_title = std::max(g.panel_title, !panel.subtitle.empty() ? 40 : !panel.title.empty() ? 26 : 12);
  }
  for (auto const& entry : sheet.legend) g.legend_width = std::max(g.legend_width, 64 + pixels_of(entry.text, 11));
  g.panel_height = std::max(g.panel_height, legend_height(sheet) / g.rows);
  return g;
}

std::string label(std::string const& text, std::string const& x, std::string const& y, std::string const& how) {
  return fmt::format("set label {} at screen {}, screen {} {} noenhanced\n", gnuplot_string(text), x, y, how);
}

/// What is written once: the question, what was run, and the names of the axes.
std::string head(FigureSheet const& sheet, Geometry const& g) {
  int const middle_x = (g.left + g.tics_left + g.legend_left() - g.right) / 2,
            middle_y = (g.foot + g.height() - g.head) / 2;
  return label(sheet.title, g.x(14), g.y(g.height() - 22), fmt::format("left font ':Bold,{:g}'", 16 * g.font_unit)) +
         label(sheet.subtitle, g.x(14), g.y(g.height() - 44), "left textcolor rgb '#555555'") +
         label(sheet.x_label, g.x(middle_x), g.y(16), "center") +
         label(sheet.y_label, g.x(16), g.y(middle_y), "center rotate by 90");
}

std::string box(Geometry const& g, int left, int top, int width, int height) {
  return fmt::format(
      "set lmargin at screen {}; set rmargin at screen {}; set tmargin at screen {}; set bmargin at screen {}\n",
      g.x(left), g.x(left + width), g.y(top), g.y(top - height));
}

std::string plotted(std::vector<std::string> const& curves) {
  return fmt::format("plot {}\n", fmt::join(curves, ", \\\n     "));
}

std::string panel_script(Panel const& panel, Geometry const& g, int index) {
  int const left = g.panel_left(index % g.columns), top = g.panel_top(index / g.columns);
  bool const two_lines = !panel.subtitle.empty();
  std::string text = box(g, left, top, g.panel_width, g.panel_height);
  text += label(panel.title, g.x(left), g.y(top + (two_lines ? 26 : 10)), "left " + g.font(11));
  if (two_lines)
    text += label(panel.subtitle, g.x(left), g.y(top + 9), "left " + g.font(10) + " textcolor rgb '#555555'");
  if (!panel.x_label.empty()) text += label(panel.x_label, g.x(left + g.panel_width / 2), g.y(16), "center");
  if (!panel.scale.empty()) text += label(panel.scale, g.x(left - 6), g.y(top + 9), "right " + g.font(10));
  for (auto const& setting : panel.settings) text += setting + '\n';
  return text + plotted(panel.curves) + "unset label\n";
}

/// An empty panel whose only content is its key.
std::string legend_script(FigureSheet const& sheet, Geometry const& g) {
  if (sheet.legend.empty()) return "";
  std::vector<std::string> curves;
  for (auto const& entry : sheet.legend)
    curves.push_back(fmt::format("NaN {} title {} noenhanced", entry.style, gnuplot_string(entry.text)));
  return "\nunset border; unset tics; unset grid; unset logscale; unset xzeroaxis; set xrange [0:1]; set yrange "
         "[0:1]\n" +
         box(g, g.legend_left(), g.panel_top(0), g.legend_width - 4, g.panel_top(0) - g.foot) +
         fmt::format("set key at screen {}, screen {} left top Left reverse maxcols 1 samplen 2.5 spacing 1.25 {}\n",
                     g.x(g.legend_left()), g.y(g.panel_top(0) + 8), g.font(11)) +
         plotted(curves);
}

}  // namespace

std::string gnuplot_script(FigureSheet const& sheet, FigureFormat format) {
  auto const g = geometry_of(sheet, format);
  std::string text = fmt::format("# gnuplot {0}.gp  draws {0}.{1} from {0}.dat\n", sheet.stem, extension(format));
  text += fmt::format("reset\nset encoding utf8\nset terminal {}\nset output {}\n",
                      gnuplot_terminal(format, g.width(), g.height(), sheet.stem),
                      gnuplot_string(sheet.stem + "." + extension(format)));
  text += "set border 3 lc rgb '#444444'; set tics nomirror out scale 0.5 " + g.font(10) +
          "; set grid lc rgb '#e4e4e4' lt 1\n" +
          "set style fill transparent solid 0.18 noborder; set pointsize 0.55; unset key\nset multiplot\n" +
          head(sheet, g);
  for (std::size_t i = 0; i < sheet.panels.size(); ++i)
    text += '\n' + panel_script(sheet.panels[i], g, static_cast<int>(i));
  return text + legend_script(sheet, g) + "unset multiplot\nunset output\n";
}

std::string gnuplot_terminal(FigureFormat format, int width, int height, std::string const& stem) {
  std::string id = "figure_" + stem;
  std::replace_if(
      id.begin(), id.end(), [](char c) { return c == '-' || c == '.'; }, '_');
  switch (format) {
    case FigureFormat::svg:
      return fmt::format("svg size {},{} dynamic font 'sans-serif,12' background '#ffffff' name '{}'", width, height,
                         id);
    case FigureFormat::png:
      return fmt::format("pngcairo size {},{} font 'sans-serif,9' fontscale 2 linewidth 2 pointscale 2", 2 * width,
                         2 * height);
    case FigureFormat::pdf:
      return fmt::format("pdfcairo size {:.3f}in,{:.3f}in font 'sans-serif,9' linewidth 1 background '#ffffff'",
                         width / 96.0, height / 96.0);
  }
  return {};
}

int pixels_of(std::string const& text, int font) {
  return static_cast<int>(0.6 * font * static_cast<double>(display_width(text)));
}

double font_unit(FigureFormat format) { return format == FigureFormat::svg ? 1 : 0.75; }

FigureFormat figure_format(std::string const& name) {
  std::vector<std::string> names;
  for (auto const format : {FigureFormat::svg, FigureFormat::png, FigureFormat::pdf}) {
    if (name == extension(format)) return format;
    names.push_back(extension(format));
  }
  throw InputError(fmt::format("there is no figure format '{}'{}", one_line(name), suggestion(name, names)));
}

std::string extension(FigureFormat format) {
  switch (format) {
    case FigureFormat::svg:
      return "svg";
    case FigureFormat::png:
      return "png";
    case FigureFormat::pdf:
      return "pdf";
  }
  return {};
}

}  // namespace brouwer
