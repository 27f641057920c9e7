#pragma once
#include <string>
#include <vector>

#include "analysis/estimates.hpp"
#include "analysis/pages/growth_table.hpp"

namespace brouwer {

enum class TableFormat { text, csv, markdown, latex, json };

/// @throws InputError for an unknown name, with the nearest one
TableFormat table_format(std::string const& name);

/// The growth table of these estimates, ending with a line break. text, markdown and latex are for people (two or three
/// significant digits, intervals as ±, what does not vary stated once, a legend); csv and json hold every field with
/// 17 significant digits. json: an array of rows; a number that is not finite is null there, nan or inf in csv.
/// latex: a `tabular` that needs the package booktabs (and \usepackage[T1]{fontenc} for names with odd characters).
std::string render_table(std::vector<Estimates> const& rows, TableFormat format);

/// Headings and rows in columns of a terminal; as groups they are indented, with a line above each cell.
std::string text_rows(GrowthTable table, CellsAs layout);

/// Headings and rows in Markdown, without what stands above and below them.
std::string markdown_rows(GrowthTable const& table);

}  // namespace brouwer
