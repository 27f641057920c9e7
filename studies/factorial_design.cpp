#include "studies/factorial_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/ensemble/operations.hpp>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <optional>

#include "analysis/escape.hpp"
#include "analysis/explain.hpp"

namespace brouwer {
namespace {

using Words = std::vector<std::string>;
using Overrides = std::vector<Override>;

/// A list in TOML, of words or of flags.
std::string toml_list(Words const& levels) {
  Words quoted;
  for (auto const& level : levels) quoted.push_back(level == "true" || level == "false" ? level : json_string(level));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

Override levels(std::string const& key, Words const& values) {
  return {key, toml_list(values), fmt::format("the design's {} = {}", key, toml_list(values))};
}

std::string flag_word(bool flag) { return flag ? "true" : "false"; }

/// All levels but this one.
Words others(Words levels, std::string const& nominal) {
  std::erase(levels, nominal);
  return levels;
}

/// What is nominal in a study, and which factors are changed around it.
class AroundNominal {
 public:
  AroundNominal(StudyFile const& file, Catalogue const& catalogue, Words const& factors)
      : study_(file.study), catalogue_(catalogue), factors_(factors.empty() ? design_factors() : factors) {}

  bool asks_for(std::string const& factor) const { return contains(factors_, factor); }
  std::string const& rounding() const { return study_.rounding.front(); }
  std::string const& arithmetic() const { return study_.arithmetics.front(); }

  /// The first level of every factor.
  Overrides nominal() const {
    Overrides pinned = {levels("integrate.arithmetic", {arithmetic()}),
                        levels("integrate.special_functions", {study_.special_functions.front()}),
                        levels("integrate.compensation", {flag_word(study_.compensation.front())}),
                        levels("integrate.rounding", {rounding()}),
                        levels("integrate.constants", {study_.constants.front()}),
                        levels("integrate.contraction", {flag_word(study_.contraction.front())})};
    if (!study_.coefficients.empty()) pinned.push_back(levels("integrate.coefficients", nominal_coefficients()));
    return pinned;
  }

  /// The full factorial over what can be changed in every operation.
  Overrides operations() const {
    Overrides changed;
    auto const cross = [&](char const* factor, char const* key, std::string const& own, std::string const& other) {
      if (asks_for(factor)) changed.push_back(levels(key, {own, other}));
    };
    cross("constants", "integrate.constants", study_.constants.front(),
          study_.constants.front() == "exact" ? "rounded" : "exact");
    cross("rounding", "integrate.rounding", rounding(), other_rounding(rounding()));
    cross("compensation", "integrate.compensation", flag_word(study_.compensation.front()),
          flag_word(!study_.compensation.front()));
    return changed;
  }

  Overrides other_roundings() const {
    return {levels("integrate.rounding", others(others(rounding_levels(), rounding()), other_rounding(rounding())))};
  }

  Overrides contraction() const { return {levels("integrate.contraction", {flag_word(!study_.contraction.front())})}; }

  /// Of the methods that have others than the nominal; nothing where none has.
  Overrides coefficients() const {
    Words other, methods;
    for (auto const& method : study_.methods) {
      auto const rest = others(entry(method).coefficients, coefficients_of(method));
      if (!rest.empty()) methods.push_back(method);
      for (auto const& level : rest)
        if (!contains(other, level)) other.push_back(level);
    }
    if (methods.empty()) return {};
    return {levels("integrate.methods", methods), levels("integrate.coefficients", other)};
  }

  Overrides functions() const {
    Words methods;
    for (auto const& method : study_.methods)
      if (entry(method).uses_special_functions) methods.push_back(method);
    if (methods.empty()) return {};
    return {
        levels("integrate.methods", methods),
        levels("integrate.special_functions", others(special_function_variants(), study_.special_functions.front()))};
  }

  Overrides lower_precision() const {
    auto const* const lower = next_arithmetic(false);
    return lower ? Overrides{levels("integrate.arithmetic", {lower->name})} : Overrides{};
  }

  Overrides higher_precision() const {
    auto const* const higher = next_arithmetic(true);
    if (!higher) return {};
    Overrides changed = {levels("integrate.arithmetic", {higher->name})};
    auto const& reference = study_.reference;
    if (reference.kind != Reference::Kind::same_method ||
        catalogue_.arithmetic(reference.arithmetic).bits > higher->bits)
      return changed;
    Words quantities;
    for (auto const& name : study_.quantities)
      if (!catalogue_.quantity(study_.system, name).needs_reference()) quantities.push_back(name);
    if (quantities.empty()) return {};
    changed.push_back({"observe.reference", "\"none\"", "the design's observe.reference"});
    changed.push_back(levels("observe.quantities", quantities));
    return changed;
  }

 private:
  MethodEntry const& entry(std::string const& method) const { return catalogue_.method(study_.system, method); }

  /// The nominal level of a method that has any; "" of one that has none.
  std::string coefficients_of(std::string const& method) const {
    auto const& own = entry(method).coefficients;
    for (auto const& level : study_.coefficients)
      if (contains(own, level)) return level;
    return own.empty() ? "" : own.front();
  }

  Words nominal_coefficients() const {
    Words nominal;
    for (auto const& method : study_.methods)
      if (auto const level = coefficients_of(method); !level.empty() && !contains(nominal, level))
        nominal.push_back(level);
    return nominal;
  }

  /// Of so many more bits that truncation is told from round-off, or of fewer.
  ArithmeticEntry const* next_arithmetic(bool higher) const {
    static Words const chain = {"float", "double", "double-double", "mpfr-256", "mpfr-512"};
    int const own = catalogue_.arithmetic(arithmetic()).bits;
    ArithmeticEntry const* next = nullptr;
    for (auto const& name : chain) {
      auto const& other = catalogue_.arithmetic(name);
      if (!higher && other.bits < own) next = &other;
      if (higher && !next && 2 * other.bits >= 3 * own) next = &other;
    }
    return next;
  }

  Study const& study_;
  Catalogue const& catalogue_;
  Words factors_;
};

/// A part beside the first: the factor that asks for it, and what it changes of the nominal study.
struct PartOf {
  char const* name;
  char const* factor;
  Overrides (AroundNominal::*changes)() const;
};
constexpr PartOf further_parts[] = {
    {"rounding", "rounding", &AroundNominal::other_roundings},
    {"contraction", "contraction", &AroundNominal::contraction},
    {"coefficients", "coefficients", &AroundNominal::coefficients},
    {"special-functions", "special_functions", &AroundNominal::functions},
    {"lower-precision", "precision", &AroundNominal::lower_precision},
    {"higher-precision", "precision", &AroundNominal::higher_precision},
};

Overrides joined(Overrides all, Overrides const& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// The study has been read without a complaint: what is refused now is a level that does not exist there.
std::optional<StudyFile> read_if_it_exists(std::filesystem::path const& file, Catalogue const& catalogue,
                                           Overrides const& overrides, Words& left_out) {
  try {
    return read_study(file, catalogue, overrides);
  } catch (InputError const& error) {
    left_out.emplace_back(error.what());
    return std::nullopt;
  }
}

bool is_nominal(CellLabels const& cell, StudyFile const& base) {
  Study const& study = base.study;
  return cell.rounding == study.rounding.front() && cell.constants == study.constants.front() &&
         cell.compensation == study.compensation.front();
}

void check(Words const& factors) {
  for (auto const& factor : factors)
    if (!contains(design_factors(), factor))
      throw InputError(
          fmt::format("--factors: there is no factor '{}'{}", factor, suggestion(factor, design_factors())));
}

}  // namespace

std::vector<std::string> const& design_factors() {
  static Words const factors = {"constants",    "rounding",          "compensation", "contraction",
                                "coefficients", "special_functions", "precision"};
  return factors;
}

bool same_question(CellLabels const& a, CellLabels const& b) {
  return a.system == b.system && a.method == b.method && a.step == b.step && a.steps == b.steps;
}

FactorialDesign design_around(std::filesystem::path const& file, Catalogue const& catalogue,
                              std::vector<Override> const& overrides, std::vector<std::string> const& factors) {
  check(factors);
  StudyFile const base = read_study(file, catalogue, overrides);
  AroundNominal const around(base, catalogue, factors);
  auto const pinned = joined(overrides, around.nominal());
  FactorialDesign design;
  design.parts.push_back({"operations", read_study(file, catalogue, joined(pinned, around.operations()))});
  for (auto const& part : further_parts) {
    auto const changes = (around.*part.changes)();
    if (!around.asks_for(part.factor) || changes.empty()) continue;
    if (auto study = read_if_it_exists(file, catalogue, joined(pinned, changes), design.left_out))
      design.parts.push_back({part.name, std::move(*study)});
  }
  for (auto const& cell : design.parts.front().study.plan.cells)
    if (is_nominal(cell, base)) design.nominal.push_back(cell);
  return design;
}

}  // namespace brouwer
