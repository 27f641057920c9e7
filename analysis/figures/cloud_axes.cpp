#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/figures/cloud_points.hpp"

namespace brouwer {
namespace {

constexpr double much_larger = 3;      ///< a cloud that is larger by this factor than tamer ones runs away
constexpr double far_off = 5;          ///< a member that goes further than others by this factor leaves them
constexpr double most_beyond = 1.5;    ///< how far axes follow it, in half widths of the tame ones
constexpr double least_aspect = 0.75;  ///< of the shorter side of a panel to the longer

struct Box {
  Interval x{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}, y = x;
  double size() const { return std::hypot(x.high - x.low, y.high - y.low); }
};

void widen(Interval& range, double value) { range = {std::min(range.low, value), std::max(range.high, value)}; }

void widen(Box& box, double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y)) return;
  widen(box.x, x);
  widen(box.y, y);
}

// --- one cloud ------------------------------------------------------------------------------------

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  auto const middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Of the members' starts.
double start_in(CloudPoints const& points, double (CloudPoints::*coordinate)(std::size_t, std::size_t) const) {
  std::vector<double> starts;
  for (auto const member : points.members)
    if (double const x = (points.*coordinate)(member, 0); std::isfinite(x)) starts.push_back(x);
  return median(std::move(starts));
}

/// How far each member goes from where the cloud starts; infinity where a number overflowed, without failing.
std::vector<double> reaches_of(CloudPoints const& points) {
  double const x = start_in(points, &CloudPoints::px), y = start_in(points, &CloudPoints::py);
  std::vector<double> reaches;
  for (auto const member : points.members) {
    double reach = 0;
    for (std::size_t time = 0; time < points.of->times.size() && !points.ended(member, time); ++time)
      reach = std::max(reach, std::hypot(points.px(member, time) - x, points.py(member, time) - y));
    reaches.push_back(reach);
  }
  return reaches;
}

/// Half of the members that came through go no further than this; of all members where none came through: those that
/// fail are often those that run away.
double usual_reach(CloudPoints const& points, std::vector<double> const& reaches) {
  std::vector<double> moved, through;
  for (std::size_t i = 0; i < reaches.size(); ++i) {
    if (!(reaches[i] > 0)) continue;
    moved.push_back(reaches[i]);
    if (!points.ended(points.members[i], points.of->times.size() - 1)) through.push_back(reaches[i]);
  }
  return median(through.empty() ? moved : through);
}

/// What a cloud fills, and what it fills without those members that leave all others.
struct Extent {
  Box tame, all;
};

/// The start of every member has its room.
Extent extent_of(CloudPoints const& points) {
  auto const reaches = reaches_of(points);
  double const far = far_off * usual_reach(points, reaches);
  Extent extent;
  for (std::size_t i = 0; i < reaches.size(); ++i)
    for (std::size_t time = 0; time < points.of->times.size(); ++time) {
      double const x = points.px(points.members[i], time), y = points.py(points.members[i], time);
      widen(extent.all, x, y);
      if (time == 0 || reaches[i] <= far) widen(extent.tame, x, y);
    }
  return extent;
}

// --- all of them ----------------------------------------------------------------------------------

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

bool holds(Interval range, Interval part) { return range.low <= part.low && part.high <= range.high; }

/// From the smallest cloud to the largest: those that are not much larger than all before them are tame and have their
/// room, the others, and single members far off, have as much as the tame ones leave them.
Box common_box(std::vector<CloudPoints> const& clouds) {
  std::vector<Box> boxes;
  Box all;
  for (auto const& points : clouds)
    if (auto const extent = extent_of(points); extent.tame.x.low <= extent.tame.x.high) {
      boxes.push_back(extent.tame);
      all = joined(all, extent.all);
    }
  if (boxes.empty()) return {{0, 1}, {0, 1}};
  std::sort(boxes.begin(), boxes.end(), [](auto const& a, auto const& b) { return a.size() < b.size(); });
  Box tame = boxes.front();
  for (auto next = boxes.begin() + 1; next != boxes.end() && next->size() <= much_larger * tame.size(); ++next)
    tame = joined(tame, *next);
  if (holds(tame.x, all.x) && holds(tame.y, all.y)) return tame;
  return joined(tame, {followed(tame.x, all.x), followed(tame.y, all.y)});
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
