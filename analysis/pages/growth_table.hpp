#pragma once
#include <string>
#include <vector>

#include "analysis/estimates.hpp"
#include "analysis/numbers.hpp"

namespace brouwer {

/// One line of a growth table: one quantity of one cell.
struct GrowthRow {
  std::string cell;                ///< what tells its cell from the others, in words: "elliptic-naive, h = 0.01"
  std::vector<std::string> words;  ///< one a heading
  bool first_of_cell = false;
};

/// What people read of a list of estimates, in any layout: text, Markdown, LaTeX, HTML. Nothing is escaped but
/// numbers and headings, which are in the notation that was asked for.
struct GrowthTable {
  struct Heading {
    std::string text;
    bool left = false;  ///< words are set flush left, numbers flush right
  };
  std::string shared;               ///< the levels that do not vary, once: "rigid_body, double, h = 0.01"
  std::vector<Heading> headings;    ///< factors (if asked for), quantity, numbers, verdict
  std::vector<GrowthRow> rows;      ///< in the order given, cells together
  std::vector<std::string> legend;  ///< what the headings mean, a sentence each
  std::vector<std::string> notes;   ///< members that were left out
};

enum class CellsAs {
  columns,  ///< a column for each factor that varies
  groups,   ///< no such columns: the layout writes GrowthRow::cell above the first row of a cell
};

/// Groups where a cell has several quantities and there are several cells, columns otherwise.
CellsAs best_layout(std::vector<Estimates> const& rows);

GrowthTable growth_table(std::vector<Estimates> const& rows, CellsAs layout, Notation notation = Notation::plain);

}  // namespace brouwer
