// Long form: one error a line, with columns time, member, error and perhaps labels of separate ensembles.
#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <deque>
#include <map>

#include "analysis/files/csv_forms.hpp"
#include "analysis/files/csv_long_table.hpp"

namespace brouwer {
namespace {

/// Columns that tell ensembles apart, and where their text goes.
struct Label {
  char const* name;
  std::string& (*of)(Ensemble&);
};
constexpr Label labels[] = {
    {"quantity", [](Ensemble& e) -> std::string& { return e.quantity; }},
    {"system", [](Ensemble& e) -> std::string& { return e.cell.system; }},
    {"method", [](Ensemble& e) -> std::string& { return e.cell.method; }},
    {"arithmetic", [](Ensemble& e) -> std::string& { return e.cell.arithmetic; }},
};

struct LabelColumn {
  Label const* label;
  std::size_t column;
};

struct LongColumns {
  std::size_t time = 0, member = 0, error = 0;
  std::string time_unit;
  std::vector<LabelColumn> labels;
  bool starts_from_zero = true;  // the errors at time 0 are to be 0, and are left out
};

std::string joined(std::vector<std::string> const& names) {
  std::string text;
  for (auto const& name : names) text += (text.empty() ? "" : ", ") + shown(name);
  return text;
}

std::size_t required_column(CsvLines const& lines, CsvHeader const& header, std::string const& name) {
  auto const found = header.find(name);
  if (!found) {
    auto const near = nearest(name, header.names);
    lines.complain(fmt::format("expected a column '{}', found {}", name,
                               near.empty() ? "only " + joined(header.names) : fmt::format("'{}'", shown(near))));
  }
  if (std::count(header.names.begin(), header.names.end(), name) > 1)
    lines.complain(fmt::format("there are two columns '{}'", name));
  return *found;
}

/// Values may be called so; as errors they are taken only where they are said to be some.
std::size_t error_column(CsvLines const& lines, CsvHeader const& header, FileValues values) {
  if (!header.find("value")) return required_column(lines, header, "error");
  if (values == FileValues::errors && !header.find("error"))
    lines.complain(
        "expected a column 'error', found 'value': --subtract-start or --relative-to-start makes errors of values");
  return required_column(lines, header, values == FileValues::errors ? "error" : "value");
}

LongColumns columns_of(CsvLines const& lines, CsvHeader const& header, FileValues values) {
  LongColumns columns;
  TimeName const* time = std::find_if(std::begin(time_names), std::end(time_names),
                                      [&](TimeName const& t) { return header.find(t.name).has_value(); });
  if (time == std::end(time_names)) time = time_names;
  columns.time = required_column(lines, header, time->name);
  columns.time_unit = time->unit;
  columns.member = required_column(lines, header, "member");
  columns.starts_from_zero = values == FileValues::errors;
  columns.error = error_column(lines, header, values);
  for (auto const& label : labels)
    if (auto const column = header.find(label.name)) columns.labels.push_back({&label, *column});
  return columns;
}

/// The tables of the ensembles in a file, in order of appearance.
class LongTables {
 public:
  explicit LongTables(LongColumns const& columns) : columns_(columns) {}

  LongTable& of(CsvFields const& fields) {
    key_.clear();
    for (auto const& [label, column] : columns_.labels) (key_ += fields[column]) += '\x1f';
    if (current_ && key_ == current_key_) return *current_;
    auto const [entry, is_new] = index_.try_emplace(key_, tables_.size());
    if (is_new) tables_.emplace_back(labelled(fields));
    current_key_ = key_;
    return *(current_ = &tables_[entry->second]);
  }

  std::deque<LongTable>& tables() { return tables_; }

 private:
  Ensemble labelled(CsvFields const& fields) const {
    Ensemble ensemble;
    ensemble.time_unit = columns_.time_unit;
    for (auto const& [label, column] : columns_.labels) label->of(ensemble) = fields[column];
    return ensemble;
  }

  LongColumns const& columns_;
  std::map<std::string, std::size_t> index_;
  std::deque<LongTable> tables_;
  std::string key_, current_key_;
  LongTable* current_ = nullptr;
};

void add_line(CsvLines const& lines, CsvHeader const& header, LongColumns const& columns, CsvFields const& fields,
              LongTables& tables) {
  require_fields(lines, fields, header.names.size());
  double const time = time_at(lines, header, fields, columns.time);
  double const error = number_at(lines, header, fields, columns.error);
  if (fields[columns.member].empty()) lines.complain("the member is missing: expected its number or name");
  if (time > 0 || !columns.starts_from_zero)
    tables.of(fields).add(fields[columns.member], time, error, lines.number());
  else
    require_zero_start(lines, error);
}

}  // namespace

std::vector<Ensemble> read_long_form(CsvLines& lines, CsvHeader const& header, FileValues values) {
  auto const columns = columns_of(lines, header, values);
  LongTables tables(columns);
  CsvFields fields;
  for (std::string_view line; lines.next(line);) {
    split(line, header.delimiter, fields);
    add_line(lines, header, columns, fields, tables);
  }
  if (tables.tables().empty()) throw InputError(lines.file() + ": there is no error at a time above 0");
  std::vector<Ensemble> ensembles;
  for (; !tables.tables().empty(); tables.tables().pop_front())
    ensembles.push_back(tables.tables().front().finish(lines));
  return ensembles;
}

}  // namespace brouwer
