#include "studies/reading/expectation_sections.hpp"

#include <fmt/format.h>

#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/ensemble/operations.hpp>

#include "analysis/expectations/expectations.hpp"
#include "studies/reading/limits.hpp"
#include "studies/reading/names.hpp"

namespace brouwer {
namespace {

/// An interval [low, high].
Kind<Interval> band() {
  return {"a list [low, high] with low < high", [](toml::node const& node) -> std::optional<Interval> {
            auto const ends = numbers(2).read(node);
            if (!ends || !(ends->front() < ends->back())) return std::nullopt;
            return Interval{ends->front(), ends->back()};
          }};
}

/// Quantities and their components: what an expectation may be `of`.
std::vector<std::string> with_components(std::vector<Quantity> const& quantities) {
  std::vector<std::string> names;
  for (auto const& quantity : quantities) {
    names.push_back(quantity.name);
    for (auto const& component : quantity.components)
      if (component != quantity.name) names.push_back(component);
  }
  return names;
}

/// The levels of an option that only some methods have, and that of the others.
std::vector<std::string> or_none(std::vector<std::string> levels) {
  levels.emplace_back(no_level);
  return levels;
}

/// One step size, or those from one to another: { from = 0.02, to = 0.2 }.
void read_step(Section& where, Selector& selector) {
  toml::node const* node = where.find("step");
  if (!node || !node->is_table()) {
    Kind<double> one = positive();
    one.expected += ", or { from = …, to = … }";
    selector.step = where.value("step", one);
    return;
  }
  Section range = where.section("step");
  auto const from = range.required("from", positive()), to = range.required("to", positive());
  if (from && to) selector.step_range = Interval{*from, *to};
  if (from && to && *from > *to) range.complain(fmt::format("{}: from is larger than to", range.path()));
  range.refuse_unknown_keys();
}

Selector read_selector(Section where, Catalogue const& catalogue, std::string const& system) {
  Selector selector;
  selector.method = where.value("method", one_of("method", method_names(catalogue, system)));
  selector.arithmetic = where.value("arithmetic", one_of("arithmetic", names_of(catalogue.arithmetics)));
  selector.special_functions =
      where.value("special_functions", one_of("variant", or_none(special_function_variants())));
  selector.coefficients =
      where.value("coefficients", one_of("level of coefficients", or_none(coefficient_levels(catalogue, system))));
  selector.compensation = where.value("compensation", flag());
  selector.rounding = where.value("rounding", one_of("rounding", rounding_levels()));
  selector.constants = where.value("constants", one_of("kind of constants", constants_levels()));
  selector.contraction = where.value("contraction", flag());
  read_step(where, selector);
  where.refuse_unknown_keys();
  return selector;
}

/// "none", { per_step = [low, high] } or { smaller_than = 1e-19 }.
void read_drift(Section& expect, Expectation& expectation) {
  using Wanted = Expectation::DriftWanted;
  toml::node const* node = expect.find("drift");
  if (!node) return;
  if (!node->is_table()) {
    if (expect.value("drift", one_of("drift", {"none"}))) expectation.drift = Wanted::none;
    return;
  }
  Section drift = expect.section("drift");
  auto const interval = drift.value("per_step", band());
  auto const bound = drift.value("smaller_than", positive());
  if (interval) expectation.drift_band = *interval;
  if (bound) expectation.drift_bound = *bound;
  expectation.drift = bound ? Wanted::smaller_than : interval ? Wanted::band : Wanted::unsaid;
  drift.refuse_unknown_keys();
  if (drift.has("per_step") == drift.has("smaller_than"))
    drift.complain(drift.path() + ": expected one of per_step, smaller_than");
}

/// { exponent = 0.5, within = 0.05 }.
std::optional<Around> read_around(Section& expect, std::string const& key) {
  if (!expect.has(key)) return std::nullopt;
  Section around = expect.section(key);
  if (!around.present()) return std::nullopt;
  auto const exponent = around.required("exponent", number());
  auto const within = around.required("within", positive());
  around.refuse_unknown_keys();
  if (!exponent || !within) return std::nullopt;
  return Around{*exponent, *within};
}

std::optional<bool> read_persistence(Section& expect) {
  auto const word = expect.value("persistence", one_of("persistence", {"none", "present"}));
  return word ? std::optional(*word == "present") : std::nullopt;
}

bool claims_something(Section& expect) {
  for (auto const* key : {"drift", "growth", "step_exponent", "persistence", "verdict", "mean", "rms", "failed"})
    if (expect.has(key)) return true;
  return false;
}

Expectation read_expectation(Section& expect, Catalogue const& catalogue, std::string const& system) {
  Expectation expectation;
  auto const names = with_components(catalogue.system(system).quantities);
  expectation.of = expect.required("of", one_of("quantity", names)).value_or("");
  expectation.where = read_selector(expect.section("where"), catalogue, system);
  read_drift(expect, expectation);
  expectation.growth = read_around(expect, "growth");
  expectation.step_exponent = read_around(expect, "step_exponent");
  expectation.persistence = read_persistence(expect);
  expectation.verdict = expect.levels("verdict", one_of("verdict", verdict_words()));
  expectation.mean = expect.value("mean", band());
  expectation.rms_final = expect.value("rms", band());
  expectation.failed = expect.value("failed", whole(0, most_members));
  expectation.level = expect.value("level", above_up_to(0, 0.5));
  expect.refuse_unknown_keys();
  if (!claims_something(expect))
    expect.complain(
        "the expectation claims nothing, expected drift, growth, step_exponent, "
        "persistence, verdict, mean, rms or failed");
  return expectation;
}

}  // namespace

std::vector<Expectation> read_expectations(Section& root, Reading& reading, Catalogue const& catalogue,
                                           std::string const& system, std::optional<double> level) {
  toml::node const* node = root.find("expect");
  if (!node) return {};
  if (!node->is_array_of_tables()) {
    root.complain("expect", fmt::format(" = {}, expected tables [[expect]]", shown(*node)));
    return {};
  }
  std::vector<Expectation> expectations;
  for (auto const& element : *node->as_array()) {
    std::string const path = fmt::format("expect[{}]", expectations.size() + 1);
    Section expect(reading, element.as_table(), path, element.source());
    expectations.push_back(read_expectation(expect, catalogue, system));
    if (!expectations.back().level) expectations.back().level = level;
    expectations.back().line = static_cast<int>(element.source().begin.line);
  }
  return expectations;
}

}  // namespace brouwer
