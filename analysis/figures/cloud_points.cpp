#include "analysis/figures/cloud_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>

#include "analysis/escape.hpp"
#include "analysis/figures/figure_family.hpp"

namespace brouwer {
namespace {

constexpr int shades = 24;  ///< a GIF has 256 colours in all

std::size_t component(Orbits const& cell, std::string const& name) {
  auto const found = std::find(cell.names.begin(), cell.names.end(), name);
  if (found == cell.names.end())
    throw InputError(fmt::format("the state has no component '{}'{}", one_line(name), suggestion(name, cell.names)));
  return static_cast<std::size_t>(found - cell.names.begin());
}

/// `count` of 0 … n − 1, evenly, with both ends.
std::vector<std::size_t> evenly(std::size_t n, std::size_t count) {
  std::vector<std::size_t> chosen(std::min(n, count));
  for (std::size_t i = 0; i < chosen.size(); ++i)
    chosen[i] = chosen.size() < 2 ? 0 : (i * (n - 1) + (chosen.size() - 1) / 2) / (chosen.size() - 1);
  return chosen;
}

/// By rank of x at the start, in a few shades.
std::vector<std::string> colours_of(CloudPoints const& points) {
  std::vector<std::size_t> order(points.members.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  auto const start = [&](std::size_t i) {
    double const x = points.px(points.members[i], 0);
    return std::isnan(x) ? std::numeric_limits<double>::infinity() : x;
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return start(a) < start(b); });
  std::vector<std::string> colours(order.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    auto const shade = static_cast<double>(shades * rank / order.size());
    colours[order[rank]] = ordered_colour(shade / (shades - 1));
  }
  return colours;
}

}  // namespace

CloudPoints points_of(Orbits const& cell, Plane const& plane, std::size_t most) {
  CloudPoints points{&cell, component(cell, plane.x), component(cell, plane.y), evenly(cell.members, most), {}};
  points.colours = colours_of(points);
  return points;
}

}  // namespace brouwer
