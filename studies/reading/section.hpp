#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <optional>
#include <string>
#include <vector>

#include "studies/reading/complaints.hpp"
#include "studies/reading/kinds.hpp"
#include "studies/reading/overrides.hpp"

namespace brouwer {

/// A study under reading: where its values come from, and what is wrong so far.
struct Reading {
  std::string file;
  std::vector<Override> overrides;
  Complaints complaints;

  /// "drift.toml:12", or the option that gave the value: "--members 0".
  std::string place(std::string const& path, toml::source_region const& source) const;
};

/// One table of a study file. Every key that is asked for is ticked off; what is left in the end is unknown.
/// A missing table reads like an empty one. Wrong values are complained about and count as missing.
class Section {
 public:
  /// @param path  dotted; "" is the file itself
  Section(Reading& reading, toml::table const* table, std::string path, toml::source_region source = {});

  bool has(std::string const& key) { return find(key) != nullptr; }
  bool present() const { return table_ != nullptr; }
  std::string const& path() const { return path_; }
  std::string path(std::string const& key) const { return path_.empty() ? key : path_ + "." + key; }

  /// The node at `key` (hyphens and underscores alike), or null.
  toml::node const* find(std::string const& key);

  template <class T>
  std::optional<T> value(std::string const& key, Kind<T> const& kind) {
    toml::node const* node = find(key);
    return node ? read(*node, path(key), kind) : std::nullopt;
  }

  /// Like `value`, but complains where the key is missing.
  template <class T>
  std::optional<T> required(std::string const& key, Kind<T> const& kind) {
    if (!find(key)) complain(fmt::format("'{}' is missing, expected {}", path(key), kind.expected));
    return value(key, kind);
  }

  /// The levels of a factor: one value or a list, without repetition; empty where the key is missing.
  template <class T>
  std::vector<T> levels(std::string const& key, Kind<T> const& kind);

  /// The table at `key`; a missing one is empty.
  Section section(std::string const& key);

  void complain(std::string const& sentence);                          ///< about this table
  void complain(std::string const& key, std::string const& sentence);  ///< about a key in it
  void refuse_unknown_keys();

  /// Names of the keys that are there.
  std::vector<std::string> keys() const;

 private:
  template <class T>
  std::optional<T> read(toml::node const& node, std::string const& path, Kind<T> const& kind);
  void complain_of(toml::node const& node, std::string const& path, std::string const& sentence);

  Reading& reading_;
  toml::table const* table_;
  std::string path_;
  toml::source_region source_;
  std::vector<std::string> asked_;
};

template <class T>
std::optional<T> Section::read(toml::node const& node, std::string const& path, Kind<T> const& kind) {
  try {
    if (auto value = kind.read(node)) return value;
    complain_of(node, path, fmt::format(" = {}, expected {}", shown(node), kind.expected));
  } catch (InputError const& error) {
    complain_of(node, path, fmt::format(": {}", error.what()));
  }
  return std::nullopt;
}

template <class T>
std::vector<T> Section::levels(std::string const& key, Kind<T> const& kind) {
  toml::node const* node = find(key);
  if (!node) return {};
  if (!node->is_array()) {
    auto const level = read(*node, path(key), kind);
    return level ? std::vector<T>{*level} : std::vector<T>{};
  }
  std::vector<T> found;
  if (node->as_array()->empty()) complain_of(*node, path(key), " is empty, expected at least one level");
  for (auto const& element : *node->as_array()) {
    auto const level = read(element, path(key), kind);
    if (!level) continue;
    bool const repeated = std::find(found.begin(), found.end(), *level) != found.end();
    if (repeated) complain_of(element, path(key), fmt::format(" has {} twice", shown(element)));
    if (!repeated) found.push_back(*level);
  }
  return found;
}

}  // namespace brouwer
