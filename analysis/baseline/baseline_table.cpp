#include "analysis/baseline/baseline_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/escape.hpp"
#include "analysis/factors.hpp"
#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

using Words = std::vector<std::string>;

struct Column {
  char const* head;
  std::string (*cell)(BaselineRow const&);
};
using R = BaselineRow;
constexpr Column columns[] = {
    {"members", [](R const& r) { return fmt::format("{}", r.members); }},
    {"RMS end", [](R const& r) { return number(r.rms_final, 2); }},
    {"drift β",
     [](R const& r) {
       return measured(r.drift, {r.drift_low, r.drift_high});
     }},
    {"diffusion σ",
     [](R const& r) {
       return measured(r.diffusion, {r.diffusion_low, r.diffusion_high});
     }},
    {"F", [](R const& r) { return number(r.F, 2); }},
    {"exponent q",
     [](R const& r) {
       return measured(r.exponent, {r.exponent_low, r.exponent_high});
     }},
    {"verdict", [](R const& r) { return r.verdict; }},
};

Words head_words() {
  Words words = {"entry"};
  for (auto const& column : columns) words.emplace_back(column.head);
  return words;
}

std::string name_of(BaselineEntry const& entry) {
  return one_line(entry.date.empty() ? entry.label : entry.label + ", " + entry.date);
}

/// A line; one of two words only says that there is nothing new.
Words line_of(BaselineEntry const& entry, R const& row, R const* before) {
  if (before && before->digest == row.digest) return {name_of(entry), "the same bits"};
  Words words = {name_of(entry)};
  for (auto const& column : columns) words.push_back(column.cell(row));
  return words;
}

/// One of each quantity of each cell, as they first appear.
std::vector<R> kinds_of_rows(Baseline const& baseline) {
  std::vector<R> kinds;
  for (auto const& entry : baseline.entries)
    for (auto const& row : entry.rows)
      if (std::none_of(kinds.begin(), kinds.end(), [&](auto const& kind) { return same_place(kind, row); }))
        kinds.push_back(row);
  return kinds;
}

std::vector<Words> lines_of(Baseline const& baseline, R const& kind) {
  std::vector<Words> lines = {head_words()};
  R const* before = nullptr;
  for (auto const& entry : baseline.entries)
    for (auto const& row : entry.rows)
      if (same_place(kind, row)) {
        lines.push_back(line_of(entry, row, before));
        before = &row;
      }
  return lines;
}

std::string aligned(std::vector<Words> const& lines) {
  std::vector<std::size_t> widths(lines.front().size());
  for (auto const& words : lines)
    if (words.size() == widths.size())
      for (std::size_t j = 0; j < words.size(); ++j) widths[j] = std::max(widths[j], display_width(words[j]));
  for (auto const& words : lines) widths[0] = std::max(widths[0], display_width(words[0]));
  std::string text;
  for (auto const& words : lines) {
    std::string line;
    for (std::size_t j = 0; j < words.size(); ++j) line += "  " + left_aligned(words[j], widths[j]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

}  // namespace

std::string history_table(Baseline const& baseline) {
  std::string text = fmt::format("{}: {} {}\n", one_line(baseline.name), baseline.entries.size(),
                                 baseline.entries.size() == 1 ? "entry" : "entries");
  for (auto const& kind : kinds_of_rows(baseline)) {
    auto const cell = brief(kind.cell);
    text += fmt::format("\n{}{}\n{}", one_line(kind.quantity), cell.empty() ? "" : ", " + one_line(cell),
                        aligned(lines_of(baseline, kind)));
  }
  return text;
}

}  // namespace brouwer
