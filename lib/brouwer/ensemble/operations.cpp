#include <brouwer/ensemble/operations.hpp>

#include <fmt/format.h>

#include <algorithm>

#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>

namespace brouwer {
namespace {

/// A level's place in its list.
std::size_t place_of(std::string const& level, std::vector<std::string> const& levels, char const* what) {
  auto const found = std::find(levels.begin(), levels.end(), level);
  if (found == levels.end())
    throw InputError(fmt::format("there is no {} '{}'{}", what, level, suggestion(level, levels)));
  return static_cast<std::size_t>(found - levels.begin());
}

/// "rounding up, exact constants": what is not the processor's.
std::string chosen_operations(CellLabels const& cell) {
  CellLabels const standard;
  std::vector<std::string> chosen;
  if (cell.rounding != standard.rounding) chosen.push_back("rounding " + cell.rounding);
  if (cell.constants != standard.constants) chosen.push_back(cell.constants + " constants");
  if (cell.contraction) chosen.emplace_back("contraction");
  return fmt::format("{}", fmt::join(chosen, ", "));
}

}  // namespace

std::vector<std::string> const& rounding_levels() {
  static std::vector<std::string> const levels = {"nearest", "up", "down", "toward-zero", "stochastic"};
  return levels;
}

std::vector<std::string> const& constants_levels() {
  static std::vector<std::string> const levels = {"rounded", "exact"};
  return levels;
}

OperationRule operation_rule(CellLabels const& cell) {
  return {static_cast<Rounding>(place_of(cell.rounding, rounding_levels(), "rounding")),
          place_of(cell.constants, constants_levels(), "kind of constants") == 1, cell.contraction};
}

std::string no_such_operations(CellLabels const& cell) {
  if (operation_rule(cell).standard()) return "";
  auto const step = "a step with " + chosen_operations(cell);
  if (cell.arithmetic != "float" && cell.arithmetic != "double")
    return fmt::format("{} exists in float and double only, not in {}", step, cell.arithmetic);
  if (cell.special_functions != no_level && cell.special_functions != "own")
    return fmt::format("{} does not reach into the '{}' elliptic functions, only into our own", step,
                       cell.special_functions);
  return "";
}

CellLabels with_standard_operations(CellLabels cell) {
  CellLabels const standard;
  cell.rounding = standard.rounding;
  cell.constants = standard.constants;
  cell.contraction = standard.contraction;
  return cell;
}

std::vector<CellLabels> crossed_operations(Study const& study, CellLabels const& cell) {
  std::vector<CellLabels> cells;
  for (auto const& rounding : study.rounding)
    for (auto const& constants : study.constants)
      for (bool const contraction : study.contraction) {
        cells.push_back(cell);
        cells.back().rounding = rounding;
        cells.back().constants = constants;
        cells.back().contraction = contraction;
      }
  return cells;
}

}  // namespace brouwer
