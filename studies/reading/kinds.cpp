#include "studies/reading/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <cmath>
#include <sstream>

namespace brouwer {
namespace {

std::optional<double> finite(toml::node const& node) {
  if (!node.is_number()) return std::nullopt;
  auto const x = node.value<double>();
  return x && std::isfinite(*x) ? x : std::nullopt;
}

std::optional<std::int64_t> integer(toml::node const& node) {
  if (node.is_integer()) return node.value<std::int64_t>();
  auto const x = finite(node);
  bool const is_whole = x && std::abs(*x) < 0x1p53 && std::trunc(*x) == *x;  // doubles below 2^53 hold integers exactly
  return is_whole ? std::optional(static_cast<std::int64_t>(*x)) : std::nullopt;
}

Kind<double> number_where(std::string expected, std::function<bool(double)> holds) {
  return {std::move(expected), [holds = std::move(holds)](toml::node const& node) {
            auto const x = finite(node);
            return x && holds(*x) ? x : std::nullopt;
          }};
}

std::optional<std::vector<double>> finite_list(toml::node const& node) {
  if (auto const x = finite(node)) return std::vector{*x};
  if (!node.is_array()) return std::nullopt;
  std::vector<double> list;
  for (auto const& element : *node.as_array()) {
    auto const x = finite(element);
    if (!x) return std::nullopt;
    list.push_back(*x);
  }
  return list;
}

/// At most `limit` bytes of a text, cut between characters of UTF-8.
std::string shortened(std::string text, std::size_t limit) {
  if (text.size() <= limit) return text;
  while (limit > 0 && (static_cast<unsigned char>(text[limit]) & 0xC0U) == 0x80U) --limit;
  return text.substr(0, limit) + "…";
}

}  // namespace

Kind<std::string> text() {
  return {"a text in quotes",
          [](toml::node const& node) { return node.is_string() ? node.value<std::string>() : std::nullopt; }};
}

Kind<bool> flag() {
  return {"true or false",
          [](toml::node const& node) { return node.is_boolean() ? node.value<bool>() : std::nullopt; }};
}

Kind<std::int64_t> whole(std::int64_t low, std::int64_t high) {
  return {fmt::format("a whole number from {} to {}", low, high), [low, high](toml::node const& node) {
            auto const n = integer(node);
            return n && *n >= low && *n <= high ? n : std::nullopt;
          }};
}

Kind<double> number() {
  return number_where("a finite number", [](double) { return true; });
}

Kind<double> positive() {
  return number_where("a finite number greater than 0", [](double x) { return x > 0; });
}

Kind<double> above_up_to(double low, double high) {
  return number_where(fmt::format("a number greater than {} and at most {}", low, high),
                      [low, high](double x) { return x > low && x <= high; });
}

Kind<std::vector<double>> numbers(std::size_t size) {
  std::string const expected = size == 1 ? "a finite number" : fmt::format("a list of {} finite numbers", size);
  return {expected, [size](toml::node const& node) {
            auto list = finite_list(node);
            bool const fits = list && list->size() == size && (size == 1 || node.is_array());
            return fits ? list : std::nullopt;
          }};
}

Kind<std::string> one_of(std::string what, std::vector<std::string> known) {
  return {fmt::format("a name in quotes, one of {}", fmt::join(known, ", ")),
          [what, known = std::move(known)](toml::node const& node) -> std::optional<std::string> {
            if (!node.is_string()) return std::nullopt;
            auto const word = *node.value<std::string>();
            if (std::find(known.begin(), known.end(), word) != known.end()) return word;
            throw InputError(fmt::format("there is no {} '{}'{}", what, shortened(word, 40), suggestion(word, known)));
          }};
}

std::string shown(toml::node const& node) {
  if (node.is_table()) return "{…}";
  std::ostringstream text;
  node.visit([&](auto const& concrete) { text << toml::toml_formatter{concrete}; });
  std::string line = text.str();
  std::replace(line.begin(), line.end(), '\n', ' ');
  return shortened(line, 40);
}

}  // namespace brouwer
