#include "analysis/figures/figure_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>

#include "analysis/escape.hpp"
#include "analysis/factors.hpp"
#include "analysis/verdict/failures.hpp"

namespace brouwer {
namespace {

// M. Okabe, K. Ito, Color Universal Design, 2008; its yellow is too pale for lines, dark grey stands for its black.
constexpr std::array okabe_ito = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#444444"};

template <class T>
std::size_t index_of(std::vector<T>& list, T const& item) {
  auto const found = std::find(list.begin(), list.end(), item);
  if (found != list.end()) return static_cast<std::size_t>(found - list.begin());
  list.push_back(item);
  return list.size() - 1;
}

/// The factor that colours stand for where there are more cells than colours: the one with most levels among those
/// with at most seven.
Factor const* coloured_factor(std::vector<CellLabels> const& cells) {
  Factor const* best = nullptr;
  std::size_t most = 1;
  for (auto const* factor : varying_factors(cells)) {
    std::set<std::string> levels;
    for (auto const& cell : cells) levels.insert(factor->level(cell));
    if (levels.size() > most && levels.size() <= okabe_ito.size()) {
      most = levels.size();
      best = factor;
    }
  }
  return best;
}

void choose_colours(Family& family, std::vector<CellLabels> const& cells) {
  auto const* factor = cells.size() > okabe_ito.size() ? coloured_factor(cells) : nullptr;
  std::vector<std::string> levels;
  std::map<std::string, int> used;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    double const position = cells.size() < 2 ? 0 : static_cast<double>(i) / static_cast<double>(cells.size() - 1);
    if (factor != nullptr)
      family.colours.push_back(distinct_colour(index_of(levels, factor->level(cells[i]))));
    else
      family.colours.push_back(cells.size() <= okabe_ito.size() ? distinct_colour(i) : ordered_colour(position));
    family.marks.push_back(used[family.colours.back()]++);
  }
}

/// "39 of 100 members"; nothing where rows differ.
std::string shared_members(std::vector<Family::Row> const& rows) {
  auto const& first = *rows.front().estimates;
  bool const alike =
      std::all_of(rows.begin(), rows.end(), [&](auto const& row) { return same_members(*row.estimates, first); });
  return alike ? members_in_words(first) : "";
}

void describe_cells(Family& family, std::vector<CellLabels> const& cells) {
  auto const varying = varying_factors(cells);
  for (auto const& cell : cells) family.cells.push_back(short_label(cell, varying));
  family.shared = describe(cells.front(), constant_factors(cells));
  family.members = shared_members(family.rows);
  if (!family.members.empty()) family.shared += (family.shared.empty() ? "" : ", ") + family.members;
  family.in_steps = std::all_of(cells.begin(), cells.end(), [](auto const& cell) { return cell.steps > 0; });
}

std::string family_name(Estimates const& row) { return row.family.empty() ? row.quantity : row.family; }

Family family_of(std::string const& name, std::vector<Estimates> const& rows,
                 std::vector<std::vector<double>> const& final_errors, std::vector<double> const& cpu_seconds) {
  Family family;
  family.name = name;
  std::vector<CellLabels> cells;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (family_name(rows[i]) != name) continue;
    auto const* errors = i < final_errors.size() && !final_errors[i].empty() ? &final_errors[i] : nullptr;
    family.unit = rows[i].unit;
    double const seconds = i < cpu_seconds.size() ? cpu_seconds[i] : std::numeric_limits<double>::quiet_NaN();
    family.rows.push_back(
        {&rows[i], errors, index_of(cells, rows[i].cell), index_of(family.components, rows[i].quantity), seconds});
  }
  std::stable_sort(family.rows.begin(), family.rows.end(),
                   [](auto const& a, auto const& b) { return a.cell < b.cell; });
  describe_cells(family, cells);
  choose_colours(family, cells);
  return family;
}

/// Two names may give one stem: then the later is numbered.
void name_files(std::vector<Family>& all) {
  std::set<std::string> taken;
  for (auto& family : all) {
    family.stem = file_stem(family.name);
    for (int n = 2; !taken.insert(family.stem).second; ++n)
      family.stem = fmt::format("{}-{}", file_stem(family.name), n);
  }
}

}  // namespace

std::string Family::error_label(std::string const& what) const {
  std::string const of = name.empty() ? "" : " of " + name;
  return what + of + (unit.empty() ? "" : " [" + unit + "]");
}

std::vector<Family> families(std::vector<Estimates> const& rows, std::vector<std::vector<double>> const& final_errors,
                             std::vector<double> const& cpu_seconds) {
  std::vector<std::string> names;
  for (auto const& row : rows) index_of(names, family_name(row));
  std::vector<Family> all;
  for (auto const& name : names) all.push_back(family_of(name, rows, final_errors, cpu_seconds));
  name_files(all);
  return all;
}

std::string distinct_colour(std::size_t index) { return okabe_ito[index % okabe_ito.size()]; }

std::string ordered_colour(double position) {
  constexpr double anchors[][3] = {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 170, 60}, {222, 150, 20}};
  double const at = 4 * std::clamp(position, 0.0, 1.0);
  auto const i = std::min<std::size_t>(static_cast<std::size_t>(at), 3);
  double const f = at - static_cast<double>(i);
  auto const mixed = [&](int c) { return static_cast<int>((1 - f) * anchors[i][c] + f * anchors[i + 1][c]); };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(0), mixed(1), mixed(2));
}

std::string paler(std::string const& colour, double white) {
  auto const mixed = [&](std::size_t at) {
    auto const value = static_cast<double>(std::strtol(colour.substr(at, 2).c_str(), nullptr, 16));
    return static_cast<int>(std::lround(value + white * (255 - value)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(1), mixed(3), mixed(5));
}

double tic_distance(double length) {
  double const rough = length / 4, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (double const nice : {1.0, 2.0, 5.0})
    if (rough <= nice * power) return nice * power;
  return 10 * power;
}

std::string plot_number(double x) { return std::isfinite(x) ? fmt::format("{:.9g}", x) : "NaN"; }

std::string plot_range(double low, double high) {
  if (!(std::isfinite(low) && std::isfinite(high))) return "[0:1]";
  double const room = high > low ? 0 : high == 0 ? 1 : std::abs(high);
  return fmt::format("[{:.9g}:{:.9g}]", low - room, high + room);
}

}  // namespace brouwer
