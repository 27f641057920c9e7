#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <brouwer/store/file.hpp>
#include <brouwer/store/folder.hpp>
#include <brouwer/store/results.hpp>
#include <brouwer/store/whole_file.hpp>
#include <span>
#include <system_error>

namespace brouwer {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(fs::path const& unit, std::string const& reason) {
  throw RunError(fmt::format("{} {}; delete it and run the study again to compute it anew", unit.string(), reason));
}

/// The finished units of a cell; none where the cell has not been begun.
std::vector<fs::path> unit_files(fs::path const& cell_folder) {
  std::vector<fs::path> files;
  if (!fs::exists(cell_folder)) return files;
  for (auto const& entry : fs::directory_iterator(cell_folder))
    if (entry.path().extension() == ".h5" && !is_leftover(entry.path())) files.push_back(entry.path());
  return files;
}

Series const* find(UnitRecord const& unit, std::string const& name) {
  auto const found =
      std::find_if(unit.series.begin(), unit.series.end(), [&](auto const& s) { return s.name == name; });
  return found == unit.series.end() ? nullptr : &*found;
}

/// Moves the members whose errors are all finite to the front and cuts the others off.
/// @return how many were cut off
Eigen::Index drop_failed(ErrorMatrix& errors) {
  Eigen::Index kept = 0;
  for (Eigen::Index member = 0; member < errors.rows(); ++member) {
    if (!errors.row(member).allFinite()) continue;
    if (kept < member) errors.row(kept) = errors.row(member);
    ++kept;
  }
  auto const failed = errors.rows() - kept;
  if (failed > 0) errors.conservativeResize(kept, Eigen::NoChange);
  return failed;
}

}  // namespace

Results::Results(fs::path folder) : folder_(std::move(folder)) {
  std::error_code none;
  if (!fs::is_directory(folder_, none)) throw InputError("there is no result folder " + folder_.string());
  auto const plan = read_plan(folder_);
  study_hash_ = plan.study_hash;
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    Cell cell{plan.cells[i], {}, read_units(folder_ / cell_path(i), study_hash_, plan.cells[i])};
    cell.quantities = component_names(cell.units);
    for (auto const& unit : cell.units) cell.members += unit.header.members;
    cells_.push_back(std::move(cell));
  }
}

std::vector<Results::Unit> Results::read_units(fs::path const& folder, std::string const& study_hash,
                                               CellLabels const& planned) {
  std::vector<Unit> units;
  for (auto const& file : unit_files(folder)) units.push_back({file, read_unit_header(file)});
  std::sort(units.begin(), units.end(),
            [](auto const& a, auto const& b) { return a.header.first_member < b.header.first_member; });
  std::int64_t next_member = 0;
  for (auto const& [file, header] : units) {
    if (header.study_hash != study_hash) refuse(file, "belongs to another study");
    if (header.cell != planned) refuse(file, "is of another cell than plan.txt says");
    if (header.first_member < next_member) refuse(file, "has members that the unit before it has too");
    if (header.sample_steps != units.front().header.sample_steps) refuse(file, "has other samples than the first unit");
    next_member = header.first_member + header.members;
  }
  return units;
}

std::vector<std::string> Results::component_names(std::vector<Unit> const& units) {
  std::vector<std::string> names;
  for (auto const& unit : units)
    for (auto const& series : unit.header.series)
      if (series.members > 0 && std::find(names.begin(), names.end(), series.name) == names.end())
        names.push_back(series.name);
  return names;
}

std::string Results::study_text() const { return read_whole(folder_ / "study.toml"); }

Ensemble Results::load(std::size_t number, std::string const& quantity) const {
  auto const& cell = cells_.at(number);
  Ensemble ensemble;
  ensemble.cell = cell.labels;
  ensemble.quantity = quantity;
  Eigen::Index members = 0;
  for (auto const& unit : cell.units)
    if (auto const* series = find(unit.header, quantity); series != nullptr) {
      ensemble.family = series->quantity;
      ensemble.unit = series->unit;
      members += series->members;
    }
  if (members == 0)
    throw InputError(folder_.string() + " has no '" + quantity + "'" + suggestion(quantity, cell.quantities));

  auto const& steps = cell.units.front().header.sample_steps;
  ensemble.times.assign(steps.begin(), steps.end());
  ensemble.errors.resize(members, std::ssize(steps));
  auto rest = std::span(ensemble.errors.data(), static_cast<std::size_t>(ensemble.errors.size()));
  for (auto const& unit : cell.units)
    if (auto const* series = find(unit.header, quantity); series != nullptr) {
      auto const size = static_cast<std::size_t>(series->members) * steps.size();
      read_series(unit.file, quantity, rest.first(size));
      rest = rest.subspan(size);
    }
  ensemble.failed = drop_failed(ensemble.errors);
  return ensemble;
}

}  // namespace brouwer
