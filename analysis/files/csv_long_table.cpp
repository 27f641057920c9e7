#include "analysis/files/csv_long_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "analysis/files/csv_forms.hpp"

namespace brouwer {
namespace {

/// The place of each item in the sorted order.
template <class T, class Less>
std::vector<Eigen::Index> ranks(std::vector<T> const& items, Less less) {
  std::vector<std::size_t> order(items.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return less(items[a], items[b]); });
  std::vector<Eigen::Index> rank(items.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<Eigen::Index>(i);
  return rank;
}

/// 9 before 10, numbers before names, names as in a dictionary.
bool member_before(std::string const& a, std::string const& b) {
  double x = 0, y = 0;
  bool const a_is_number = parse_number(a, x) && !std::isnan(x), b_is_number = parse_number(b, y) && !std::isnan(y);
  if (a_is_number != b_is_number) return a_is_number;
  return a_is_number && x != y ? x < y : a < b;
}

}  // namespace

std::string LongTable::of() const {
  return ensemble_.quantity.empty() ? "" : fmt::format(" of '{}'", shown(ensemble_.quantity));
}

Ensemble LongTable::finish(CsvLines const& lines) {
  if (observations_.size() < members_.names().size() * times_.times().size()) complain_of_a_hole(lines);
  fill(lines);
  ensemble_.times = times_.times();
  std::sort(ensemble_.times.begin(), ensemble_.times.end());
  require_an_ensemble(ensemble_, lines.file(), of());
  if (ensemble_.quantity.empty()) ensemble_.quantity = "error";
  ensemble_.family = ensemble_.quantity;
  return std::move(ensemble_);
}

void LongTable::fill(CsvLines const& lines) {
  auto const row = ranks(members_.names(), member_before);
  auto const column = ranks(times_.times(), std::less<>{});
  ensemble_.names.resize(row.size());
  for (std::size_t i = 0; i < row.size(); ++i) ensemble_.names[static_cast<std::size_t>(row[i])] = members_.names()[i];
  ensemble_.errors.setConstant(std::ssize(row), std::ssize(column), std::numeric_limits<double>::quiet_NaN());
  for (auto const& o : observations_) {
    double& place = ensemble_.errors(row[o.member], column[o.time]);
    if (!std::isnan(place)) complain_of_a_duplicate(lines, o);
    place = o.error;
  }
}

/// A member that was seen fewer times than there are times lacks one; there is such a member.
void LongTable::complain_of_a_hole(CsvLines const& lines) const {
  std::vector<std::size_t> seen(members_.names().size());
  for (auto const& o : observations_) ++seen[o.member];
  auto const member = static_cast<std::size_t>(std::min_element(seen.begin(), seen.end()) - seen.begin());
  std::vector<char> has(times_.times().size());
  std::int64_t line = 0;
  for (auto const& o : observations_)
    if (o.member == member) has[o.time] = 1, line = o.line;
  auto const time = static_cast<std::size_t>(std::find(has.begin(), has.end(), 0) - has.begin());
  throw InputError(
      fmt::format("{}:{}: member '{}'{} has no error at time {}: every member needs one at each of the {} times",
                  lines.file(), line, shown(members_.names()[member]), of(), times_.times()[time], has.size()));
}

void LongTable::complain_of_a_duplicate(CsvLines const& lines, Observation const& again) const {
  auto const first = std::find_if(observations_.begin(), observations_.end(), [&](Observation const& o) {
    return o.member == again.member && o.time == again.time;
  });
  throw InputError(fmt::format(
      "{}:{}: member '{}'{} has an error at time {} in line {} already (columns that tell "
      "ensembles apart are quantity, system, method and arithmetic)",
      lines.file(), again.line, shown(members_.names()[again.member]), of(), times_.times()[again.time], first->line));
}

}  // namespace brouwer
