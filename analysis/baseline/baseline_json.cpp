// A baseline as text and back. Numbers pass as text through the parser, so that no digit is lost.
#include <fmt/format.h>

#include <boost/property_tree/json_parser.hpp>
#include <brouwer/error.hpp>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <variant>

#include "analysis/baseline/baseline.hpp"
#include "analysis/escape.hpp"

namespace brouwer {
namespace {

using Tree = boost::property_tree::ptree;

constexpr char const* format = "brouwer baseline 1";

// --- what a row holds -----------------------------------------------------------------------------

template <class T>
using OfRow = T BaselineRow::*;
template <class T>
using OfCell = T CellLabels::*;
using Place = std::variant<OfCell<std::string>, OfCell<bool>, OfCell<double>, OfCell<std::int64_t>, OfRow<std::string>,
                           OfRow<std::int64_t>, OfRow<double>, OfRow<std::vector<double>>>;

/// A key of a row, and where its value stands.
struct Field {
  char const* key;
  Place place;
};

using C = CellLabels;
using R = BaselineRow;
Field const fields[] = {
    {"system", &C::system},
    {"method", &C::method},
    {"arithmetic", &C::arithmetic},
    {"special_functions", &C::special_functions},
    {"coefficients", &C::coefficients},
    {"compensation", &C::compensation},
    {"rounding", &C::rounding},
    {"constants", &C::constants},
    {"contraction", &C::contraction},
    {"step", &C::step},
    {"steps", &C::steps},
    {"quantity", &R::quantity},
    {"unit", &R::unit},
    {"time_unit", &R::time_unit},
    {"digest", &R::digest},
    {"members", &R::members},
    {"failed", &R::failed},
    {"samples", &R::samples},
    {"duration", &R::duration},
    {"verdict", &R::verdict},
    {"rms_final", &R::rms_final},
    {"drift", &R::drift},
    {"drift_low", &R::drift_low},
    {"drift_high", &R::drift_high},
    {"diffusion", &R::diffusion},
    {"diffusion_low", &R::diffusion_low},
    {"diffusion_high", &R::diffusion_high},
    {"persistence", &R::persistence},
    {"persistence_low", &R::persistence_low},
    {"persistence_high", &R::persistence_high},
    {"F", &R::F},
    {"noise", &R::noise},
    {"noise_low", &R::noise_low},
    {"noise_high", &R::noise_high},
    {"exponent", &R::exponent},
    {"exponent_low", &R::exponent_low},
    {"exponent_high", &R::exponent_high},
    {"count_mean", &R::count_mean},
    {"slope_mean", &R::slope_mean},
    {"slope_error", &R::slope_error},
    {"slope_variance", &R::slope_variance},
    {"slope_spread", &R::slope_spread},
    {"slope_spread_error", &R::slope_spread_error},
    {"increment_size", &R::increment_size},
    {"increment_log_error", &R::increment_log_error},
    {"exponent_error", &R::exponent_error},
    {"slopes", &R::slopes},
};

/// What a place refers to, in a row that may be constant.
template <class T, class Row>
auto& at(OfRow<T> place, Row& row) {
  return row.*place;
}
template <class T, class Row>
auto& at(OfCell<T> place, Row& row) {
  return row.cell.*place;
}

// --- writing --------------------------------------------------------------------------------------

std::string json(std::string const& text) { return json_string(text); }
std::string json(bool yes) { return yes ? "true" : "false"; }
std::string json(std::int64_t n) { return fmt::format("{}", n); }
std::string json(double x) { return std::isfinite(x) ? fmt::format("{}", x) : "null"; }
std::string json(std::vector<double> const& numbers) {
  std::vector<std::string> words;
  for (double const x : numbers) words.push_back(json(x));
  return fmt::format("[{}]", fmt::join(words, ", "));
}

std::string json(BaselineRow const& row) {
  std::vector<std::string> pairs;
  for (auto const& [key, place] : fields)
    pairs.push_back(json_string(key) + ": " + std::visit([&](auto p) { return json(at(p, row)); }, place));
  return fmt::format("        {{{}}}", fmt::join(pairs, ", "));
}

std::string json_lines(std::string const& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back("        " + json_string(line));
  return fmt::format("[\n{}\n      ]", fmt::join(lines, ",\n"));
}

std::string json(BaselineEntry const& entry) {
  std::vector<std::string> rows, provenance;
  for (auto const& row : entry.rows) rows.push_back(json(row));
  for (auto const& [key, value] : entry.provenance)
    provenance.push_back("        " + json_string(key) + ": " + json_string(value));
  return fmt::format(
      "    {{\n      \"label\": {},\n      \"date\": {},\n      \"study_hash\": {},\n      \"study\": {},\n"
      "      \"provenance\": {{\n{}\n      }},\n      \"rows\": [\n{}\n      ]\n    }}",
      json(entry.label), json(entry.date), json(entry.study_hash), json_lines(entry.study),
      fmt::join(provenance, ",\n"), fmt::join(rows, ",\n"));
}

// --- reading --------------------------------------------------------------------------------------

/// A part of the file, with the words that lead to it.
struct Part {
  Tree const& tree;
  std::string where;

  [[noreturn]] void complain(std::string const& what) const { throw InputError(where + ": " + what); }

  Part child(std::string const& key) const {
    auto const found = tree.find(key);
    if (found == tree.not_found()) complain(fmt::format("'{}' is missing; is this a baseline?", key));
    return {found->second, fmt::format("{}: {}", where, key)};
  }
  std::string text(std::string const& key) const { return child(key).tree.data(); }
};

template <class Number>
Number number(Part const& part) {
  auto const& text = part.tree.data();
  Number value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    part.complain(fmt::format("expected a number, found '{}'", one_line(text)));
  return value;
}

void read(Part const& part, std::string& value) { value = part.tree.data(); }
void read(Part const& part, std::int64_t& value) { value = number<std::int64_t>(part); }
void read(Part const& part, double& value) {
  value = part.tree.data() == "null" ? std::numeric_limits<double>::quiet_NaN() : number<double>(part);
}
void read(Part const& part, bool& value) {
  value = part.tree.data() == "true";
  if (!value && part.tree.data() != "false")
    part.complain(fmt::format("expected true or false, found '{}'", one_line(part.tree.data())));
}
void read(Part const& part, std::vector<double>& numbers) {
  for (auto const& [key, tree] : part.tree) read(Part{tree, part.where}, numbers.emplace_back());
}

BaselineRow row_of(Part const& part) {
  BaselineRow row;
  for (auto const& [key, place] : fields)
    std::visit([&, name = key](auto p) { read(part.child(name), at(p, row)); }, place);
  return row;
}

BaselineEntry entry_of(Part const& part) {
  BaselineEntry entry{part.text("label"), part.text("date"), part.text("study_hash"), {}, {}, {}};
  for (auto const& [key, line] : part.child("study").tree) entry.study += line.data() + '\n';
  for (auto const& [key, value] : part.child("provenance").tree) entry.provenance.emplace_back(key, value.data());
  for (auto const& [key, row] : part.child("rows").tree)
    entry.rows.push_back(row_of({row, fmt::format("{}: row {}", part.where, entry.rows.size() + 1)}));
  return entry;
}

/// The parser calls itself for each level; a file of brackets alone would exhaust the stack.
void refuse_depth(std::string const& text, std::string const& file) {
  constexpr int most = 16;
  int depth = 0;
  for (char const c : text) {
    depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    if (depth > most) throw InputError(file + ": is no baseline: it is nested too deeply");
  }
}

Tree parsed(std::string const& text, std::string const& file) {
  refuse_depth(text, file);
  Tree tree;
  std::istringstream stream(text);
  try {
    boost::property_tree::read_json(stream, tree);
  } catch (boost::property_tree::json_parser_error const& error) {
    throw InputError(fmt::format("{}:{}: is no JSON: {}", file, error.line(), error.message()));
  }
  return tree;
}

}  // namespace

std::string to_json(Baseline const& baseline) {
  std::vector<std::string> entries;
  for (auto const& entry : baseline.entries) entries.push_back(json(entry));
  return fmt::format("{{\n  \"format\": {},\n  \"study\": {},\n  \"entries\": [\n{}\n  ]\n}}\n", json_string(format),
                     json_string(baseline.name), fmt::join(entries, ",\n"));
}

Baseline baseline_of_json(std::string const& text, std::string const& file) {
  Tree const tree = parsed(text, file);
  Part const whole{tree, file};
  if (whole.text("format") != format)
    whole.complain(fmt::format("expected the format '{}', found '{}'", format, one_line(whole.text("format"))));
  Baseline baseline{whole.text("study"), {}};
  for (auto const& [key, entry] : whole.child("entries").tree)
    baseline.entries.push_back(entry_of({entry, fmt::format("{}: entry {}", file, baseline.entries.size() + 1)}));
  if (baseline.entries.empty()) whole.complain("nothing is recorded in it");
  return baseline;
}

}  // namespace brouwer
