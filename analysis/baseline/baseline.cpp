#include "analysis/baseline/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <brouwer/store/whole_file.hpp>

#include "analysis/baseline/study_change.hpp"
#include "analysis/escape.hpp"

namespace brouwer {
namespace {

bool same_bits(BaselineEntry const& a, BaselineEntry const& b) {
  return a.study_hash == b.study_hash &&
         std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(),
                    [](auto const& x, auto const& y) { return same_place(x, y) && x.digest == y.digest; });
}

}  // namespace

BaselineEntry BaselineEntry::only(std::string const& quantity, Selector const& where) const {
  BaselineEntry chosen = *this;
  std::erase_if(chosen.rows,
                [&](BaselineRow const& row) { return row.quantity != quantity || !where.matches(row.cell); });
  if (!chosen.rows.empty()) return chosen;
  std::vector<std::string> quantities;
  for (auto const& row : rows)
    if (!contains(quantities, row.quantity)) quantities.push_back(row.quantity);
  throw InputError(fmt::format("the selected cells have no '{}'{}", quantity, suggestion(quantity, quantities)));
}

BaselineEntry const& Baseline::entry(std::string const& label) const {
  if (label.empty()) return entries.back();
  std::vector<std::string> labels;
  for (auto const& one : entries) {
    if (one.label == label) return one;
    labels.push_back(one.label);
  }
  throw InputError(fmt::format("the baseline has no entry '{}'{}", one_line(label), suggestion(label, labels)));
}

Baseline read_baseline(std::filesystem::path const& file) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none))
    throw InputError(
        fmt::format("there is no baseline {}; 'brouwer baseline STUDY -o FILE' records one", file.string()));
  return baseline_of_json(read_whole(file), file.string());
}

bool append(Baseline& baseline, BaselineEntry entry) {
  for (auto const& known : baseline.entries) {
    if (known.label != entry.label) continue;
    if (same_bits(known, entry)) return false;
    throw InputError(
        fmt::format("there is an entry '{}' already, of other numbers; give another --label", one_line(entry.label)));
  }
  for (auto& known : baseline.entries) {
    require_same_question(known.study, entry.study);
    for (auto& row : known.rows) row.slopes.clear();
  }
  baseline.entries.push_back(std::move(entry));
  return true;
}

}  // namespace brouwer
