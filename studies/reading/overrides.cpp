#include "studies/reading/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>

namespace brouwer {
namespace {

std::vector<std::string> split(std::string const& key) {
  std::vector<std::string> parts(1);
  for (char c : key)
    if (c == '.')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// The key of `table` that is spelled like `key` but for hyphens, or `key` itself.
std::string present_spelling(toml::table const& table, std::string const& key) {
  for (auto const& [present, value] : table)
    if (folded_key(std::string(present.str())) == folded_key(key)) return std::string(present.str());
  return key;
}

toml::table& subtable(toml::table& table, std::string const& key, Override const& given) {
  auto& node = table.insert(present_spelling(table, key), toml::table{}).first->second;
  if (!node.is_table()) throw InputError(fmt::format("{}: '{}' is a value there, not a table", given.option, key));
  return *node.as_table();
}

/// VALUE as TOML; a word that is no TOML is a string, but an open bracket or quote is a mistake.
toml::table parsed_value(Override const& given) {
  try {
    toml::table one = parse_toml(fmt::format("value = {}", given.value), "");
    if (one.size() == 1) return one;
  } catch (InputError const& error) {
    if (given.value.find_first_of("[]{}\"'") != std::string::npos)
      throw InputError(fmt::format("{}: the value is not TOML: {}", given.option, error.what()));
  }
  return toml::table{{"value", given.value}};
}

void apply(Override const& given, toml::table& study) {
  toml::table* table = &study;
  auto path = split(given.key);
  std::string const last = path.back();
  path.pop_back();
  for (auto const& part : path) table = &subtable(*table, part, given);
  table->insert_or_assign(present_spelling(*table, last), *parsed_value(given).get("value"));
  if (given.key == "integrate.steps") table->erase("until");
  if (given.key == "integrate.until") table->erase("steps");
}

bool contains(std::string const& path, std::string const& part) {
  return path == part || path.starts_with(part + ".") || path.starts_with(part + "[");
}

}  // namespace

std::string folded_key(std::string key) {
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

Override parse_override(std::string const& assignment) {
  auto const equals = assignment.find('=');
  std::string const key = assignment.substr(0, equals);
  auto const parts = split(key);
  bool const has_hole = std::any_of(parts.begin(), parts.end(), [](auto const& part) { return part.empty(); });
  if (equals == std::string::npos || equals + 1 == assignment.size() || has_hole || parts.size() > 8)
    throw InputError(fmt::format("--set {}: expected KEY=VALUE, for example ensemble.members=8", assignment));
  return {key, assignment.substr(equals + 1), "--set " + assignment};
}

void apply(std::vector<Override> const& overrides, toml::table& study) {
  for (auto const& given : overrides) apply(given, study);
}

std::string option_behind(std::string const& path, std::vector<Override> const& overrides) {
  std::string const wanted = folded_key(path);
  for (auto given = overrides.rbegin(); given != overrides.rend(); ++given) {
    std::string const key = folded_key(given->key);
    if (contains(wanted, key)) return given->option;
  }
  return "";
}

}  // namespace brouwer
