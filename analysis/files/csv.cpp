#include "analysis/files/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <cctype>
#include <cmath>

#include "analysis/files/csv_forms.hpp"

namespace brouwer {
namespace {

bool is_number(std::string_view field) {
  double value;
  return parse_number(field, value);
}

/// "membr" is a misspelt member; "member7" and "err2" are members' names.
bool is_misspelt(std::string const& name) {
  bool const numbered = std::any_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c); });
  return !numbered && !nearest(name, {"member", "error"}).empty();
}

bool is_long_form(CsvHeader const& header) {
  for (auto const* name : {"member", "error", "value"})
    if (header.find(name)) return true;
  return header.names.size() <= 8 && std::any_of(header.names.begin(), header.names.end(), is_misspelt);
}

CsvHeader header_of(CsvLines const& lines, std::string_view line, CsvFields const& fields) {
  CsvHeader header{{}, delimiter_of(line)};
  if (is_number(fields[0])) return header;
  for (auto const field : fields) header.names.push_back(lower_case(field));
  if (fields.size() < 2)
    lines.complain(fmt::format("expected columns time, member, error (or time and one column a member), found '{}'",
                               shown(fields[0])));
  return header;
}

std::string column_name(CsvHeader const& header, std::size_t column) {
  if (header.names.empty()) return fmt::format("column {}", column + 1);
  return fmt::format("column {} ({})", column + 1, shown(header.names[column]));
}

}  // namespace

std::optional<std::size_t> CsvHeader::find(std::string_view name) const {
  auto const found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return {};
  return static_cast<std::size_t>(found - names.begin());
}

double number_at(CsvLines const& lines, CsvHeader const& header, CsvFields const& fields, std::size_t column) {
  double value = 0;
  if (!parse_number(fields[column], value))
    lines.complain(
        fmt::format("{}: expected a number, found '{}'", column_name(header, column), shown(fields[column])));
  if (!std::isfinite(value))
    lines.complain(fmt::format("{}: expected a finite number in the range of doubles, found '{}'",
                               column_name(header, column), shown(fields[column])));
  return value;
}

double time_at(CsvLines const& lines, CsvHeader const& header, CsvFields const& fields, std::size_t column) {
  double const time = number_at(lines, header, fields, column);
  if (time < 0)
    lines.complain(
        fmt::format("{}: expected a time from 0 on, found '{}'", column_name(header, column), shown(fields[column])));
  return time;
}

void require_fields(CsvLines const& lines, CsvFields const& fields, std::size_t count) {
  if (fields.size() != count)
    lines.complain(fmt::format("expected {} columns as in the first line, found {}", count, fields.size()));
}

void require_zero_start(CsvLines const& lines, double error) {
  if (error != 0)
    lines.complain(
        fmt::format("the error at time 0 is {:g}, and errors are counted from 0 there: subtract it "
                    "(--subtract-start does), or shift the times",
                    error));
}

std::vector<Ensemble> read_csv(std::filesystem::path const& file, FileValues values) {
  CsvLines lines(file);
  std::string_view line;
  if (!lines.next(line))
    throw InputError(lines.file() +
                     ": the file is empty: expected columns time, member, error (or time and one column a "
                     "member)");
  CsvFields fields;
  split(line, delimiter_of(line), fields);
  auto const header = header_of(lines, line, fields);
  std::vector<Ensemble> ensembles;
  if (is_long_form(header))
    ensembles = read_long_form(lines, header, values);
  else
    ensembles.push_back(read_wide_form(lines, header, header.names.empty() ? fields : CsvFields{}, values));
  for (auto& ensemble : ensembles) count_from_start(ensemble, values, lines.file());
  return ensembles;
}

}  // namespace brouwer
