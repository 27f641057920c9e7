#include "analysis/expectations/guards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <span>

#include "analysis/expectations/ends.hpp"
#include "analysis/factors.hpp"
#include "analysis/numbers.hpp"
#include "analysis/verdict/failures.hpp"

namespace brouwer {
namespace {

using Complaint = std::optional<std::string>;

// --- of the members' starts and ends --------------------------------------------------------------

Complaint frozen(GuardedCell const& cell) {
  constexpr double least = 4 * std::numeric_limits<double>::epsilon();
  std::size_t members = 0, still = 0;
  for_members(cell.units, [&](MemberEnds const& member) {
    ++members;
    still += member.distance() <= least * member.size();
  });
  if (2 * still <= members) return std::nullopt;
  return fmt::format("{} of {} members end where they began: nothing was integrated, or the start is a rest", still,
                     members);
}

Complaint moving_frame(GuardedCell const& cell) {
  constexpr double most = 1e-3;
  double farthest = 0;
  for_members(cell.units, [&](MemberEnds const& member) { farthest = std::max(farthest, member.barycentre_shift()); });
  if (farthest <= most) return std::nullopt;
  return fmt::format(
      "the barycentre moved by {} of the system's radius: what rounds then are the distances from the origin; start in "
      "the frame of the barycentre (recentre = 1)",
      number(farthest, 2));
}

Complaint copies(std::size_t different, std::size_t members, std::string const& advice) {
  if (members < 2 || 2 * different >= members) return std::nullopt;
  return fmt::format("{} of {} members are copies of others{}: copies add nothing to a sample", members - different,
                     members, advice);
}

Complaint alike(GuardedCell const& cell) {
  std::set<std::vector<double>> different;
  std::size_t members = 0;
  for_members(cell.units, [&](MemberEnds const& member) {
    ++members;
    different.insert(member.both());
  });
  return copies(different.size(), members, " (the perturbation is missing, or below the last digit of the start)");
}

// --- of what was estimated ------------------------------------------------------------------------

Complaint infinite(GuardedCell const& cell) {
  for (auto const& row : cell.rows) {
    if (std::isinf(row.drift.t))
      return fmt::format("t of {} is infinite: all {} members end with the same error, and nothing was averaged",
                         row.quantity, row.members);
    if (std::isinf(row.persistence.F))
      return fmt::format("F of {} is infinite: between its samples every member's error grows by the same amount",
                         row.quantity);
  }
  return std::nullopt;
}

Complaint few_left(GuardedCell const& cell) {
  for (auto const& row : cell.rows)
    if (row.failed > row.members) return fmt::format("{}: {}", row.quantity, left_out(row));
  return std::nullopt;
}

struct Guard {
  char const* claim;
  Complaint (*complaint)(GuardedCell const&);
};
constexpr Guard guards[] = {{"the state has moved", frozen},
                            {"the frame rests", moving_frame},
                            {"the members differ", alike},
                            {"the statistics are finite", infinite},
                            {"most members came through", few_left}};

// --- of another program's numbers -----------------------------------------------------------------

std::size_t different_rows(ErrorMatrix const& errors) {
  std::set<std::vector<double>> rows;
  for (auto const& row : errors.rowwise()) rows.emplace(row.begin(), row.end());
  return rows.size();
}

/// The errors that a drift makes alike are far from 0, in units of their spread; the sizes of a walk's are not: their
/// standard deviation is 0.76 of their mean [√(π/2 − 1), half normal].
bool is_without_sign(ErrorMatrix const& errors) {
  constexpr double least_spread = 0.5;
  Eigen::ArrayXd const last = errors.rightCols<1>();
  if (errors.minCoeff() < 0 || last.mean() == 0) return false;
  double const variance =
      (last - last.mean()).square().sum() / static_cast<double>(std::max<Eigen::Index>(last.size() - 1, 1));
  return std::sqrt(variance) > least_spread * last.mean();
}

}  // namespace

std::vector<Outcome> check_guards(std::vector<GuardedCell> const& cells) {
  std::vector<Outcome> outcomes;
  for (auto const& guard : guards) {
    auto const before = outcomes.size();
    for (auto const& cell : cells)
      if (auto const complaint = guard.complaint(cell))
        outcomes.push_back({false, fmt::format("{}: {}", brief(cell.cell), guard.claim), *complaint});
    if (outcomes.size() == before)
      outcomes.push_back(
          {true, guard.claim, fmt::format("in {} {}", cells.size(), cells.size() == 1 ? "cell" : "cells")});
  }
  return outcomes;
}

std::vector<std::string> doubts(Ensemble const& ensemble) {
  std::vector<std::string> sentences;
  auto const members = static_cast<std::size_t>(ensemble.errors.rows());
  bool const all_zero = (ensemble.errors.array() == 0).all();
  if (auto const complaint = copies(different_rows(ensemble.errors), members, ""); complaint && !all_zero)
    sentences.push_back(*complaint);
  if (!ensemble.count && is_without_sign(ensemble.errors))
    sentences.emplace_back(
        "no error is negative, though they spread as if about 0: of absolute values the RMS and its exponent still "
        "hold, but drift, F and σ do not");
  return sentences;
}

}  // namespace brouwer
