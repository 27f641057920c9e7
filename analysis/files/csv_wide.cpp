// Wide form: one time a line, one column a member.
#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <numeric>

#include "analysis/files/csv_forms.hpp"

namespace brouwer {
namespace {

/// The rows as they come; of errors, without a time 0.
struct WideTable {
  std::size_t columns = 0;       // time and members
  bool starts_from_zero = true;  // the errors at time 0 are to be 0, and are left out
  std::vector<double> times;
  std::vector<std::int64_t> line_numbers;
  std::vector<double> errors;  // [time][member]

  std::size_t members() const { return columns - 1; }
  bool is_kept(double time) const { return time > 0 || !starts_from_zero; }

  void add(CsvLines const& lines, CsvHeader const& header, CsvFields const& fields) {
    require_fields(lines, fields, columns);
    double const time = time_at(lines, header, fields, 0);
    for (std::size_t column = 1; column < columns; ++column) {
      double const error = number_at(lines, header, fields, column);
      if (is_kept(time))
        errors.push_back(error);
      else
        require_zero_start(lines, error);
    }
    if (!is_kept(time)) return;
    times.push_back(time);
    line_numbers.push_back(lines.number());
  }
};

std::vector<std::size_t> by_time(std::vector<double> const& times) {
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
  return order;
}

void require_distinct(CsvLines const& lines, WideTable const& table, std::vector<std::size_t> const& order) {
  auto const same = std::adjacent_find(order.begin(), order.end(),
                                       [&](std::size_t a, std::size_t b) { return table.times[a] == table.times[b]; });
  if (same == order.end()) return;
  throw InputError(
      fmt::format("{}:{}: time {} was given in line {} already (one line a member and time? Then begin the "
                  "file with the header time,member,error)",
                  lines.file(), table.line_numbers[same[1]], table.times[same[1]], table.line_numbers[same[0]]));
}

Ensemble sorted(WideTable const& table, std::vector<std::size_t> const& order) {
  Ensemble ensemble;
  auto const members = static_cast<Eigen::Index>(table.members());
  ensemble.errors.resize(members, std::ssize(order));
  for (std::size_t j = 0; j < order.size(); ++j) {
    double const* row = table.errors.data() + order[j] * table.members();
    ensemble.errors.col(static_cast<Eigen::Index>(j)) = Eigen::Map<Eigen::VectorXd const>(row, members);
    ensemble.times.push_back(table.times[order[j]]);
  }
  return ensemble;
}

/// The unit that the first column's name implies.
std::string time_unit(CsvLines const& lines, CsvHeader const& header) {
  if (header.names.empty()) return time_names[0].unit;
  for (auto const& [name, unit] : time_names)
    if (header.names[0] == name) return unit;
  lines.complain(
      fmt::format("expected 'time' as name of the first column, found '{}'; the columns are time, member, error, "
                  "or time and one column a member",
                  shown(header.names[0])));
}

}  // namespace

Ensemble read_wide_form(CsvLines& lines, CsvHeader const& header, CsvFields first, FileValues values) {
  std::string const unit = time_unit(lines, header);
  WideTable table{header.names.empty() ? first.size() : header.names.size(), values == FileValues::errors, {}, {}, {}};
  if (!first.empty()) table.add(lines, header, first);
  for (std::string_view line; lines.next(line);) {
    split(line, header.delimiter, first);
    table.add(lines, header, first);
  }
  auto const order = by_time(table.times);
  require_distinct(lines, table, order);
  Ensemble ensemble = sorted(table, order);
  require_an_ensemble(ensemble, lines.file());
  ensemble.quantity = ensemble.family = "error";
  ensemble.time_unit = unit;
  if (!header.names.empty()) ensemble.names.assign(header.names.begin() + 1, header.names.end());
  return ensemble;
}

}  // namespace brouwer
