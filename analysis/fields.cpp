#include "analysis/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <variant>

#include "analysis/escape.hpp"
#include "analysis/failures.hpp"
#include "analysis/numbers.hpp"

namespace brouwer {
namespace {

using Value = std::variant<std::string, bool, std::int64_t, double, Interval>;

/// A key, with a dot where json nests, and its value.
struct Field {
  char const* key;
  Value (*of)(Estimates const&);
};

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr Counted no_count = {undefined, {undefined, undefined}};

using E = Estimates;
Field const fields[] = {
    {"system", [](E const& e) -> Value { return e.cell.system; }},
    {"method", [](E const& e) -> Value { return e.cell.method; }},
    {"arithmetic", [](E const& e) -> Value { return e.cell.arithmetic; }},
    {"special_functions", [](E const& e) -> Value { return e.cell.special_functions; }},
    {"coefficients", [](E const& e) -> Value { return e.cell.coefficients; }},
    {"compensation", [](E const& e) -> Value { return e.cell.compensation; }},
    {"step", [](E const& e) -> Value { return e.cell.step; }},
    {"steps", [](E const& e) -> Value { return e.cell.steps; }},
    {"rounding", [](E const& e) -> Value { return e.cell.rounding; }},
    {"constants", [](E const& e) -> Value { return e.cell.constants; }},
    {"contraction", [](E const& e) -> Value { return e.cell.contraction; }},
    {"quantity", [](E const& e) -> Value { return e.quantity; }},
    {"family", [](E const& e) -> Value { return e.family; }},
    {"unit", [](E const& e) -> Value { return e.unit; }},
    {"members", [](E const& e) -> Value { return e.members; }},
    {"failed", [](E const& e) -> Value { return e.failed; }},
    {"failures", [](E const& e) -> Value { return reasons(e); }},
    {"samples", [](E const& e) -> Value { return e.samples; }},
    {"rms_final", [](E const& e) -> Value { return e.rms_final; }},
    {"drift.per_step", [](E const& e) -> Value { return e.drift.per_step; }},
    {"drift.ci", [](E const& e) -> Value { return e.drift.interval; }},
    {"drift.t", [](E const& e) -> Value { return e.drift.t; }},
    {"drift.p", [](E const& e) -> Value { return e.drift.p; }},
    {"drift.share", [](E const& e) -> Value { return e.drift.share; }},
    {"persistence.per_step", [](E const& e) -> Value { return e.persistence.per_step; }},
    {"persistence.F", [](E const& e) -> Value { return e.persistence.F; }},
    {"persistence.p", [](E const& e) -> Value { return e.persistence.p; }},
    {"persistence.p_low", [](E const& e) -> Value { return e.persistence.p_low; }},
    {"diffusion.per_sqrt_step", [](E const& e) -> Value { return e.diffusion.per_sqrt_step; }},
    {"diffusion.ci", [](E const& e) -> Value { return e.diffusion.interval; }},
    {"growth.exponent", [](E const& e) -> Value { return e.growth.exponent; }},
    {"growth.ci", [](E const& e) -> Value { return e.growth.interval; }},
    {"smallest_visible_drift", [](E const& e) -> Value { return e.smallest_visible_drift; }},
    {"count.mean", [](E const& e) -> Value { return e.count.value_or(no_count).mean; }},
    {"count.range", [](E const& e) -> Value { return e.count.value_or(no_count).range; }},
    {"levels.confidence", [](E const& e) -> Value { return e.levels.confidence; }},
    {"levels.test", [](E const& e) -> Value { return e.levels.test; }},
    {"levels.power", [](E const& e) -> Value { return e.levels.power; }},
    {"verdict", [](E const& e) -> Value { return to_string(e.verdict); }},
    {"sentence", [](E const& e) -> Value { return e.sentence; }},
};

struct AsJson {
  std::string operator()(std::string const& text) const { return json_string(text); }
  std::string operator()(bool yes) const { return yes ? "true" : "false"; }
  std::string operator()(std::int64_t n) const { return fmt::format("{}", n); }
  std::string operator()(double x) const { return std::isfinite(x) ? round_trip(x) : "null"; }
  std::string operator()(Interval i) const { return fmt::format("[{}, {}]", (*this)(i.low), (*this)(i.high)); }
};

/// Numbers that are not defined are empty cells, infinite ones are inf.
struct AsCsv {
  std::string operator()(std::string const& text) const { return csv_field(text); }
  std::string operator()(bool yes) const { return yes ? "true" : "false"; }
  std::string operator()(std::int64_t n) const { return fmt::format("{}", n); }
  std::string operator()(double x) const { return std::isnan(x) ? "" : round_trip(x); }
  std::string operator()(Interval i) const { return (*this)(i.low) + ',' + (*this)(i.high); }
};

/// "drift.per_step" → {"drift", "per_step"}; "steps" → {"", "steps"}.
std::pair<std::string, std::string> split(std::string const& key) {
  auto const dot = key.find('.');
  return dot == std::string::npos ? std::pair{std::string(), key} : std::pair{key.substr(0, dot), key.substr(dot + 1)};
}

/// What stands under one key of the row: a value, or an object where several fields share the part before the dot.
struct Entry {
  std::string group;
  std::vector<std::string> pairs;

  std::string text() const {
    std::string const inner = fmt::format("{}", fmt::join(pairs, ", "));
    return group.empty() ? inner : json_string(group) + ": {" + inner + "}";
  }
};

std::string json_row(Estimates const& row) {
  std::vector<Entry> entries;
  for (auto const& field : fields) {
    auto const [group, key] = split(field.key);
    if (group.empty() || entries.back().group != group) entries.push_back({group, {}});
    entries.back().pairs.push_back(json_string(key) + ": " + std::visit(AsJson{}, field.of(row)));
  }
  std::vector<std::string> lines;
  for (auto const& entry : entries) lines.push_back("    " + entry.text());
  return fmt::format("  {{\n{}\n  }}", fmt::join(lines, ",\n"));
}

std::string csv_heading(Field const& field) {
  std::string name = field.key;
  std::replace(name.begin(), name.end(), '.', '_');
  bool const interval = std::holds_alternative<Interval>(field.of(Estimates{}));
  return interval ? name + "_low," + name + "_high" : name;
}

template <class Text>
std::string csv_line(Text text) {
  std::vector<std::string> values;
  for (auto const& field : fields) values.push_back(text(field));
  return fmt::format("{}\n", fmt::join(values, ","));
}

}  // namespace

std::string fields_as_json(std::vector<Estimates> const& rows) {
  std::string text = "[";
  for (auto const& row : rows) text += (text.size() > 1 ? ",\n" : "\n") + json_row(row);
  return text + "\n]\n";
}

std::string fields_as_csv(std::vector<Estimates> const& rows) {
  std::string text = csv_line(csv_heading);
  for (auto const& row : rows) text += csv_line([&](Field const& field) { return std::visit(AsCsv{}, field.of(row)); });
  return text;
}

}  // namespace brouwer
