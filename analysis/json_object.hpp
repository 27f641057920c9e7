#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/escape.hpp"
#include "analysis/interval.hpp"
#include "analysis/numbers.hpp"

namespace brouwer {

/// "[a, b]" of JSON texts.
inline std::string json_array(std::vector<std::string> const& items) {
  return fmt::format("[{}]", fmt::join(items, ", "));
}

/// "key": value, of one object, in the order in which they are added.
class JsonObject {
 public:
  JsonObject& add(char const* key, std::string const& json) {
    pairs_.push_back(json_string(key) + ": " + json);
    return *this;
  }
  JsonObject& text(char const* key, std::string const& value) { return add(key, json_string(value)); }
  JsonObject& flag(char const* key, bool value) { return add(key, value ? "true" : "false"); }
  JsonObject& whole(char const* key, std::int64_t value) { return add(key, fmt::format("{}", value)); }
  JsonObject& real(char const* key, double value) { return add(key, json_number(value)); }
  JsonObject& interval(char const* key, Interval const& value) {
    return add(key, json_array({json_number(value.low), json_number(value.high)}));
  }
  JsonObject& list(char const* key, std::vector<double> const& values) {
    std::vector<std::string> texts;
    for (double const value : values) texts.push_back(json_number(value));
    return add(key, json_array(texts));
  }
  JsonObject& list(char const* key, std::vector<std::string> const& values) {
    std::vector<std::string> texts;
    for (auto const& value : values) texts.push_back(json_string(value));
    return add(key, json_array(texts));
  }
  std::string json() const { return fmt::format("{{{}}}", fmt::join(pairs_, ", ")); }

 private:
  std::vector<std::string> pairs_;
};

}  // namespace brouwer
