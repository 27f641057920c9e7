#include "studies/reading/reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/spelling.hpp>
#include <map>
#include <set>

namespace brouwer {
namespace {

bool observed(std::string const& name, Study const& study, Catalogue const& catalogue) {
  return std::any_of(study.quantities.begin(), study.quantities.end(), [&](std::string const& quantity) {
    auto const& components = catalogue.quantity(study.system, quantity).components;
    return quantity == name || contains(components, name);
  });
}

/// "method = a is not run; run are b, c", where the level is given and no cell has it.
template <class T, class LevelOf>
std::optional<std::string> not_run(char const* factor, std::optional<T> const& wanted,
                                   std::vector<CellLabels> const& cells, LevelOf level_of) {
  if (!wanted) return std::nullopt;
  std::set<T> run;
  for (auto const& cell : cells) run.insert(level_of(cell));
  if (run.contains(*wanted)) return std::nullopt;
  return fmt::format("{} = {} is not run by this study, run are {}", factor, *wanted, fmt::join(run, ", "));
}

std::optional<std::string> level_not_run(Selector const& where, std::vector<CellLabels> const& cells) {
  if (auto no = not_run("method", where.method, cells, [](auto const& c) { return c.method; })) return no;
  if (auto no = not_run("arithmetic", where.arithmetic, cells, [](auto const& c) { return c.arithmetic; })) return no;
  if (auto no = not_run("special_functions", where.special_functions, cells,
                        [](auto const& c) { return c.special_functions; }))
    return no;
  if (auto no = not_run("coefficients", where.coefficients, cells, [](auto const& c) { return c.coefficients; }))
    return no;
  if (auto no = not_run("compensation", where.compensation, cells, [](auto const& c) { return c.compensation; }))
    return no;
  if (auto no = not_run("rounding", where.rounding, cells, [](auto const& c) { return c.rounding; })) return no;
  if (auto no = not_run("constants", where.constants, cells, [](auto const& c) { return c.constants; })) return no;
  if (auto no = not_run("contraction", where.contraction, cells, [](auto const& c) { return c.contraction; }))
    return no;
  return not_run("step", where.step, cells, [](auto const& c) { return c.step; });
}

/// The most step sizes h that selected cells, alike in every other factor, have.
std::size_t longest_sweep(Selector const& where, std::vector<CellLabels> const& cells) {
  std::map<std::string, std::set<double>> sweeps;
  for (auto const& cell : cells)
    if (where.matches(cell))
      sweeps[fmt::format("{} {} {} {} {} {} {} {}", cell.method, cell.arithmetic, cell.special_functions,
                         cell.coefficients, cell.compensation, cell.rounding, cell.constants, cell.contraction)]
          .insert(cell.step);
  std::size_t most = 0;
  for (auto const& [others, steps] : sweeps) most = std::max(most, steps.size());
  return most;
}

/// Of a quantity or a component.
Quantity const& quantity_of(std::string const& name, Study const& study, Catalogue const& catalogue) {
  for (auto const& quantity : catalogue.system(study.system).quantities)
    if (quantity.name == name || contains(quantity.components, name)) return quantity;
  return catalogue.quantity(study.system, name);
}

/// A count has a mean, and no law of growth; and only some methods have one.
std::optional<std::string> asked_of_a_count(Expectation const& e, Study const& study, Catalogue const& catalogue,
                                            std::vector<CellLabels> const& cells) {
  if (quantity_of(e.of, study, catalogue).kind != Quantity::Kind::iterations) return std::nullopt;
  bool const law = e.drift != Expectation::DriftWanted::unsaid || e.growth || e.step_exponent || e.persistence;
  if (law || !e.verdict.empty())
    return fmt::format("'{}' is a count, which has no drift and no law of growth; expected mean or rms", e.of);
  bool const counted = std::any_of(cells.begin(), cells.end(), [&](CellLabels const& cell) {
    return e.where.matches(cell) && catalogue.method(cell.system, cell.method).counts_iterations;
  });
  if (!counted) return fmt::format("no method that 'where' selects counts '{}'", e.of);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> out_of_reach(Expectation const& expectation, Study const& study, Catalogue const& catalogue,
                                        std::vector<CellLabels> const& cells) {
  if (!observed(expectation.of, study, catalogue))
    return fmt::format("'{}' is not observed by this study, observed are {}", expectation.of,
                       fmt::join(study.quantities, ", "));
  if (auto no = level_not_run(expectation.where, cells)) return fmt::format("where.{}", *no);
  std::size_t const sweep = longest_sweep(expectation.where, cells);
  if (sweep == 0) return "'where' matches no combination of levels that this study runs";
  if (auto no = asked_of_a_count(expectation, study, catalogue, cells)) return no;
  if (expectation.rms_final && expectation.rms_final->high <= 0)
    return "rms is never below 0, expected [low, high] with high > 0";
  if (expectation.step_exponent && sweep < 3)
    return fmt::format("step_exponent needs at least three step sizes, this study runs {} there", sweep);
  return std::nullopt;
}

}  // namespace brouwer
