#include "analysis/causes/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "analysis/causes/causes.hpp"
#include "analysis/causes/cell_shares.hpp"
#include "analysis/causes/factorial.hpp"
#include "analysis/causes/levels_in_words.hpp"
#include "analysis/factors.hpp"
#include "analysis/growth/inference.hpp"
#include "analysis/power_law.hpp"
#include "analysis/verdict/failures.hpp"

namespace brouwer {
namespace {

/// One cell as it was read.
struct Seen {
  CellLabels cell;
  int bits;
  Estimates estimates;
  std::vector<std::string> names;  // of the members in its rows
  MemberStatistics statistics;
};

std::vector<std::string> names_of(Ensemble const& ensemble) {
  if (!ensemble.names.empty()) return ensemble.names;
  std::vector<std::string> names;
  for (Eigen::Index i = 0; i < ensemble.errors.rows(); ++i) names.push_back(std::to_string(i));
  return names;
}

/// All cells, each read once; slopes are weighed as the nominal cell asks for.
/// @param scale  by which errors are multiplied
std::vector<Seen> look_at(Design const& design, Levels const& levels, double& scale) {
  std::vector<Seen> all;
  Eigen::VectorXd weights;
  for (std::size_t c = 0; c < design.cells.size(); ++c) {
    Ensemble const ensemble = design.ensemble(c);
    Seen seen{design.cells[c].labels, design.cells[c].bits, estimate(ensemble, levels), names_of(ensemble), {}};
    if (all.empty()) {
      weights = slope_weights(seen.estimates);
      scale = exact_scale(largest_magnitude(ensemble.errors));
    } else if (ensemble.times != all.front().estimates.times) {
      throw InputError(fmt::format("{} has other sample times than {}", describe(seen.cell), describe(all[0].cell)));
    }
    seen.statistics = member_statistics(ensemble, weights, seen.estimates, scale);
    all.push_back(std::move(seen));
  }
  return all;
}

/// Why a cell says nothing, or "".
std::string reason_to_leave_out(Seen const& nominal, Seen const& seen) {
  auto const words = changes_in_words(changed_factors(nominal.cell, seen.cell), seen.cell);
  auto const& slope = seen.statistics.slope;
  bool const narrower = seen.bits < nominal.bits;  // of little interest: it is not to cost the others their members
  double const least = (narrower ? 0.9 : 0.5) * static_cast<double>(nominal.estimates.members);
  if (static_cast<double>(seen.estimates.members) < least)
    return fmt::format("{}: {} of {} members failed{}", words, seen.estimates.failed,
                       seen.estimates.failed + seen.estimates.members, and_why(seen.estimates));
  if (narrower && slope.size() > 0 && (slope == slope[0]).all())
    return fmt::format("{}: its members do not differ, their starts are rounded to the same numbers", words);
  return "";
}

/// Takes the cells that say nothing out, with the reasons.
std::vector<std::string> leave_out(std::vector<Seen>& cells) {
  std::vector<std::string> reasons;
  Seen const nominal = cells.front();
  std::erase_if(cells, [&](Seen const& seen) {
    auto const reason = seen.cell == nominal.cell ? "" : reason_to_leave_out(nominal, seen);
    if (!reason.empty()) reasons.push_back(reason);
    return !reason.empty();
  });
  return reasons;
}

/// The rows of each cell whose members are in every cell and set aside in none, in the order of the first.
std::vector<std::vector<Eigen::Index>> common_rows(std::vector<Seen> const& cells) {
  std::vector<std::map<std::string, Eigen::Index>> places;
  for (auto const& cell : cells) {
    auto& place = places.emplace_back();
    for (std::size_t i = 0; i < cell.names.size(); ++i) place[cell.names[i]] = static_cast<Eigen::Index>(i);
    if (cell.estimates.far_off.set_aside)
      for (auto const& name : cell.estimates.far_off.members) place.erase(name);
  }
  std::vector<std::vector<Eigen::Index>> rows(cells.size());
  for (auto const& name : cells.front().names) {
    bool const everywhere =
        std::all_of(places.begin(), places.end(), [&](auto const& place) { return place.contains(name); });
    for (std::size_t c = 0; everywhere && c < cells.size(); ++c) rows[c].push_back(places[c][name]);
  }
  return rows;
}

/// Slopes and walks in the units of the errors again.
Drift unscaled(Drift drift, double scale) {
  return {
      drift.per_step / scale, {drift.interval.low / scale, drift.interval.high / scale}, drift.t, drift.p, drift.share};
}

/// Only where a member is wholly there in each. @return what becomes of the others, or ""
std::string pair_members(std::vector<Seen>& cells) {
  auto const rows = common_rows(cells);
  for (std::size_t c = 0; c < cells.size(); ++c) cells[c].statistics = of_members(cells[c].statistics, rows[c]);
  auto const lost = cells.front().estimates.members - std::ssize(rows.front());
  if (lost == 0) return "";
  return fmt::format("{} of {} members, which failed in another cell or are far from all others in one", lost,
                     cells.front().estimates.members);
}

/// Members of the nominal cell that are not in this one.
std::int64_t lost_members(Seen const& nominal, Seen const& seen) {
  std::set<std::string> const there(seen.names.begin(), seen.names.end());
  return std::count_if(nominal.names.begin(), nominal.names.end(),
                       [&](auto const& name) { return !there.contains(name); });
}

std::vector<ComparedCell> compare_all(std::vector<Seen> const& cells, double scale, double confidence) {
  std::vector<ComparedCell> found;
  for (auto const& seen : std::span(cells).subspan(1)) {
    auto cell = compared(cells.front().statistics, seen.statistics, confidence);
    cell.drift = unscaled(cell.drift, scale);
    cell.cell = seen.cell;
    cell.bits = seen.bits;
    cell.changed = changed_factors(cells.front().cell, seen.cell);
    cell.lost = lost_members(cells.front(), seen);
    found.push_back(std::move(cell));
  }
  return found;
}

/// Directed roundings stand beside the factorial.
bool is_of_factorial(CellLabels const& nominal, CellLabels const& cell) {
  return cell.rounding == nominal.rounding || cell.rounding == other_rounding(nominal.rounding);
}

/// The cell of the factorial that has changed just these factors, or the end.
auto cell_with(std::vector<Seen> const& cells, std::vector<std::string> const& changed) {
  return std::find_if(cells.begin(), cells.end(), [&](Seen const& seen) {
    return changed_factors(cells.front().cell, seen.cell) == changed && is_of_factorial(cells.front().cell, seen.cell);
  });
}

/// The cells of the factorial over these factors, as factorial_effects wants them; none where one is missing.
std::vector<MemberStatistics> factorial_of(std::vector<Seen> const& cells, std::vector<std::string> const& factors) {
  std::vector<MemberStatistics> found;
  for (std::size_t bits = 0; bits < std::size_t{1} << factors.size(); ++bits) {
    std::vector<std::string> changed;
    for (std::size_t j = 0; j < factors.size(); ++j)
      if (bits >> j & 1) changed.push_back(factors[j]);
    auto const cell = cell_with(cells, changed);
    if (cell == cells.end()) return {};
    found.push_back(cell->statistics);
  }
  return found;
}

/// The factors of which a cell is there that has changed nothing else; and their words.
std::vector<std::string> factors_alone(std::vector<Seen> const& cells, std::vector<std::string>& words) {
  std::vector<std::string> factors;
  for (auto const* factor : {"constants", "rounding", "sum"}) {
    auto const alone = cell_with(cells, {factor});
    if (alone == cells.end()) continue;
    factors.emplace_back(factor);
    words.push_back(level_in_words(factor, alone->cell));
  }
  return factors;
}

/// Of the largest factorial that is whole: the last factors are given up where a cell is missing.
std::vector<FactorialEffect> effects_of(std::vector<Seen> const& cells, double scale, double confidence) {
  std::vector<std::string> words;
  auto factors = factors_alone(cells, words);
  auto factorial = factorial_of(cells, factors);
  while (factorial.empty()) {
    factors.pop_back();
    words.pop_back();
    factorial = factorial_of(cells, factors);
  }
  if (factors.empty()) return {};
  auto effects = factorial_effects(factorial, words, confidence);
  for (auto& effect : effects) effect.drift = unscaled(effect.drift, scale);
  return effects;
}

}  // namespace

std::string other_rounding(std::string const& nominal) { return nominal == "stochastic" ? "nearest" : "stochastic"; }

std::optional<Explanation> explain(Design const& design, Levels const& levels) {
  double scale = 1;
  auto cells = look_at(design, levels, scale);
  if (cells.front().estimates.count) return std::nullopt;
  Explanation found;
  found.nominal = cells.front().estimates;
  found.bits = cells.front().bits;
  found.confidence = levels.confidence;
  found.left_out = leave_out(cells);
  if (auto const lost = pair_members(cells); !lost.empty()) found.left_out.push_back(lost);
  found.members = cells.front().statistics.members();
  if (found.members > 1 && cells.size() > 1) {
    double const each = 1 - (1 - levels.confidence) / static_cast<double>(cells.size() - 1);
    found.cells = compare_all(cells, scale, each);
    found.effects = effects_of(cells, scale, levels.confidence);
  }
  name_cause(found);
  return found;
}

}  // namespace brouwer
