#include <brouwer/store/orbits.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <brouwer/store/file.hpp>
#include <brouwer/store/results.hpp>

namespace brouwer {
namespace {

/// Columns of the start in which the state's components stand; the start may hold parameters of the system, too.
std::vector<std::size_t> state_columns(UnitRecord const& unit) {
  std::vector<std::size_t> columns;
  for (auto const& name : unit.state_names) {
    auto const found = std::find(unit.start_names.begin(), unit.start_names.end(), name);
    columns.push_back(static_cast<std::size_t>(found - unit.start_names.begin()));
  }
  return columns;
}

std::vector<double> times_of(UnitRecord const& unit) {
  std::vector<double> times = {0};
  times.insert(times.end(), unit.sample_steps.begin(), unit.sample_steps.end());
  return times;
}

/// After the step at which a member had no next state there is none, whatever the unit holds there.
bool is_gone(UnitRecord const& unit, std::size_t member, std::size_t sample) {
  if (unit.failed_at.empty() || unit.failed_at[member] < 0) return false;
  return unit.sample_steps[sample] > unit.failed_at[member];
}

void append(Orbits& all, UnitRecord const& unit) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  auto const columns = state_columns(unit);
  auto const width = unit.start_names.size(), components = columns.size(), samples = unit.sample_steps.size();
  for (std::size_t member = 0; member < static_cast<std::size_t>(unit.members); ++member) {
    for (auto const column : columns) all.states.push_back(column < width ? unit.start[member * width + column] : none);
    for (std::size_t sample = 0; sample < samples; ++sample)
      for (std::size_t c = 0; c < components; ++c)
        all.states.push_back(is_gone(unit, member, sample) ? none
                                                           : unit.states[(member * samples + sample) * components + c]);
  }
  all.members += static_cast<std::size_t>(unit.members);
}

}  // namespace

Orbits orbits_of(std::vector<FinishedUnit> const& units) {
  Orbits all;
  for (auto const& [file, header] : units) {
    auto const unit = read_unit(file);
    if (unit.states.empty()) continue;
    if (all.members == 0) all = {unit.cell, unit.state_names, times_of(unit), 0};
    append(all, unit);
  }
  return all;
}

}  // namespace brouwer
