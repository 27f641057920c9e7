#include "analysis/growth/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <cmath>
#include <numeric>
#include <set>

#include "analysis/power_law.hpp"

namespace brouwer {
namespace {

constexpr std::size_t fewest_steps = 3;

/// What two cells of a sweep may differ in is taken away: the step, and with it their number of steps.
CellLabels without_step(CellLabels cell) {
  cell.step = 0;
  cell.steps = 0;
  return cell;
}

void require_a_sweep(std::vector<Ensemble> const& cells) {
  std::set<double> steps;
  for (auto const& cell : cells) {
    steps.insert(cell.cell.step);
    if (!(cell.cell.step > 0))
      throw InputError(fmt::format("the law of h needs steps h > 0, not {:g}", cell.cell.step));
    if (without_step(cell.cell) != without_step(cells[0].cell) || cell.quantity != cells[0].quantity)
      throw InputError(
          fmt::format("the law of h is fitted to cells that differ in their step alone, but {} of {} and {} of "
                      "{} differ otherwise",
                      cells[0].quantity, cells[0].cell.method, cell.quantity, cell.cell.method));
  }
  if (steps.size() < fewest_steps)
    throw InputError(
        fmt::format("the law of h needs at least {} different steps, and there are {}", fewest_steps, steps.size()));
}

std::int64_t common_members(std::vector<Ensemble> const& cells) {
  std::int64_t members = cells[0].errors.rows();
  for (auto const& cell : cells) members = std::min<std::int64_t>(members, cell.errors.rows());
  if (members < 2)
    throw InputError(fmt::format("{}: the law of h needs at least 2 members that all cells have", cells[0].quantity));
  return members;
}

Eigen::Index places(std::vector<Ensemble> const& cells) {
  return std::accumulate(cells.begin(), cells.end(), Eigen::Index{0},
                         [](Eigen::Index sum, Ensemble const& cell) { return sum + cell.errors.cols(); });
}

/// Rows (1, log h, log t) for every sample time of every cell.
Eigen::MatrixXd design(std::vector<Ensemble> const& cells) {
  Eigen::MatrixXd rows(places(cells), 3);
  Eigen::Index place = 0;
  for (auto const& cell : cells)
    for (double const time : cell.times)
      rows.row(place++) << 1, std::log(cell.cell.step), std::log(time) + std::log(cell.cell.step);
  return rows;
}

/// One scale for all cells, so that their errors stay comparable.
double common_scale(std::vector<Ensemble> const& cells) {
  double largest = 0;
  for (auto const& cell : cells) largest = std::max(largest, largest_magnitude(cell.errors));
  return exact_scale(largest);
}

ErrorMatrix joint_squares(std::vector<Ensemble> const& cells, std::int64_t members, double scale) {
  ErrorMatrix squares(std::min(members, most_groups), places(cells));
  Eigen::Index place = 0;
  for (auto const& cell : cells) {
    squares.middleCols(place, cell.errors.cols()) = grouped_squares(cell.errors, members, scale);
    place += cell.errors.cols();
  }
  return squares;
}

}  // namespace

SweepLaw fit_sweep(std::vector<Ensemble> const& cells, Levels const& levels) {
  require_a_sweep(cells);
  auto const members = common_members(cells);
  double const scale = common_scale(cells);
  auto const law = fit_power_law(joint_squares(cells, members, scale), members, design(cells), levels.confidence);
  if (!law.coefficients.allFinite())
    throw InputError(
        fmt::format("{}: too few non-zero errors at different times to fit a law of h and t", cells[0].quantity));
  return {law.coefficients[1],
          law.intervals[1],
          law.coefficients[2],
          law.intervals[2],
          std::exp(law.coefficients[0]) / scale,
          cells.size()};
}

}  // namespace brouwer
