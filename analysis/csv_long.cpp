// Long form: one error a line, with columns time, member, error and perhaps labels of separate ensembles.
#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <numeric>
#include <unordered_map>

#include "analysis/csv_forms.hpp"

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

LongColumns columns_of(CsvLines const& lines, CsvHeader const& header) {
  LongColumns columns;
  TimeName const* time = std::find_if(std::begin(time_names), std::end(time_names),
                                      [&](TimeName const& t) { return header.find(t.name).has_value(); });
  if (time == std::end(time_names)) time = time_names;
  columns.time = required_column(lines, header, time->name);
  columns.time_unit = time->unit;
  columns.member = required_column(lines, header, "member");
  columns.error = required_column(lines, header, "error");
  for (auto const& label : labels)
    if (auto const column = header.find(label.name)) columns.labels.push_back({&label, *column});
  return columns;
}

struct TextHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
};

/// Numbers members in order of appearance. What it has seen costs no allocation, and no search where members come in
/// the same order again or one after the other.
class MemberIndex {
 public:
  std::uint32_t operator()(std::string_view name) {
    for (std::uint32_t const guess : {last_, last_ + 1, 0u})
      if (guess < names_.size() && names_[guess] == name) return last_ = guess;
    auto const found = index_.find(name);
    if (found != index_.end()) return last_ = found->second;
    last_ = static_cast<std::uint32_t>(names_.size());
    names_.emplace_back(name);
    index_.emplace(name, last_);
    return last_;
  }
  std::vector<std::string> const& names() const { return names_; }

 private:
  std::unordered_map<std::string, std::uint32_t, TextHash, std::equal_to<>> index_;
  std::vector<std::string> names_;
  std::uint32_t last_ = 0;
};

class TimeIndex {
 public:
  std::uint32_t operator()(double time) {
    auto const [entry, is_new] = index_.try_emplace(time, static_cast<std::uint32_t>(times_.size()));
    if (is_new) times_.push_back(time);
    return entry->second;
  }
  std::vector<double> const& times() const { return times_; }

 private:
  std::unordered_map<double, std::uint32_t> index_;
  std::vector<double> times_;
};

struct Observation {
  double error;
  std::uint32_t member, time;  // as numbered by the indices
  std::int64_t line;
};

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

/// The observations of one ensemble, as they come.
class LongTable {
 public:
  explicit LongTable(Ensemble labelled) : ensemble_(std::move(labelled)) {}

  void add(std::string_view member, double time, double error, std::int64_t line) {
    observations_.push_back({error, members_(member), times_(time), line});
  }

  /// The matrix, in order of members and times, once every place is known to be filled exactly once.
  Ensemble finish(CsvLines const& lines) {
    std::string const of = ensemble_.quantity.empty() ? "" : " of '" + shown(ensemble_.quantity) + "'";
    if (observations_.size() < members_.names().size() * times_.times().size()) complain_of_a_hole(lines, of);
    fill(lines, of);
    ensemble_.times = times_.times();
    std::sort(ensemble_.times.begin(), ensemble_.times.end());
    require_an_ensemble(lines, ensemble_, of);
    if (ensemble_.quantity.empty()) ensemble_.quantity = "error";
    ensemble_.family = ensemble_.quantity;
    return std::move(ensemble_);
  }

 private:
  void fill(CsvLines const& lines, std::string const& of) {
    auto const row = ranks(members_.names(), member_before);
    auto const column = ranks(times_.times(), std::less<>{});
    ensemble_.errors.setConstant(std::ssize(row), std::ssize(column), std::numeric_limits<double>::quiet_NaN());
    for (auto const& o : observations_) {
      double& place = ensemble_.errors(row[o.member], column[o.time]);
      if (!std::isnan(place)) complain_of_a_duplicate(lines, o, of);
      place = o.error;
    }
  }

  /// A member that was seen fewer times than there are times lacks one; there is such a member.
  [[noreturn]] void complain_of_a_hole(CsvLines const& lines, std::string const& of) const {
    std::vector<std::size_t> seen(members_.names().size());
    for (auto const& o : observations_) ++seen[o.member];
    auto const member = static_cast<std::size_t>(std::min_element(seen.begin(), seen.end()) - seen.begin());
    std::vector<char> has(times_.times().size());
    std::int64_t line = 0;
    for (auto const& o : observations_)
      if (o.member == member) has[o.time] = 1, line = o.line;
    auto const time = static_cast<std::size_t>(std::find(has.begin(), has.end(), 0) - has.begin());
    throw InputError(
        fmt::format("{}:{}: member '{}'{} has no error at time {}: every member needs one at each of the {} "
                    "times",
                    lines.file(), line, shown(members_.names()[member]), of, times_.times()[time], has.size()));
  }

  [[noreturn]] void complain_of_a_duplicate(CsvLines const& lines, Observation const& again,
                                            std::string const& of) const {
    auto const first = std::find_if(observations_.begin(), observations_.end(), [&](Observation const& o) {
      return o.member == again.member && o.time == again.time;
    });
    throw InputError(fmt::format(
        "{}:{}: member '{}'{} has an error at time {} in line {} already (columns that tell "
        "ensembles apart are quantity, system, method and arithmetic)",
        lines.file(), again.line, shown(members_.names()[again.member]), of, times_.times()[again.time], first->line));
  }

  Ensemble ensemble_;
  std::deque<Observation> observations_;  // grows without copying
  MemberIndex members_;
  TimeIndex times_;
};

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
  if (time > 0)
    tables.of(fields).add(fields[columns.member], time, error, lines.number());
  else
    require_zero_start(lines, error);
}

}  // namespace

std::vector<Ensemble> read_long_form(CsvLines& lines, CsvHeader const& header) {
  auto const columns = columns_of(lines, header);
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
