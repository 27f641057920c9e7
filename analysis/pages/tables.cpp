#include "analysis/pages/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>

#include "analysis/escape.hpp"
#include "analysis/pages/fields.hpp"
#include "analysis/pages/growth_table.hpp"

namespace brouwer {
namespace {

using Words = std::vector<std::string>;

Words heading_words(GrowthTable const& table) {
  Words words;
  for (auto const& heading : table.headings) words.push_back(heading.text);
  return words;
}

std::vector<std::size_t> column_widths(GrowthTable const& table) {
  std::vector<std::size_t> widths(table.headings.size());
  auto const widen = [&](Words const& words) {
    for (std::size_t j = 0; j < words.size(); ++j) widths[j] = std::max(widths[j], display_width(words[j]));
  };
  widen(heading_words(table));
  for (auto const& row : table.rows) widen(row.words);
  return widths;
}

std::string trimmed(std::string line) { return line.substr(0, line.find_last_not_of(' ') + 1) + '\n'; }

std::string joined(Words const& lines, std::string const& prefix = "") {
  std::string text;
  for (auto const& line : lines) text += prefix + line + '\n';
  return text;
}

std::string text_table(std::vector<Estimates> const& rows) {
  auto const layout = best_layout(rows);
  auto const table = growth_table(rows, layout);
  std::string const shared = table.shared.empty() ? "" : one_line(table.shared) + "\n\n";
  return shared + text_rows(table, layout) + '\n' + joined(table.notes) + joined(table.legend);
}

std::string markdown_table(std::vector<Estimates> const& rows) {
  auto const table = growth_table(rows, CellsAs::columns);
  std::string const shared = table.shared.empty() ? "" : markdown_text(table.shared) + "\n\n";
  Words notes;
  for (auto const& note : table.notes) notes.push_back(markdown_text(note));
  return shared + markdown_rows(table) + '\n' + joined(notes, "- ") + joined(table.legend, "- ");
}

/// A number comes in LaTeX's notation already; words do not.
std::string latex_cell(std::string const& word, bool is_words) { return is_words ? latex_text(word) : word; }

std::string latex_row(GrowthTable const& table, Words const& words) {
  Words cells;
  for (std::size_t j = 0; j < words.size(); ++j) cells.push_back(latex_cell(words[j], table.headings[j].left));
  return fmt::format("  {} \\\\\n", fmt::join(cells, " & "));
}

std::string latex_table(std::vector<Estimates> const& rows) {
  auto const layout = best_layout(rows);
  auto const table = growth_table(rows, layout, Notation::latex);
  std::string alignment, body;
  for (auto const& heading : table.headings) alignment += heading.left ? 'l' : 'r';
  for (auto const& row : table.rows) {
    if (layout == CellsAs::groups && row.first_of_cell)
      body += fmt::format("  \\addlinespace\n  \\multicolumn{{{}}}{{l}}{{\\textit{{{}}}}} \\\\\n",
                          table.headings.size(), latex_text(row.cell));
    body += latex_row(table, row.words);
  }
  Words notes;
  for (auto const& note : table.notes) notes.push_back(latex_text(note));
  return fmt::format(
      "% \\usepackage{{booktabs}}\n% {}\n\\begin{{tabular}}{{@{{}}{}@{{}}}}\n  \\toprule\n  {} \\\\\n"
      "  \\midrule\n{}  \\bottomrule\n\\end{{tabular}}\n{}{}",
      one_line(table.shared), alignment, fmt::join(heading_words(table), " & "), body, joined(notes, "% "),
      joined(table.legend, "% "));
}

struct Layout {
  char const* name;
  TableFormat format;
  std::string (*render)(std::vector<Estimates> const&);
};
constexpr Layout layouts[] = {{"text", TableFormat::text, text_table},
                              {"csv", TableFormat::csv, fields_as_csv},
                              {"markdown", TableFormat::markdown, markdown_table},
                              {"latex", TableFormat::latex, latex_table},
                              {"json", TableFormat::json, fields_as_json}};

bool for_people(TableFormat format) { return format != TableFormat::csv && format != TableFormat::json; }

}  // namespace

TableFormat table_format(std::string const& name) {
  Words names;
  for (auto const& layout : layouts) {
    if (name == layout.name) return layout.format;
    names.emplace_back(layout.name);
  }
  throw InputError(fmt::format("there is no table format '{}'{}", one_line(name), suggestion(name, names)));
}

std::string text_rows(GrowthTable table, CellsAs layout) {
  for (auto& row : table.rows) std::transform(row.words.begin(), row.words.end(), row.words.begin(), one_line);
  auto const widths = column_widths(table);
  std::string const indent = layout == CellsAs::groups ? "  " : "";
  auto const line = [&](Words const& words) {
    std::string text = indent;
    for (std::size_t j = 0; j < words.size(); ++j) {
      bool const left = table.headings[j].left;
      text += (left ? left_aligned : right_aligned)(words[j], widths[j]) + (j + 1 < words.size() ? "  " : "");
    }
    return trimmed(text);
  };
  std::string text = line(heading_words(table));
  for (auto const& row : table.rows) {
    if (layout == CellsAs::groups && row.first_of_cell) text += one_line(row.cell) + '\n';
    text += line(row.words);
  }
  return text;
}

std::string markdown_rows(GrowthTable const& table) {
  std::string head, rule, body;
  for (auto const& heading : table.headings) {
    head += "| " + heading.text + ' ';
    rule += heading.left ? "|:---" : "|---:";
  }
  for (auto const& row : table.rows) {
    for (auto const& word : row.words) body += "| " + markdown_text(word) + ' ';
    body += "|\n";
  }
  return head + "|\n" + rule + "|\n" + body;
}

std::string render_table(std::vector<Estimates> const& rows, TableFormat format) {
  if (rows.empty() && for_people(format)) return "There is nothing to tabulate.\n";
  auto const layout =
      std::find_if(std::begin(layouts), std::end(layouts), [&](Layout const& l) { return l.format == format; });
  return layout->render(rows);
}

}  // namespace brouwer
