#include "analysis/expectations/ends.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <string>

namespace brouwer {
namespace {

/// Which numbers of a start are what.
struct Columns {
  std::vector<std::size_t> parameters, state, masses;
};

bool is_mass(std::string const& name) { return name == "masses" || name.starts_with("masses-"); }

Columns columns_of(UnitRecord const& unit) {
  Columns columns;
  auto const& names = unit.start_names;
  for (auto const& name : unit.state_names)
    if (auto const found = std::find(names.begin(), names.end(), name); found != names.end())
      columns.state.push_back(static_cast<std::size_t>(found - names.begin()));
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::find(columns.state.begin(), columns.state.end(), i) == columns.state.end())
      columns.parameters.push_back(i);
    if (is_mass(names[i])) columns.masses.push_back(i);
  }
  // n bodies in space have 3n places and 3n velocities; other systems with masses (pendulums) have no barycentre to watch
  if (unit.state_names.size() != 6 * columns.masses.size()) columns.masses.clear();
  return columns;
}

std::vector<double> chosen(std::vector<std::size_t> const& columns, double const* row) {
  std::vector<double> numbers;
  for (auto const column : columns) numbers.push_back(row[column]);
  return numbers;
}

double largest(std::vector<double> const& numbers) {
  double most = 0;
  for (double const x : numbers) most = std::max(most, std::abs(x));
  return most;
}

/// A member without a next state has none at the end either.
bool came_through(UnitRecord const& unit, std::size_t member, std::vector<double> const& final) {
  bool const failed = !unit.failed_at.empty() && unit.failed_at[member] >= 0;
  return !failed && std::all_of(final.begin(), final.end(), [](double x) { return std::isfinite(x); });
}

using Bodies = Eigen::Matrix<double, 3, Eigen::Dynamic>;

Bodies places(std::vector<double> const& state, std::size_t bodies) {
  return Eigen::Map<Bodies const>(state.data(), 3, static_cast<Eigen::Index>(bodies));
}

}  // namespace

double MemberEnds::distance() const {
  double most = 0;
  for (std::size_t i = 0; i < start.size(); ++i) most = std::max(most, std::abs(final[i] - start[i]));
  return most;
}

double MemberEnds::size() const { return largest(start); }

double MemberEnds::barycentre_shift() const {
  if (masses.empty()) return 0;
  Eigen::Map<Eigen::VectorXd const> const weights(masses.data(), static_cast<Eigen::Index>(masses.size()));
  Bodies const before = places(start, masses.size());
  Eigen::Vector3d const from = before * weights / weights.sum();
  Eigen::Vector3d const to = places(final, masses.size()) * weights / weights.sum();
  return (to - from).norm() / (before.colwise() - from).colwise().norm().maxCoeff();
}

std::vector<double> MemberEnds::both() const {
  auto numbers = parameters;
  numbers.insert(numbers.end(), start.begin(), start.end());
  numbers.insert(numbers.end(), final.begin(), final.end());
  return numbers;
}

std::vector<MemberEnds> members_of(UnitRecord const& unit) {
  auto const columns = columns_of(unit);
  std::vector<MemberEnds> members;
  if (columns.state.size() != unit.state_names.size()) return members;  // a start without its state: from elsewhere
  for (std::size_t i = 0; i < static_cast<std::size_t>(unit.members); ++i) {
    double const* row = unit.start.data() + i * unit.start_names.size();
    double const* last = unit.final_state.data() + i * unit.state_names.size();
    std::vector<double> const final(last, last + unit.state_names.size());
    if (came_through(unit, i, final))
      members.push_back(
          {chosen(columns.parameters, row), chosen(columns.state, row), final, chosen(columns.masses, row)});
  }
  return members;
}

}  // namespace brouwer
