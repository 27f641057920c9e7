#include "analysis/figures/precision.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace brouwer {
namespace {

double end_of(CellLabels const& cell) { return cell.step * static_cast<double>(cell.steps); }

bool ends_at(CellLabels const& cell, double time) { return std::abs(end_of(cell) - time) < cell.step; }

/// A cell of the family: its labels and the sum of its components' mean squares.
struct Run {
  CellLabels cell;
  double squares = 0, cpu_seconds = 0;
};

std::vector<Run> runs_of(Family const& family) {
  std::vector<Run> runs(family.cells.size());
  for (auto const& row : family.rows) {
    auto& run = runs[row.cell];
    run.cell = row.estimates->cell;
    run.squares += row.estimates->rms_final * row.estimates->rms_final;
    run.cpu_seconds = row.cpu_seconds;
  }
  std::erase_if(runs, [](Run const& run) { return run.cell.steps <= 0 || !(run.squares > 0); });
  return runs;
}

/// The latest of those times at which most runs end.
double common_time(std::vector<Run> const& runs) {
  double best = 0;
  std::ptrdiff_t most = 0;
  for (auto const& candidate : runs) {
    double const time = end_of(candidate.cell);
    auto const there = std::count_if(runs.begin(), runs.end(), [&](Run const& run) { return ends_at(run.cell, time); });
    if (there > most || (there == most && time > best)) {
      most = there;
      best = time;
    }
  }
  return best;
}

CellLabels but_for_step(CellLabels cell) {
  cell.step = 0;
  cell.steps = 0;
  return cell;
}

void add(std::vector<PrecisionLine>& lines, Run const& run) {
  auto const cell = but_for_step(run.cell);
  auto line = std::find_if(lines.begin(), lines.end(), [&](PrecisionLine const& l) { return l.cell == cell; });
  if (line == lines.end()) line = lines.insert(line, {cell, {}});
  line->points.push_back({static_cast<double>(run.cell.steps), std::sqrt(run.squares), run.cpu_seconds});
}

bool is_count(Family const& family) { return family.rows.front().estimates->count.has_value(); }

}  // namespace

bool WorkPrecision::has_cpu_seconds() const {
  return std::any_of(lines.begin(), lines.end(), [](PrecisionLine const& line) {
    return std::any_of(line.points.begin(), line.points.end(), [](auto const& point) { return point.cpu_seconds > 0; });
  });
}

WorkPrecision work_precision(Family const& family) {
  if (is_count(family)) return {};
  auto const runs = runs_of(family);
  WorkPrecision found{common_time(runs), {}};
  for (auto const& run : runs)
    if (ends_at(run.cell, found.time)) add(found.lines, run);
  auto const several = [](PrecisionLine const& line) { return line.points.size() > 1; };
  if (std::none_of(found.lines.begin(), found.lines.end(), several)) return {};
  for (auto& line : found.lines)
    std::sort(line.points.begin(), line.points.end(), [](auto const& a, auto const& b) { return a.steps < b.steps; });
  return found;
}

std::string series_of(std::string const& method) {
  std::string series;
  for (char const c : method)
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) series += c;
  return series;
}

}  // namespace brouwer
