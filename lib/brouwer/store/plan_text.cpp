#include <brouwer/store/plan_text.hpp>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <sstream>
#include <stdexcept>

namespace brouwer {
namespace {

/// Those that are not the standard, so that plans from before these factors stay what they are.
std::string operations(CellLabels const& cell) {
  CellLabels const standard;
  std::string text;
  if (cell.rounding != standard.rounding) text += ", rounding = " + cell.rounding;
  if (cell.constants != standard.constants) text += ", constants = " + cell.constants;
  if (cell.contraction != standard.contraction) text += fmt::format(", contraction = {}", cell.contraction);
  return text;
}

std::string to_text(CellLabels const& cell) {
  return fmt::format(
      "system = {}, method = {}, arithmetic = {}, special_functions = {}, coefficients = {}, compensation = {}, "
      "step = {}, steps = {}{}",
      cell.system, cell.method, cell.arithmetic, cell.special_functions, cell.coefficients, cell.compensation,
      cell.step, cell.steps, operations(cell));
}

/// "key = value" taken apart; a text without " = " is a key alone.
std::pair<std::string, std::string> key_and_value(std::string const& text) {
  auto const equals = text.find(" = ");
  if (equals == std::string::npos) return {text, ""};
  return {text.substr(0, equals), text.substr(equals + 3)};
}

std::map<std::string, std::string> pairs_of(std::string const& text, std::string const& separator) {
  std::map<std::string, std::string> pairs;
  for (std::size_t begin = 0; begin < text.size();) {
    auto const end = std::min(text.find(separator, begin), text.size());
    pairs.insert(key_and_value(text.substr(begin, end - begin)));
    begin = end + separator.size();
  }
  return pairs;
}

template <class Number>
Number number(std::string const& text) {
  Number value = 0;
  auto const end = text.data() + text.size();
  auto const [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end) throw std::invalid_argument("'" + text + "' is no number");
  return value;
}

CellLabels cell_of(std::string const& line) {
  auto const pairs = pairs_of(line.substr(line.find(": ") + 2), ", ");
  auto const value = [&](char const* key) {
    auto const found = pairs.find(key);
    if (found == pairs.end())
      throw std::invalid_argument(fmt::format("the line of {} lacks {}", line.substr(0, line.find(':')), key));
    return found->second;
  };
  auto const or_standard = [&](char const* key, std::string const& standard) {
    return pairs.contains(key) ? value(key) : standard;
  };
  CellLabels const standard;
  return {value("system"),
          value("method"),
          value("arithmetic"),
          value("special_functions"),
          or_standard("coefficients", no_level),  // plans from before this factor
          value("compensation") == "true",
          number<double>(value("step")),
          number<std::int64_t>(value("steps")),
          or_standard("rounding", standard.rounding),
          or_standard("constants", standard.constants),
          or_standard("contraction", "false") == "true"};
}

/// Hexadecimal doubles as people write them.
std::string readable(std::string const& value) {
  std::string text;
  std::size_t from = 0;
  for (auto at = value.find("0x"); at != std::string::npos; at = value.find("0x", from)) {
    char* end = nullptr;
    double const number = std::strtod(value.c_str() + at, &end);
    text += value.substr(from, at - from) + fmt::format("{}", number);
    from = static_cast<std::size_t>(end - value.c_str());
  }
  return text + value.substr(from);
}

}  // namespace

std::string to_text(FolderPlan const& plan) {
  auto text = "study = " + plan.study_hash + "\n" + plan.canonical_text;
  if (text.back() != '\n') text += '\n';
  for (std::size_t i = 0; i < plan.cells.size(); ++i) text += fmt::format("cell {}: {}\n", i, to_text(plan.cells[i]));
  return text;
}

FolderPlan plan_of_text(std::string const& text) {
  FolderPlan plan;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  if (!line.starts_with("study = ")) throw std::invalid_argument("its first line is not 'study = …'");
  plan.study_hash = key_and_value(line).second;
  while (std::getline(lines, line))
    if (line.starts_with(fmt::format("cell {}: ", plan.cells.size())))
      plan.cells.push_back(cell_of(line));
    else
      plan.canonical_text += line + "\n";
  return plan;
}

std::string differences(std::string const& there, std::string const& here) {
  auto const before = pairs_of(there, "\n"), now = pairs_of(here, "\n");
  std::vector<std::string> found;
  for (auto const& [key, value] : before)
    if (!now.contains(key))
      found.push_back(fmt::format("{} was {} there and is not given here", key, readable(value)));
    else if (now.at(key) != value)
      found.push_back(fmt::format("{} was {} there and is {} here", key, readable(value), readable(now.at(key))));
  for (auto const& [key, value] : now)
    if (!before.contains(key))
      found.push_back(fmt::format("{} was not given there and is {} here", key, readable(value)));
  if (found.empty()) return "its plan.txt says otherwise";
  return fmt::format("{}", fmt::join(found, "; "));
}

}  // namespace brouwer
