#include "studies/reading/expectation_sections.hpp"

#include <fmt/format.h>

#include <brouwer/ensemble/catalogue.hpp>
#include <set>

namespace brouwer {
namespace {

/// An interval [low, high] of drifts per step.
Kind<Interval> band() {
  return {"a list [low, high] with low < high", [](toml::node const& node) -> std::optional<Interval> {
            auto const ends = numbers(2).read(node);
            if (!ends || !(ends->front() < ends->back())) return std::nullopt;
            return Interval{ends->front(), ends->back()};
          }};
}

std::vector<std::string> verdict_words() {
  std::vector<std::string> words;
  for (auto verdict : {Verdict::random_walk, Verdict::persistent_slopes, Verdict::drift, Verdict::bounded,
                       Verdict::faster_than_drift, Verdict::exact, Verdict::not_resolved})
    words.push_back(to_string(verdict));
  return words;
}

/// Quantities observed, and their components: what an expectation may be `of`.
std::vector<std::string> judged_names(Catalogue const& catalogue, Study const& study) {
  std::vector<std::string> names;
  for (auto const& quantity : study.quantities) {
    names.push_back(quantity);
    for (auto const& component : catalogue.quantity(study.system, quantity).components)
      if (component != quantity) names.push_back(component);
  }
  return names;
}

/// A level that some cell of the study runs; `level_of` takes it from a cell's labels.
template <class T, class LevelOf>
std::optional<T> level_run(Section& where, std::string const& key, Kind<T> const& kind,
                           std::vector<CellLabels> const& cells, LevelOf level_of) {
  auto const wanted = where.value(key, kind);
  if (!wanted) return std::nullopt;
  for (auto const& cell : cells)
    if (level_of(cell) == *wanted) return wanted;
  where.complain(key, fmt::format(" = {} matches nothing that this study runs", shown(*where.find(key))));
  return wanted;
}

template <class LevelOf>
std::vector<std::string> words_run(std::vector<CellLabels> const& cells, LevelOf level_of) {
  std::set<std::string> words;
  for (auto const& cell : cells) words.insert(level_of(cell));
  return {words.begin(), words.end()};
}

std::optional<std::string> word_run(Section& where, std::string const& key, std::string const& what,
                                    std::vector<CellLabels> const& cells, std::string CellLabels::*label) {
  auto const known = words_run(cells, [&](CellLabels const& cell) { return cell.*label; });
  return where.value(key, one_of(what + " in this study", known));
}

Selector read_selector(Section where, std::vector<CellLabels> const& cells) {
  Selector selector;
  selector.method = word_run(where, "method", "method", cells, &CellLabels::method);
  selector.arithmetic = word_run(where, "arithmetic", "arithmetic", cells, &CellLabels::arithmetic);
  selector.special_functions = word_run(where, "special_functions", "variant", cells, &CellLabels::special_functions);
  selector.compensation = level_run(where, "compensation", flag(), cells, [](auto const& c) { return c.compensation; });
  selector.step = level_run(where, "step", positive(), cells, [](auto const& c) { return c.step; });
  where.refuse_unknown_keys();
  return selector;
}

/// "none", or { per_step = [low, high] }.
void read_drift(Section& expect, Expectation& expectation) {
  using Wanted = Expectation::DriftWanted;
  toml::node const* node = expect.find("drift");
  if (!node) return;
  if (!node->is_table()) {
    if (expect.value("drift", one_of("drift", {"none"}))) expectation.drift = Wanted::none;
    return;
  }
  Section drift = expect.section("drift");
  if (auto const interval = drift.required("per_step", band())) {
    expectation.drift = Wanted::band;
    expectation.drift_band = *interval;
  }
  drift.refuse_unknown_keys();
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
  for (auto const* key : {"drift", "growth", "step_exponent", "persistence", "verdict"})
    if (expect.has(key)) return true;
  return false;
}

std::size_t steps_selected(Selector const& where, std::vector<CellLabels> const& cells) {
  std::set<double> steps;
  for (auto const& cell : cells)
    if (where.matches(cell)) steps.insert(cell.step);
  return steps.size();
}

/// An expectation that no cell can meet is a mistake of the file, not a pass.
void check_reach(Section& expect, Expectation const& expectation, std::vector<CellLabels> const& cells) {
  std::size_t const steps = steps_selected(expectation.where, cells);
  if (steps == 0) expect.complain("where", " matches no combination of levels that this study runs");
  if (expectation.step_exponent && steps > 0 && steps < 3)
    expect.complain("step_exponent", fmt::format(" needs at least three step sizes, the study runs {} there", steps));
}

Expectation read_expectation(Section& expect, std::vector<std::string> const& names,
                             std::vector<CellLabels> const& cells) {
  Expectation expectation;
  expectation.of = expect.required("of", one_of("observed quantity", names)).value_or("");
  expectation.where = read_selector(expect.section("where"), cells);
  read_drift(expect, expectation);
  expectation.growth = read_around(expect, "growth");
  expectation.step_exponent = read_around(expect, "step_exponent");
  expectation.persistence = read_persistence(expect);
  expectation.verdict = expect.levels("verdict", one_of("verdict", verdict_words()));
  expectation.level = expect.value("level", above_up_to(0, 0.5));
  expect.refuse_unknown_keys();
  if (!claims_something(expect))
    expect.complain("the expectation claims nothing, expected drift, growth, step_exponent, persistence or verdict");
  return expectation;
}

}  // namespace

std::vector<Expectation> read_expectations(toml::table const& file, Reading& reading, Catalogue const& catalogue,
                                           Study const& study, std::vector<CellLabels> const& cells) {
  toml::node const* node = file.get("expect");
  if (!node) return {};
  Section whole_file(reading, &file, "");
  if (!node->is_array_of_tables()) {
    whole_file.complain("expect", " = " + shown(*node) + ", expected tables [[expect]]");
    return {};
  }
  std::vector<Expectation> expectations;
  auto const names = judged_names(catalogue, study);
  for (auto const& element : *node->as_array()) {
    std::string const path = fmt::format("expect[{}]", expectations.size() + 1);
    Section expect(reading, element.as_table(), path, element.source());
    std::size_t const complaints = reading.complaints.size();
    expectations.push_back(read_expectation(expect, names, cells));
    expectations.back().line = static_cast<int>(element.source().begin.line);
    if (reading.complaints.size() == complaints) check_reach(expect, expectations.back(), cells);
  }
  return expectations;
}

}  // namespace brouwer
