#include "analysis/baseline/compare_baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/baseline/study_change.hpp"
#include "analysis/distributions.hpp"
#include "analysis/escape.hpp"
#include "analysis/factors.hpp"
#include "analysis/growth/inference.hpp"
#include "analysis/multiplicity.hpp"
#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

using Of = Effect::Of;

/// How an effect is told, and whether growth of it is a failure.
struct Telling {
  Of of;
  char const* name;
  double BaselineRow::*estimate;
  bool is_ratio;
  bool is_harmful;
};
constexpr Telling tellings[] = {{Of::drift, "drift β", &BaselineRow::slope_mean, false, true},
                                {Of::diffusion, "diffusion σ", &BaselineRow::increment_size, true, true},
                                {Of::slopes, "spread of the slopes", &BaselineRow::slope_spread, true, true},
                                {Of::exponent, "exponent q", &BaselineRow::exponent, false, false}};

Telling const& telling_of(Effect const& effect) {
  return *std::find_if(std::begin(tellings), std::end(tellings), [&](auto const& t) { return t.of == effect.of; });
}

/// The rows of both entries that belong together, and what is asked of them.
struct Matched {
  BaselineRow const* recorded = nullptr;
  BaselineRow const* now = nullptr;
  std::vector<Effect> effects;

  BaselineRow const& any() const { return now ? *now : *recorded; }
};

struct Comparison {
  Levels levels;
  std::string label;
  std::size_t questions = 0;

  bool is_seen(Effect const& effect) const { return effect.p < levels.test; }
};

BaselineRow const* find(std::vector<BaselineRow> const& rows, BaselineRow const& like) {
  auto const found = std::find_if(rows.begin(), rows.end(), [&](auto const& row) { return same_place(row, like); });
  return found == rows.end() ? nullptr : &*found;
}

bool are_the_same_bits(Matched const& rows) { return rows.recorded->digest == rows.now->digest; }

std::vector<Matched> matched(BaselineEntry const& recorded, BaselineEntry const& now) {
  bool const paired = same_members(recorded.study, now.study);
  std::vector<Matched> all;
  for (auto const& row : recorded.rows) {
    auto& rows = all.emplace_back(Matched{&row, find(now.rows, row), {}});
    bool const asked = rows.now && !are_the_same_bits(rows) && std::isnan(row.count_mean);
    if (asked) rows.effects = effects(row, *rows.now, paired);
  }
  for (auto const& row : now.rows)
    if (!find(recorded.rows, row)) all.push_back({nullptr, &row, {}});
  return all;
}

/// Corrects all p-values for their number, which is returned.
std::size_t correct(std::vector<Matched>& all) {
  std::vector<double> p;
  for (auto const& rows : all)
    for (auto const& effect : rows.effects) p.push_back(effect.p);
  auto const corrected = adjusted(p, Correction::holm);
  auto next = corrected.begin();
  for (auto& rows : all)
    for (auto& effect : rows.effects) effect.p = *next++;
  return p.size();
}

// --- words ----------------------------------------------------------------------------------------

/// "by (−0.3 ± 1.2)e-19 per step", or "× 1.02 (0.98 … 1.06)"
std::string amount(Effect const& effect, Matched const& rows, Levels const& levels) {
  double const half = effect.error * student_upper_quantile((1 - levels.confidence) / 2, effect.dof);
  double const low = effect.change - half, high = effect.change + half;
  if (telling_of(effect).is_ratio)
    return fmt::format("× {} ({} … {})", number(std::exp(effect.change), 3), number(std::exp(low), 3),
                       number(std::exp(high), 3));
  std::string const unit = effect.of == Of::drift ? " per " + rows.any().time_unit : "";
  return "by " + measured(effect.change, {low, high}) + unit;
}

/// The smallest change that is seen with the chance levels.power, though all questions are asked at once.
std::string visible(Effect const& effect, Comparison const& comparison) {
  Levels levels = comparison.levels;
  levels.test /= static_cast<double>(comparison.questions);
  double const least = effect.error * visible_noncentrality(effect.dof, levels);
  return telling_of(effect).is_ratio ? "× " + number(std::exp(least), 3) : number(least, 2);
}

/// "drift β is larger: −2.24e-17 then, −2.51e-17 now, by (−2.7 ± 0.2)e-18 per step (p = 3.1e-22)"
std::string seen_in_words(Effect const& effect, Matched const& rows, Levels const& levels) {
  auto const& telling = telling_of(effect);
  return fmt::format("{} is {}: {} then, {} now, {} (p = {})", telling.name, effect.is_larger ? "larger" : "smaller",
                     number(rows.recorded->*telling.estimate, 3), number(rows.now->*telling.estimate, 3),
                     amount(effect, rows, levels), number(effect.p, 2));
}

/// "diffusion σ × 1.01 (0.97 … 1.05), seen from × 1.09 on"
std::string unseen_in_words(Effect const& effect, Matched const& rows, Comparison const& comparison) {
  return fmt::format("{} {}, seen from {} on", telling_of(effect).name, amount(effect, rows, comparison.levels),
                     visible(effect, comparison));
}

std::string failures_in_words(Matched const& rows) {
  if (rows.recorded->failed == rows.now->failed) return "";
  return fmt::format("; members that failed: {} then, {} now", rows.recorded->failed, rows.now->failed);
}

std::string effects_in_words(Matched const& rows, Comparison const& comparison) {
  std::vector<std::string> seen, unseen;
  for (auto const& effect : rows.effects)
    if (comparison.is_seen(effect))
      seen.push_back(seen_in_words(effect, rows, comparison.levels));
    else
      unseen.push_back(unseen_in_words(effect, rows, comparison));
  std::string const equal =
      unseen.empty() ? "" : fmt::format("equal within sampling error: {}", fmt::join(unseen, "; "));
  return fmt::format("{}{}{}", fmt::join(seen, "; "), seen.empty() || equal.empty() ? "" : "; ", equal);
}

std::string found(Matched const& rows, Comparison const& comparison) {
  auto const& [recorded, now, asked] = rows;
  if (are_the_same_bits(rows)) return "the same bits";
  if (!std::isnan(recorded->count_mean))
    return fmt::format("{} in the mean then, {} now", number(recorded->count_mean, 4), number(now->count_mean, 4));
  if (now->members == 0 && recorded->members > 0) return fmt::format("all {} members failed", now->failed);
  if (asked.empty()) return "other bits; two members at two times would be needed to say more";
  return effects_in_words(rows, comparison) + failures_in_words(rows);
}

bool has_grown(Effect const& effect, Comparison const& comparison) {
  return telling_of(effect).is_harmful && effect.is_larger && comparison.is_seen(effect);
}

Outcome outcome_of(Matched const& rows, Comparison const& comparison) {
  auto const& row = rows.any();
  auto const cell = brief(row.cell);
  std::string const what = row.quantity + (cell.empty() ? "" : ", " + cell);
  std::string const claim = fmt::format("{}: not worse than '{}'", what, one_line(comparison.label));
  if (!rows.recorded)
    return {true, what + ": is new", fmt::format("'{}' has nothing to compare", one_line(comparison.label))};
  if (!rows.now) return {false, claim, "it was recorded, and is not there any more"};
  bool const lost = rows.now->members == 0 && rows.recorded->members > 0;
  bool const grown = std::any_of(rows.effects.begin(), rows.effects.end(),
                                 [&](Effect const& effect) { return has_grown(effect, comparison); });
  return {!lost && !grown, claim, found(rows, comparison)};
}

}  // namespace

std::vector<Outcome> compare(BaselineEntry const& recorded, BaselineEntry const& now, Levels const& levels) {
  require_same_question(recorded.study, now.study);
  auto all = matched(recorded, now);
  Comparison const comparison{levels, recorded.label, correct(all)};
  std::vector<Outcome> outcomes;
  for (auto const& rows : all) outcomes.push_back(outcome_of(rows, comparison));
  return outcomes;
}

}  // namespace brouwer
