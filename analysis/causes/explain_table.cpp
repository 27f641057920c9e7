#include "analysis/causes/explain_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/causes/causes.hpp"
#include "analysis/causes/levels_in_words.hpp"
#include "analysis/causes/remainder.hpp"
#include "analysis/escape.hpp"
#include "analysis/factors.hpp"
#include "analysis/numbers.hpp"
#include "analysis/pages/tables.hpp"

namespace brouwer {
namespace {

using Words = std::vector<std::string>;

/// As ± where the interval is nearly symmetric, else from … to; alone where the interval would not show.
std::string in_units(double unit, Share const& share) {
  if (std::isnan(share.value)) return "–";
  double const value = unit * share.value, low = unit * share.interval.low, high = unit * share.interval.high;
  if (!std::isfinite(low) || !std::isfinite(high)) return "any";
  if (high - low < 2e-3 * std::abs(value) || high == low) return number(value, 4);
  bool const skewed = high - value > 1.5 * (value - low) || value - low > 1.5 * (high - value);
  return skewed ? fmt::format("{} … {}", number(low, 2), number(high, 2)) : measured(value, {low, high});
}

std::string percent(Share const& share) { return in_units(100, share); }
std::string factor(Share const& share) { return in_units(1, share); }

std::string remainder(Share const& share) { return std::isnan(share.value) ? "–" : in_a_word(share); }

bool has_slopes(Explanation const& e) {
  return e.subject == Subject::slopes || e.nominal.persistence.p < e.nominal.levels.test;
}

/// A column of the table of cells.
struct CellColumn {
  char const* heading;
  bool left;
  std::string (*word)(ComparedCell const&, Explanation const&);
};
constexpr CellColumn cell_columns[] = {
    {"with", true, [](ComparedCell const& c, Explanation const&) { return changes_in_words(c.changed, c.cell); }},
    {"drift β", false,
     [](ComparedCell const& c, Explanation const&) { return measured(c.drift.per_step, c.drift.interval); }},
    {"β/β₀, %", false,
     [](ComparedCell const& c, Explanation const& e) {
       return e.subject == Subject::drift ? percent(c.drift_left) : std::string("–");
     }},
    {"τ²/τ₀², %", false,
     [](ComparedCell const& c, Explanation const& e) {
       return has_slopes(e) ? percent(c.slopes_left) : std::string("–");
     }},
    {"RMS/RMS₀", false, [](ComparedCell const& c, Explanation const&) { return factor(c.size_left); }},
    {"σ/σ₀", false, [](ComparedCell const& c, Explanation const&) { return factor(c.diffusion_left); }},
    {"", true,
     [](ComparedCell const& c, Explanation const& e) {
       return e.subject == Subject::nothing ? std::string() : remainder(left_of(c, e.subject));
     }},
    {"lost", false,
     [](ComparedCell const& c, Explanation const&) { return c.lost > 0 ? std::to_string(c.lost) : std::string(); }},
};

std::string p_word(double p) { return p < 1e-300 ? "< 1e-300" : number(p, 2); }

struct EffectColumn {
  char const* heading;
  bool left;
  std::string (*word)(FactorialEffect const&, Explanation const&);
};
constexpr EffectColumn effect_columns[] = {
    {"effect of", true,
     [](FactorialEffect const& f, Explanation const&) { return fmt::format("{}", fmt::join(f.factors, " × ")); }},
    {"on β", false,
     [](FactorialEffect const& f, Explanation const&) { return measured(f.drift.per_step, f.drift.interval); }},
    {"p", false, [](FactorialEffect const& f, Explanation const&) { return p_word(f.drift.p); }},
    {"share of β₀", false,
     [](FactorialEffect const& f, Explanation const& e) {
       return e.subject == Subject::drift ? number(f.drift.share, 2) : std::string("–");
     }},
    {"on τ², % of τ₀²", false,
     [](FactorialEffect const& f, Explanation const& e) {
       return has_slopes(e) ? percent(f.slopes) : std::string("–");
     }},
    {"p", false,
     [](FactorialEffect const& f, Explanation const& e) {
       return has_slopes(e) ? p_word(f.p_slopes) : std::string("–");
     }},
    {"on σ, ×", false, [](FactorialEffect const& f, Explanation const&) { return factor(f.diffusion); }},
    {"p", false, [](FactorialEffect const& f, Explanation const&) { return p_word(f.p_diffusion); }},
};

/// Columns in which something stands.
template <class Row, class Columns>
GrowthTable table_of(std::vector<Row> const& rows, Columns const& columns, Explanation const& e) {
  GrowthTable table;
  for (auto const& column : columns) {
    bool const says_something = std::any_of(rows.begin(), rows.end(), [&](Row const& row) {
      auto const word = column.word(row, e);
      return !word.empty() && word != "–";
    });
    if (!says_something) continue;
    table.headings.push_back({column.heading, column.left});
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (table.rows.size() <= i) table.rows.push_back({"", {}, false});
      table.rows[i].words.push_back(column.word(rows[i], e));
    }
  }
  return table;
}

std::string nominal_line(Explanation const& e) {
  auto const& n = e.nominal;
  std::string const failed = n.failed > 0 ? fmt::format(", {} failed", n.failed) : "";
  return fmt::format("{} members{}, {} compared; {} steps; β₀ = {} per {} ({}), σ₀ = {}, F = {}: {}", n.members, failed,
                     e.members, n.cell.steps, measured(n.drift.per_step, n.drift.interval), n.time_unit,
                     probability(n.drift.p), measured(n.diffusion.per_sqrt_step, n.diffusion.interval),
                     number(n.persistence.F, 2), to_string(n.verdict));
}

std::string shared_line(std::vector<Explanation> const& all) {
  std::vector<CellLabels> cells;
  for (auto const& e : all) cells.push_back(e.nominal.cell);
  return describe(cells.front(), constant_factors(cells));
}

/// What the tables above need.
Words legend_of(std::vector<Explanation> const& all) {
  auto const any = [&](auto is) { return std::any_of(all.begin(), all.end(), is); };
  Words legend;
  if (any([](Explanation const& e) { return !e.cells.empty(); }))
    legend.push_back(fmt::format(
        "β₀, τ₀, σ₀, RMS₀ are of the cell as the study has it; the others are compared with it member by member. σ "
        "is of increments about each member's line. Intervals of all cells of one table hold together with "
        "{:g} %; ± is half of one, 'any' one without ends.",
        100 * all.front().confidence));
  if (any([](Explanation const& e) { return e.subject != Subject::nothing; }))
    legend.emplace_back(
        "gone, falls: less than half of it is left; stays, shrinks, grows, turns (its sign): more than half; ?: not "
        "resolved.");
  if (any([](Explanation const& e) { return !e.effects.empty(); }))
    legend.push_back(fmt::format(
        "An effect is the mean change over the factorial's cells when the factor is changed, × an interaction; ± is "
        "half a {:g} % interval of its own, p after Holm's correction.",
        100 * all.front().confidence));
  return legend;
}

/// What no cell was run for, once.
Words not_run(std::vector<Explanation> const& all) {
  Words reasons;
  for (auto const& e : all)
    for (auto const& reason : e.not_run)
      if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end()) reasons.push_back(reason);
  return reasons;
}

std::string block(Explanation const& e, std::vector<Explanation> const& all) {
  std::string text = fmt::format("\n{}\n  {}\n", subject_line(e, all), nominal_line(e));
  if (!e.cells.empty()) text += text_rows(table_of(e.cells, cell_columns, e), CellsAs::groups);
  if (!e.effects.empty()) text += "\n" + text_rows(table_of(e.effects, effect_columns, e), CellsAs::groups);
  for (auto const& sentence : e.left_out) text += fmt::format("  left out: {}\n", sentence);
  return text + "  " + e.sentence + '\n';
}

std::string markdown_block(Explanation const& e, std::vector<Explanation> const& all) {
  std::string text = fmt::format("\n### {}\n\n**{}**\n\n{}\n", markdown_text(subject_line(e, all)),
                                 markdown_text(e.sentence), markdown_text(nominal_line(e)));
  if (!e.cells.empty()) text += "\n" + markdown_rows(table_of(e.cells, cell_columns, e));
  if (!e.effects.empty()) text += "\n" + markdown_rows(table_of(e.effects, effect_columns, e));
  for (auto const& sentence : e.left_out) text += fmt::format("\n- left out: {}\n", markdown_text(sentence));
  return text;
}

}  // namespace

std::string subject_line(Explanation const& e, std::vector<Explanation> const& all) {
  std::vector<CellLabels> cells;
  for (auto const& other : all) cells.push_back(other.nominal.cell);
  auto const factors = varying_factors(cells);
  return one_line(e.nominal.quantity + (factors.empty() ? "" : ", " + describe(e.nominal.cell, factors)));
}

std::string explain_text(std::vector<Explanation> const& all) {
  if (all.empty()) return "There is nothing to explain.\n";
  std::string text = one_line(shared_line(all)) + '\n';
  for (auto const& e : all) text += block(e, all);
  text += '\n';
  for (auto const& reason : not_run(all)) text += fmt::format("Not run: {}.\n", one_line(reason));
  for (auto const& sentence : legend_of(all)) text += sentence + '\n';
  return text;
}

std::string explain_markdown(std::vector<Explanation> const& all) {
  if (all.empty()) return "There is nothing to explain.\n";
  std::string text = markdown_text(shared_line(all)) + '\n';
  for (auto const& e : all) text += markdown_block(e, all);
  text += '\n';
  for (auto const& reason : not_run(all)) text += fmt::format("- Not run: {}.\n", markdown_text(reason));
  for (auto const& sentence : legend_of(all)) text += "- " + sentence + '\n';
  return text;
}

}  // namespace brouwer
