#include "analysis/pages/growth_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/escape.hpp"
#include "analysis/factors.hpp"
#include "analysis/verdict/failures.hpp"
#include "analysis/verdict/verdict.hpp"

namespace brouwer {
namespace {

using Rows = std::vector<Estimates>;

bool always(Estimates const&) { return true; }
bool has_noise(Estimates const& e) { return e.noise.size > 0; }

/// A column of numbers or words; a growth table has it where one of its rows has something to say there.
struct Column {
  char const* plain;
  char const* latex;
  bool left;
  std::string (*cell)(Estimates const&, Notation);
  bool (*says)(Estimates const&) = always;
};

Column const columns[] = {
    {"RMS end", "RMS end", false, [](Estimates const& e, Notation n) { return number(e.rms_final, 2, n); }},
    {"drift β", "drift $\\beta$", false,
     [](Estimates const& e, Notation n) { return measured(e.drift.per_step, e.drift.interval, n); }},
    {"t", "$t$", false, [](Estimates const& e, Notation n) { return number(e.drift.t, 3, n); }},
    {"smallest β", "smallest $\\beta$", false,
     [](Estimates const& e, Notation n) { return number(e.smallest_visible_drift, 2, n); }},
    {"F", "$F$", false, [](Estimates const& e, Notation n) { return number(e.persistence.F, 2, n); }},
    {"diffusion σ", "diffusion $\\sigma$", false,
     [](Estimates const& e, Notation n) { return measured(e.diffusion.per_sqrt_step, e.diffusion.interval, n); }},
    {"noise ν", "noise $\\nu$", false,
     [](Estimates const& e, Notation n) {
       return has_noise(e) ? measured(e.noise.size, e.noise.interval, n) : std::string("–");
     },
     has_noise},
    {"exponent q", "exponent $q$", false,
     [](Estimates const& e, Notation n) { return measured(e.growth.exponent, e.growth.interval, n); }},
    {"verdict", "verdict", true, [](Estimates const& e, Notation) { return to_string(e.verdict); }},
};

bool says_something(Column const& column, Rows const& rows) {
  return std::any_of(rows.begin(), rows.end(), column.says);
}

/// Each once.
std::vector<CellLabels> different_cells(Rows const& rows) {
  std::vector<CellLabels> cells;
  for (auto const& row : rows)
    if (std::find(cells.begin(), cells.end(), row.cell) == cells.end()) cells.push_back(row.cell);
  return cells;
}

template <class Member>
bool all_equal(Rows const& rows, Member member) {
  return std::all_of(rows.begin(), rows.end(), [&](auto const& row) { return row.*member == rows.front().*member; });
}

/// As many came through, of as many.
bool alike_in_members(Rows const& rows) {
  return std::all_of(rows.begin(), rows.end(), [&](auto const& row) { return same_members(row, rows.front()); });
}

/// Members of one study, that were run, whoever of them came through; nothing where that varies.
std::string shared_members(Rows const& rows) {
  if (alike_in_members(rows)) return members_in_words(rows.front());
  auto const run = members_run(rows.front());
  bool const equal = std::all_of(rows.begin(), rows.end(), [&](auto const& row) { return members_run(row) == run; });
  return equal ? fmt::format("{} members", run) : "";
}

/// "39 of 100" where the others were left out.
std::string members_in_cell(Estimates const& e) {
  auto const run = members_run(e);
  return e.members == run ? fmt::format("{}", run) : fmt::format("{} of {}", e.members, run);
}

bool names_quantity(Rows const& rows, CellsAs layout) {
  return layout == CellsAs::groups || !all_equal(rows, &Estimates::quantity);
}

std::string shared_words(Rows const& rows, std::vector<CellLabels> const& cells, CellsAs layout) {
  std::string words = describe(cells.front(), constant_factors(cells));
  auto const add = [&](std::string const& more) { words += (words.empty() ? "" : ", ") + more; };
  if (auto const members = shared_members(rows); !members.empty()) add(members);
  if (!names_quantity(rows, layout) && !rows.front().quantity.empty()) add("error of " + rows.front().quantity);
  return words;
}

std::vector<GrowthTable::Heading> headings(Rows const& rows, Factors const& factors, CellsAs layout, Notation n) {
  std::vector<GrowthTable::Heading> heads;
  if (layout == CellsAs::columns)
    for (auto const* factor : factors) heads.push_back({factor->name, true});
  if (names_quantity(rows, layout)) heads.push_back({"error of", true});
  if (!alike_in_members(rows)) heads.push_back({"members", false});
  for (auto const& column : columns)
    if (says_something(column, rows))
      heads.push_back({n == Notation::plain ? column.plain : column.latex, column.left});
  return heads;
}

std::vector<std::string> words(Estimates const& row, Rows const& rows, Factors const& factors, CellsAs layout,
                               Notation notation) {
  std::vector<std::string> found;
  if (layout == CellsAs::columns)
    for (auto const* factor : factors) found.push_back(factor->level(row.cell));
  if (names_quantity(rows, layout)) found.push_back(row.quantity);
  if (!alike_in_members(rows)) found.push_back(members_in_cell(row));
  for (auto const& column : columns)
    if (says_something(column, rows)) found.push_back(column.cell(row, notation));
  return found;
}

/// Our own runs are timed in steps, an ensemble from a csv in whatever it says.
std::string time_unit(Rows const& rows) { return rows.front().time_unit; }

std::vector<std::string> legend(Rows const& rows, Notation notation) {
  bool const plain = notation == Notation::plain;
  auto const pick = [&](char const* text, char const* latex) { return std::string(plain ? text : latex); };
  std::string const beta = pick("β", "$\\beta$"), unit = time_unit(rows);
  auto const& levels = rows.front().levels;
  std::vector<std::string> lines = {
      fmt::format("{} is the half of a {:g}{} interval.", pick("±", "$\\pm$"), 100 * levels.confidence,
                  pick(" %", "\\,\\%")),
      fmt::format("drift {}: mean slope shared by all members, per {}; {} = {} / its standard error.", beta, unit,
                  pick("t", "$t$"), beta),
      fmt::format(
          "smallest {}: the smallest drift that this ensemble would show with chance {:g}, tested at level {:g}.", beta,
          levels.power, levels.test),
      fmt::format("{}: variance of the members' slopes over a random walk's; 1: random walk, above: persistent slopes, "
                  "below: bounded.",
                  pick("F", "$F$")),
      fmt::format("diffusion {}: size of the random walk, per {}{}.", pick("σ", "$\\sigma$"),
                  pick("√", "square root of a "), unit),
      fmt::format("exponent {}: RMS over members grows as {}; 0.5 is Brouwer's law (random walk), 1 a drift.",
                  pick("q", "$q$"), pick("t^q", "$t^q$")),
  };
  if (std::any_of(rows.begin(), rows.end(), has_noise))
    lines.push_back(
        fmt::format("noise {}: size of the part that does not grow; in such rows {}, t and {} are told apart "
                    "from it by restricted maximum likelihood.",
                    pick("ν", "$\\nu$"), beta, pick("σ", "$\\sigma$")));
  return lines;
}

/// Where many drifts were tested at once.
std::vector<std::string> correction(Rows const& rows) {
  auto const chosen = rows.front().levels.correction.value_or(Correction::none);
  if (chosen == Correction::none) return {};
  return {fmt::format("verdicts: a drift is called seen by its p corrected for all drifts tested beside it ({}).",
                      to_string(chosen))};
}

std::string failure(Estimates const& row) { return left_out(row, " were left out, their error is not finite"); }

/// "energy, casimir": what a cell observed that lacks the same members for the same reasons; of all, "every error".
std::string of_what(Rows const& rows, Estimates const& row) {
  std::size_t observed = 0;
  std::vector<std::string> alike;
  for (auto const& other : rows)
    if (other.cell == row.cell) {
      ++observed;
      if (failure(other) == failure(row)) alike.push_back(other.quantity);
    }
  return observed > 1 && alike.size() == observed ? "every error" : fmt::format("{}", fmt::join(alike, ", "));
}

/// Members unlike the others, row by row: their numbers differ from quantity to quantity.
void add_far_off(std::vector<std::string>& notes, Rows const& rows, Factors const& factors) {
  for (auto const& row : rows)
    if (auto const words = far_off_in_words(row); !words.empty())
      notes.push_back(fmt::format("{}, {}: {}.", short_label(row.cell, factors), row.quantity, words.substr(2)));
}

std::vector<std::string> failures(Rows const& rows, Factors const& factors) {
  std::vector<std::string> notes;
  for (auto const& row : rows) {
    if (row.failed == 0) continue;
    auto const note = fmt::format("{}, {}: {}.", short_label(row.cell, factors), of_what(rows, row), failure(row));
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  }
  return notes;
}

}  // namespace

CellsAs best_layout(Rows const& rows) {
  auto const cells = different_cells(rows);
  return cells.size() > 1 && rows.size() > cells.size() ? CellsAs::groups : CellsAs::columns;
}

GrowthTable growth_table(Rows const& rows, CellsAs layout, Notation notation) {
  if (rows.empty()) return {};
  auto const cells = different_cells(rows);
  auto const factors = varying_factors(cells);
  GrowthTable table{shared_words(rows, cells, layout),
                    headings(rows, factors, layout, notation),
                    {},
                    legend(rows, notation),
                    failures(rows, factors)};
  add_far_off(table.notes, rows, factors);
  for (auto const& line : correction(rows)) table.legend.push_back(line);
  for (auto const& cell : cells) {
    bool first = true;
    for (auto const& row : rows)
      if (row.cell == cell) {
        table.rows.push_back({short_label(cell, factors), words(row, rows, factors, layout, notation), first});
        first = false;
      }
  }
  return table;
}

}  // namespace brouwer
