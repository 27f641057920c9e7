#include <brouwer/store/results.hpp>

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <limits>
#include <span>
#include <system_error>

#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <brouwer/store/failures.hpp>
#include <brouwer/store/file.hpp>
#include <brouwer/store/folder.hpp>
#include <brouwer/store/timings.hpp>
#include <brouwer/store/whole_file.hpp>

namespace brouwer {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(fs::path const& unit, std::string const& reason) {
  throw RunError(fmt::format("{} {}; delete it and run the study again to compute it anew", unit.string(), reason));
}

/// The finished units of a cell; none where the cell has not been begun.
std::vector<FinishedUnit> units_in(fs::path const& folder) {
  std::vector<FinishedUnit> units;
  std::error_code error;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
    if (entry->path().extension() == ".h5" && !is_leftover(entry->path()))
      units.push_back({entry->path(), read_unit_header(entry->path())});
  if (error && error != std::errc::no_such_file_or_directory)
    throw RunError(fmt::format("cannot read {}: {}", folder.string(), error.message()));
  std::sort(units.begin(), units.end(),
            [](auto const& a, auto const& b) { return a.header.first_member < b.header.first_member; });
  return units;
}

/// Units by first member that agree with the plan and with one another; members that are missing are no fault.
void check(std::vector<FinishedUnit> const& units, std::string const& study_hash, CellLabels const& planned) {
  std::int64_t next_member = 0;
  for (auto const& [file, header] : units) {
    if (header.study_hash != study_hash) refuse(file, "belongs to another study");
    if (header.cell != planned) refuse(file, "is of another cell than plan.txt says");
    if (file.filename() != unit_path(0, header.first_member).filename())
      refuse(file, fmt::format("holds members from {} on, not those that its name says", header.first_member));
    if (header.first_member < next_member) refuse(file, "has members that the unit before it has too");
    if (header.sample_steps != units.front().header.sample_steps) refuse(file, "has other samples than the first unit");
    next_member = header.first_member + header.members;
  }
}

std::vector<std::string> component_names(std::vector<FinishedUnit> const& units) {
  std::vector<std::string> names;
  for (auto const& unit : units)
    for (auto const& series : unit.header.series)
      if (series.members > 0 && std::find(names.begin(), names.end(), series.name) == names.end())
        names.push_back(series.name);
  return names;
}

/// A unit's share of one component: where it lies and how many members it has.
struct Part {
  FinishedUnit const* unit;
  Series header;
};

std::vector<Part> parts_of(std::vector<FinishedUnit> const& units, std::string const& component) {
  std::vector<Part> parts;
  for (auto const& unit : units)
    for (auto const& series : unit.header.series)
      if (series.name == component && series.members > 0) parts.push_back({&unit, series});
  return parts;
}

/// All parts, one below the other, each read straight into its rows.
ErrorMatrix read(std::vector<Part> const& parts, Eigen::Index samples) {
  Eigen::Index members = 0;
  for (auto const& part : parts) members += part.header.members;
  ErrorMatrix errors(members, samples);
  auto rest = std::span(errors.data(), static_cast<std::size_t>(errors.size()));
  for (auto const& part : parts) {
    auto const size = static_cast<std::size_t>(part.header.members * samples);
    read_series(part.unit->file, part.header.name, rest.first(size));
    rest = rest.subspan(size);
  }
  return errors;
}

/// What became of the members of all parts, in the same order.
std::vector<Fate> fates(std::vector<Part> const& parts) {
  std::vector<Fate> all;
  for (auto const& part : parts)
    for (auto& fate : fates_of(part.unit->header, part.header.members)) all.push_back(std::move(fate));
  return all;
}

/// Their numbers in the study, in the same order.
std::vector<std::string> names(std::vector<Part> const& parts) {
  std::vector<std::string> all;
  for (auto const& part : parts)
    for (std::int64_t i = 0; i < part.header.members; ++i)
      all.push_back(std::to_string(part.unit->header.first_member + i));
  return all;
}

/// The line `members = …` of a study's canonical text; 0 where there is none.
std::int64_t members_in(std::string const& canonical_text) {
  auto const key = std::string("\nmembers = ");
  auto const at = canonical_text.find(key);
  return at == std::string::npos ? 0 : std::atoll(canonical_text.c_str() + at + key.size());
}

}  // namespace

Results::Results(fs::path folder) : folder_(std::move(folder)) {
  std::error_code none;
  if (!fs::is_directory(folder_, none)) throw InputError("there is no result folder " + folder_.string());
  auto const plan = read_plan(folder_);
  study_hash_ = plan.study_hash;
  planned_members_ = members_in(plan.canonical_text);
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    Cell cell{plan.cells[i], {}, units_in(folder_ / cell_path(i))};
    check(cell.units, study_hash_, cell.labels);
    cell.quantities = component_names(cell.units);
    for (auto const& unit : cell.units) cell.members += unit.header.members;
    cells_.push_back(std::move(cell));
  }
}

std::string Results::study_text() const { return read_whole(folder_ / "study.toml"); }

double Results::seconds_per_member(std::size_t cell) const {
  auto const timings = read_timings(folder_);
  Timing sum;
  for (auto const& unit : cells_.at(cell).units)
    if (auto const found = timings.find(unit_path(cell, unit.header.first_member).generic_string());
        found != timings.end()) {
      sum.members += found->second.members;
      sum.seconds += found->second.seconds;
    }
  return sum.members > 0 ? sum.seconds / static_cast<double>(sum.members) : std::numeric_limits<double>::quiet_NaN();
}

std::vector<UnitRecord> Results::ends(std::size_t cell) const {
  std::vector<UnitRecord> ends;
  for (auto const& unit : cells_.at(cell).units) ends.push_back(read_unit_ends(unit.file));
  return ends;
}

Ensemble Results::load(std::size_t number, std::string const& quantity) const {
  auto const& cell = cells_.at(number);
  auto const parts = parts_of(cell.units, quantity);
  if (parts.empty())
    throw InputError(
        fmt::format("{} has no quantity '{}'{}", folder_.string(), quantity, suggestion(quantity, cell.quantities)));
  auto const& steps = cell.units.front().header.sample_steps;
  auto const& first = parts.front().header;
  Ensemble ensemble{
      cell.labels, quantity, first.quantity, first.unit, {steps.begin(), steps.end()}, read(parts, std::ssize(steps))};
  ensemble.count = first.count;
  ensemble.names = names(parts);
  ensemble.failures = drop_failed(ensemble.errors, fates(parts), ensemble.names);
  for (auto const& failures : ensemble.failures) ensemble.failed += failures.members;
  return ensemble;
}

}  // namespace brouwer
