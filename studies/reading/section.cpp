#include "studies/reading/section.hpp"

#include <fmt/format.h>

#include <brouwer/spelling.hpp>

namespace brouwer {

std::string Reading::place(std::string const& path, toml::source_region const& source) const {
  if (auto const option = option_behind(path, overrides); !option.empty()) return option;
  return source.begin.line == 0 ? file : fmt::format("{}:{}", file, source.begin.line);
}

Section::Section(Reading& reading, toml::table const* table, std::string path, toml::source_region source)
    : reading_(reading), table_(table), path_(std::move(path)), source_(std::move(source)) {}

toml::node const* Section::find(std::string const& key) {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(key);
  if (!table_) return nullptr;
  for (auto const& [present, node] : *table_)
    if (folded_key(std::string(present.str())) == folded_key(key)) return &node;
  return nullptr;
}

Section Section::section(std::string const& key) {
  toml::node const* node = find(key);
  if (node && !node->is_table()) complain_of(*node, path(key), fmt::format(" = {}, expected a table", shown(*node)));
  if (!node || !node->is_table()) return {reading_, nullptr, path(key)};
  return {reading_, node->as_table(), path(key), node->source()};
}

std::vector<std::string> Section::keys() const {
  std::vector<std::string> names;
  if (table_)
    for (auto const& [key, node] : *table_) names.emplace_back(key.str());
  return names;
}

void Section::complain(std::string const& sentence) {
  reading_.complaints.add(reading_.place(path_, source_) + ": " + sentence);
}

void Section::complain(std::string const& key, std::string const& sentence) {
  if (toml::node const* node = find(key))
    complain_of(*node, path(key), sentence);
  else
    complain(path(key) + sentence);
}

void Section::complain_of(toml::node const& node, std::string const& path, std::string const& sentence) {
  reading_.complaints.add(reading_.place(path, node.source()) + ": " + path + sentence);
}

void Section::refuse_unknown_keys() {
  if (!table_) return;
  std::vector<std::string> taken;
  for (auto const& [key, node] : *table_) {
    std::string const name(key.str()), folded = folded_key(name);
    auto const same = [&](std::string const& other) { return folded_key(other) == folded; };
    std::string const place = reading_.place(path(name), key.source());
    if (std::none_of(asked_.begin(), asked_.end(), same))
      reading_.complaints.add(fmt::format("{}: unknown key '{}'{}", place, path(name), suggestion(name, asked_)));
    else if (std::any_of(taken.begin(), taken.end(), same))
      reading_.complaints.add(
          fmt::format("{}: '{}' is given twice, with hyphen and with underscore", place, path(name)));
    taken.push_back(name);
  }
}

}  // namespace brouwer
