#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/cloud_points.hpp"

namespace brouwer {
namespace {

constexpr double much_larger = 3;      ///< a cloud that is larger by this factor than tamer ones runs away
constexpr double most_beyond = 1.5;    ///< how far axes follow it, in half widths of the tame ones
constexpr double least_aspect = 0.75;  ///< of the shorter side of a panel to the longer

struct Box {
  Interval x{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}, y = x;
  double size() const { return std::hypot(x.high - x.low, y.high - y.low); }
};

void widen(Interval& range, double value) { range = {std::min(range.low, value), std::max(range.high, value)}; }

Box box_of(CloudPoints const& points) {
  Box box;
  for (auto const member : points.members)
    for (std::size_t time = 0; time < points.of->times.size(); ++time) {
      double const x = points.px(member, time), y = points.py(member, time);
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      widen(box.x, x);
      widen(box.y, y);
    }
  return box;
}

/// `range` as far as a multiple of the tame one allows.
Interval followed(Interval tame, Interval range) {
  double const middle = (tame.low + tame.high) / 2, reach = most_beyond * (tame.high - tame.low) / 2;
  auto const within = [&](double end) { return std::clamp(end, middle - reach, middle + reach); };
  return {within(range.low), within(range.high)};
}

Box joined(Box a, Box const& b) {
  for (double const end : {b.x.low, b.x.high}) widen(a.x, end);
  for (double const end : {b.y.low, b.y.high}) widen(a.y, end);
  return a;
}

/// From the smallest cloud to the largest: those that are not much larger than all before them are tame and have their
/// room, the others have as much as the tame ones leave them.
Box common_box(std::vector<CloudPoints> const& clouds) {
  std::vector<Box> boxes;
  for (auto const& points : clouds)
    if (auto const box = box_of(points); box.x.low <= box.x.high) boxes.push_back(box);
  if (boxes.empty()) return {{0, 1}, {0, 1}};
  std::sort(boxes.begin(), boxes.end(), [](auto const& a, auto const& b) { return a.size() < b.size(); });
  Box tame = boxes.front();
  auto wild = boxes.begin() + 1;
  for (; wild != boxes.end() && wild->size() <= much_larger * tame.size(); ++wild) tame = joined(tame, *wild);
  if (wild == boxes.end()) return tame;
  return joined(tame, {followed(tame.x, boxes.back().x), followed(tame.y, boxes.back().y)});
}

Interval at_least(Interval range, double width) {
  double const missing = std::max(width - (range.high - range.low), 0.0) / 2;
  return {range.low - missing, range.high + missing};
}

}  // namespace

/// With room around, and a panel that is no slit.
CloudAxes axes_of(std::vector<CloudPoints> const& clouds) {
  auto const box = common_box(clouds);
  double const longest = std::max(box.x.high - box.x.low, box.y.high - box.y.low);
  double const scale = std::max({std::abs(box.x.high), std::abs(box.y.high), 1.0});
  double const side = longest > 0 ? longest : scale, room = 0.06 * side;
  return {at_least({box.x.low - room, box.x.high + room}, least_aspect * side),
          at_least({box.y.low - room, box.y.high + room}, least_aspect * side)};
}

}  // namespace brouwer
