#include "analysis/causes/causes_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/store/whole_file.hpp>
#include <cmath>

#include "analysis/causes/causes.hpp"
#include "analysis/causes/explain_table.hpp"
#include "analysis/causes/levels_in_words.hpp"
#include "analysis/causes/remainder.hpp"
#include "analysis/escape.hpp"
#include "analysis/figures/figure_family.hpp"
#include "analysis/figures/figure_sheet.hpp"

namespace brouwer {
namespace {

constexpr double widest = 3;  ///< shares beyond are not drawn to scale

/// A line of the figure.
struct Line {
  std::string words;
  Share left;
  bool fits() const { return std::abs(left.value) <= widest; }
};

struct Picture {
  std::string stem, title, subtitle, x_label;
  std::vector<Line> lines;
};

char const* property(Subject subject) {
  if (subject == Subject::drift) return "the drift";
  return subject == Subject::slopes ? "the variance of the slopes" : "the error";
}

Picture picture_of(Explanation const& e, std::vector<Explanation> const& all, std::size_t number) {
  Picture picture{fmt::format("causes-{}", number),
                  fmt::format("What makes {}: {}", property(e.subject), to_string(e.cause)),
                  subject_line(e, all) + "; green: less than half of it is left; orange: more; grey: not resolved",
                  fmt::format("left of {} of the nominal cell, %", property(e.subject)),
                  {}};
  for (auto const& cell : e.cells)
    if (auto const& left = left_of(cell, e.subject); std::isfinite(left.value))
      picture.lines.push_back({changes_in_words(cell.changed, cell.cell), left});
  return picture;
}

char const* colour_of(Share const& left) {
  switch (remainder_of(left)) {
    case Remainder::gone:
      return "0x009e73";
    case Remainder::there:
      return "0xd55e00";
    case Remainder::unknown:
      return "0x888888";
  }
  return "";
}

/// gnuplot's axis ends long before.
double percent(double share) { return 100 * std::clamp(share, -1e6, 1e6); }

/// y, value, low, high in percent, colour, and whether it is drawn to scale.
std::string data_of(Picture const& picture) {
  std::string text = "# line  left  low  high  colour  fits\n";
  for (std::size_t i = 0; i < picture.lines.size(); ++i) {
    auto const& left = picture.lines[i].left;
    text += fmt::format("{} {} {} {} {} {}\n", picture.lines.size() - i, plot_number(percent(left.value)),
                        plot_number(percent(left.interval.low)), plot_number(percent(left.interval.high)),
                        colour_of(left), picture.lines[i].fits() ? 1 : 0);
  }
  return text;
}

/// All that is drawn to scale, with 0 and 1.
Interval range_of(Picture const& picture) {
  Interval range{0, 1};
  for (auto const& line : picture.lines) {
    if (!line.fits()) continue;
    range.low = std::min(range.low, std::max(line.left.interval.low, -widest));
    range.high = std::max(range.high, std::min(line.left.interval.high, widest));
  }
  double const room = 0.08 * (range.high - range.low);
  return {range.low - room, range.high + room};
}

/// In pixels.
struct Frame {
  int left, right, height, width = 460, head = 66, foot = 56;
  int all_width() const { return left + width + right; }
  int all_height() const { return head + height + foot; }
  std::string x(int pixels) const { return fmt::format("{:.5f}", static_cast<double>(pixels) / all_width()); }
  std::string y(int pixels) const { return fmt::format("{:.5f}", static_cast<double>(pixels) / all_height()); }
};

/// Fonts differ: with some room to spare.
int room_for(std::string const& text) { return 24 + pixels_of(text, 13); }

Frame frame_of(Picture const& picture) {
  int left = 0, right = 0;
  for (auto const& line : picture.lines) {
    left = std::max(left, room_for(line.words));
    right = std::max(right, room_for(percent_range(line.left.interval)));
  }
  return {left, right, std::max(90, 24 * static_cast<int>(picture.lines.size() + 1))};
}

std::string label(std::string const& text, std::string const& place, std::string const& how) {
  return fmt::format("set label {} at {} {} noenhanced\n", gnuplot_string(text), place, how);
}

/// Names at the left, numbers at the right; a triangle at the edge where a cell is not drawn to scale.
std::string labels_of(Picture const& picture, Frame const& frame, double unit) {
  std::string text;
  for (std::size_t i = 0; i < picture.lines.size(); ++i) {
    auto const& line = picture.lines[i];
    auto const at = [&](int pixels) {
      return fmt::format("screen {}, first {}", frame.x(pixels), picture.lines.size() - i);
    };
    text += label(line.words, at(frame.left - 8), fmt::format("right font ',{:g}'", 11 * unit));
    bool const above = line.left.value > 0;
    if (!line.fits())
      text += label(above ? "▶" : "◀", at(above ? frame.left + frame.width - 4 : frame.left + 4),
                    fmt::format("{} textcolor rgb {}", above ? "right" : "left", colour_of(line.left)));
    text += label(percent_range(line.left.interval), at(frame.left + frame.width + 8),
                  fmt::format("left font ',{:g}'", 10 * unit));
  }
  return text;
}

std::string script_of(Picture const& picture, FigureFormat format) {
  auto const frame = frame_of(picture);
  double const unit = font_unit(format);
  auto const range = range_of(picture);
  std::string text = fmt::format(
      "# gnuplot {0}.gp  draws {0}.{1} from {0}.dat\nreset\nset encoding utf8\nset terminal {2}\n", picture.stem,
      extension(format), gnuplot_terminal(format, frame.all_width(), frame.all_height(), picture.stem));
  text += fmt::format("set output {}\n", gnuplot_string(picture.stem + "." + extension(format)));
  text += fmt::format(
      "set lmargin at screen {}; set rmargin at screen {}; set tmargin at screen {}; set bmargin at screen {}\n",
      frame.x(frame.left), frame.x(frame.left + frame.width), frame.y(frame.foot + frame.height), frame.y(frame.foot));
  text += label(picture.title, fmt::format("screen {}, screen {}", frame.x(14), frame.y(frame.all_height() - 22)),
                fmt::format("left font ':Bold,{:g}'", 16 * unit));
  text += label(picture.subtitle, fmt::format("screen {}, screen {}", frame.x(14), frame.y(frame.all_height() - 46)),
                fmt::format("left textcolor rgb '#555555' font ',{:g}'", 12 * unit));
  text += label(picture.x_label,
                fmt::format("screen {}, screen {}", frame.x(frame.left + frame.width / 2), frame.y(14)), "center");
  text += labels_of(picture, frame, unit);
  text += fmt::format(
      "set border 1 lc rgb '#444444'; set xtics nomirror out scale 0.5 font ',{:g}'; unset ytics; unset key\n",
      10 * unit);
  text += fmt::format("set grid xtics lc rgb '#e4e4e4' lt 1; set xrange {}; set yrange [0.3:{}.7]\n",
                      plot_range(100 * range.low, 100 * range.high), picture.lines.size());
  for (int const at : {0, 100})
    text += fmt::format("set arrow from {0}, graph 0 to {0}, graph 1 nohead lw 1.2 dt 2 lc rgb '#444444'\n", at);
  return text + fmt::format(
                    "plot {} using ($6 > 0 ? $2 : NaN):1:3:4:5 with xerrorbars pt 7 ps 0.7 lw 1.8 lc rgb "
                    "variable\nunset output\n",
                    gnuplot_string(picture.stem + ".dat"));
}

}  // namespace

Figures draw_causes(std::vector<Explanation> const& explanations, std::filesystem::path const& folder,
                    std::string const& format) {
  auto const chosen = figure_format(format);
  make_figure_folder(folder);
  Figures figures;
  std::size_t number = 0;
  for (auto const& e : explanations) {
    if (e.subject == Subject::nothing || e.cells.empty()) continue;
    auto const picture = picture_of(e, explanations, ++number);
    write_whole(folder / (picture.stem + ".dat"), data_of(picture));
    draw_script(folder, picture.stem, extension(chosen), script_of(picture, chosen), figures);
  }
  return figures;
}

}  // namespace brouwer
