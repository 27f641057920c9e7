#include "analysis/figures/main_figures.hpp"

#include <algorithm>
#include <set>

#include "analysis/figures/figure_family.hpp"

namespace brouwer {
namespace {

using Words = std::vector<std::string>;

constexpr std::size_t crowded = 8;  ///< more curves than this hide one another

bool is_asked(Family const& family, Words const& quantities) {
  auto const& parts = family.components;
  return quantities.empty() || std::any_of(quantities.begin(), quantities.end(), [&](std::string const& name) {
           return name == family.name || std::find(parts.begin(), parts.end(), name) != parts.end();
         });
}

/// A crowd of curves in time says less than the line of each method over its steps.
std::set<std::string> stems_of(std::vector<Estimates> const& estimates, Words const& quantities) {
  std::set<std::string> stems = {"cloud-still"};
  for (auto const& family : families(estimates, {})) {
    if (!is_asked(family, quantities)) continue;
    bool const swept = !precision_sheet(family).panels.empty();
    if (!swept || family.cells.size() <= crowded)
      for (auto const* kind : {"growth-", "increments-"}) stems.insert(kind + family.stem);
    for (auto const* kind : {"precision-", "count-"}) stems.insert(kind + family.stem);
  }
  return stems;
}

}  // namespace

std::vector<std::filesystem::path> main_figures(Figures const& figures, std::vector<Estimates> const& estimates,
                                                Words const& quantities) {
  auto const stems = stems_of(estimates, quantities);
  std::vector<std::filesystem::path> chosen;
  for (auto const& file : figures.files)
    if (stems.contains(file.stem().string())) chosen.push_back(file);
  return chosen;
}

}  // namespace brouwer
