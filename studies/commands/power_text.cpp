#include "studies/commands/power_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "analysis/numbers.hpp"
#include "studies/commands/progress_line.hpp"

namespace brouwer {
namespace {

bool slopes_persist(PlannedRow const& row) { return row.local.rounding.persistence.p < row.local.levels.test; }

Spread spread_of(PlannedRow const& row) {
  return {row.prediction.diffusion.per_sqrt_step, slopes_persist(row) ? row.prediction.persistence.per_step : 0};
}

std::string line(std::string const& name, std::string const& text) {
  return fmt::format("  {} {}\n", left_aligned(name, 22), text);
}

/// Whole as long as people read it so: "2460", "1.00e6".
std::string whole(double count) { return count < 1e5 ? fmt::format("{:.0f}", count) : number(count, 3); }

/// "128 members over 9.40e6 steps (about 3 min 20 s)"
std::string ensemble_text(PlannedRow const& row, double members, double steps) {
  return fmt::format("{} members over {} steps (about {})", whole(members), whole(steps),
                     duration_text(members * steps * row.seconds_a_member_step));
}

/// With so many members or over so many steps; what no number of steps can do is said.
std::string cost_text(PlannedRow const& row, Question question, double drift) {
  auto const spread = spread_of(row);
  auto const& levels = row.local.levels;
  double const steps = static_cast<double>(row.local.cell.steps), members = static_cast<double>(row.members);
  auto const longer = steps_needed(question, drift, spread, row.members, levels);
  auto const more = members_needed(question, drift, spread, steps, levels);
  std::string const of_steps =
      longer ? ensemble_text(row, members, *longer)
             : fmt::format("{} members over no number of steps, for they keep slopes of their own", row.members);
  std::string const of_members =
      more ? ensemble_text(row, static_cast<double>(*more), steps) : "more members than can be counted";
  return of_steps + ", or " + of_members;
}

std::string slopes_text(PlannedRow const& row) {
  if (!slopes_persist(row)) return "";
  auto const& levels = row.local.levels;
  double const floor = needed_noncentrality(Question::see, row.members, levels) * row.prediction.persistence.per_step /
                       std::sqrt(static_cast<double>(row.members));
  return line("",
              fmt::format("members keep slopes of their own (τ = {}): with {} of them no drift below {} is seen over "
                          "any number of steps; more members help",
                          number(row.prediction.persistence.per_step, 2), row.members, number(floor, 2)));
}

/// A method that does not conserve the quantity moves it by more than rounding does.
std::string method_text(PlannedRow const& row) {
  return line(
      row.local.quantity,
      fmt::format("the method itself errs by {} a step, rounding by {}: what drift of rounding could be seen is "
                  "said of rounding-of-{}",
                  number(row.local.truncation->size, 2), number(row.local.rounding.size, 2), row.local.family));
}

}  // namespace

std::string power_text(PlannedRow const& row, std::optional<double> drift) {
  auto const spread = spread_of(row);
  auto const& levels = row.local.levels;
  if (std::isnan(spread.diffusion)) return method_text(row);
  auto const smallest = [&](Question question) {
    return number(answerable_drift(question, spread, row.members, row.local.cell.steps, levels), 2);
  };
  auto text = line(row.local.quantity,
                   fmt::format("smallest visible drift {} per step, smallest excluded ±{}, with {} members (σ {})",
                               smallest(Question::see), smallest(Question::exclude), row.members,
                               measured(spread.diffusion, row.prediction.diffusion.interval))) +
              slopes_text(row);
  if (!drift || row.members < 2) return text;
  return text +
         line("", fmt::format("to see {} per step: {}", number(*drift, 2), cost_text(row, Question::see, *drift))) +
         line("", fmt::format("to exclude ±{}: {}", number(std::abs(*drift), 2),
                              cost_text(row, Question::exclude, *drift)));
}

}  // namespace brouwer
