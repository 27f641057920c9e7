#include "studies/factorial_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/ensemble/operations.hpp>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <optional>

#include "analysis/causes/explain.hpp"
#include "analysis/escape.hpp"

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
  /// @param methods  of the study: those that have the nominal sum
  AroundNominal(Study study, Catalogue const& catalogue, Words const& factors, Words const& methods, bool compensation)
      : study_(std::move(study)), catalogue_(catalogue), factors_(factors.empty() ? design_factors() : factors) {
    study_.methods = methods;
    study_.compensation = {compensation};
  }

  bool asks_for(std::string const& factor) const { return contains(factors_, factor); }
  std::string const& rounding() const { return study_.rounding.front(); }
  std::string const& arithmetic() const { return study_.arithmetics.front(); }

  /// The first level of every factor.
  Overrides nominal() const {
    Overrides pinned = {levels("integrate.methods", study_.methods),
                        levels("integrate.arithmetic", {arithmetic()}),
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
    return lower ? in(*lower) : Overrides{};
  }

  Overrides higher_precision() const {
    auto const* const higher = next_arithmetic(true);
    if (!higher) return {};
    Overrides changed = in(*higher);
    if (!outgrows_reference()) return changed;
    if (quantities(false).empty()) return {};
    changed.push_back({"observe.reference", "\"none\"", "the design's observe.reference"});
    changed.push_back(levels("observe.quantities", quantities(false)));
    return changed;
  }

  /// What is not observed in higher precision, and why.
  Words unobserved() const {
    auto const* const higher = next_arithmetic(true);
    if (!higher || !outgrows_reference()) return {};
    Words reasons;
    for (auto const& name : quantities(true))
      reasons.push_back(
          fmt::format("{} in {}: its reference is in {}", name, higher->name, study_.reference.arithmetic));
    return reasons;
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

  /// Another arithmetic, with what exists in all of them: what else rounding, constants and functions do there is of the size of
  /// its own round-off.
  Overrides in(ArithmeticEntry const& other) const {
    Overrides changed = {levels("integrate.arithmetic", {other.name}), levels("integrate.rounding", {"nearest"}),
                         levels("integrate.constants", {"rounded"}), levels("integrate.contraction", {"false"})};
    if (!variant_exists(study_.special_functions.front(), other.name))
      changed.push_back(levels("integrate.special_functions", {"own"}));
    return changed;
  }

  bool outgrows_reference() const {
    auto const& reference = study_.reference;
    auto const* const higher = next_arithmetic(true);
    return reference.kind == Reference::Kind::same_method && higher &&
           catalogue_.arithmetic(reference.arithmetic).bits <= higher->bits;
  }

  Words quantities(bool with_reference) const {
    Words names;
    for (auto const& name : study_.quantities)
      if (catalogue_.quantity(study_.system, name).needs_reference() == with_reference) names.push_back(name);
    return names;
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

  Study study_;
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

/// "rounding: a step with rounding up exists in float and double only": what is refused of a study that was read without a
/// complaint is a level that does not exist there.
std::string reason_of(char const* part, std::string const& complaint) {
  std::string const words = "nothing is left to run: ";
  auto const at = complaint.find(words);
  return fmt::format("{}: {}", part, at == std::string::npos ? complaint : complaint.substr(at + words.size()));
}

std::optional<StudyFile> read_part(char const* part, std::filesystem::path const& file, Catalogue const& catalogue,
                                   Overrides const& overrides, Words& left_out) {
  try {
    return read_study(file, catalogue, overrides);
  } catch (InputError const& error) {
    left_out.push_back(reason_of(part, error.what()));
    return std::nullopt;
  }
}

bool is_nominal(CellLabels const& cell, Study const& study, bool compensation) {
  return cell.rounding == study.rounding.front() && cell.constants == study.constants.front() &&
         cell.compensation == compensation;
}

void check(Words const& factors) {
  for (auto const& factor : factors)
    if (!contains(design_factors(), factor))
      throw InputError(
          fmt::format("--factors: there is no factor '{}'{}", factor, suggestion(factor, design_factors())));
}

/// The methods of a study whose nominal sum is this: a method without an increment has plain sums only.
Words methods_with(bool compensation, Study const& study, Catalogue const& catalogue) {
  bool const wanted = study.compensation.front();
  Words methods;
  for (auto const& method : study.methods)
    if ((wanted && catalogue.method(study.system, method).compensable) == compensation) methods.push_back(method);
  return methods;
}

/// Adds the parts of the methods that have the same nominal sum.
void add_parts(FactorialDesign& design, StudyFile const& base, Catalogue const& catalogue, Overrides const& overrides,
               Words const& factors, bool compensation) {
  auto const methods = methods_with(compensation, base.study, catalogue);
  if (methods.empty()) return;
  AroundNominal const around(base.study, catalogue, factors, methods, compensation);
  std::string const suffix = compensation || !base.study.compensation.front() ? "" : "-plain";
  auto const pinned = joined(overrides, around.nominal());
  design.parts.push_back(
      {"operations" + suffix, read_study(base.path, catalogue, joined(pinned, around.operations()))});
  for (auto const& cell : design.parts.back().study.plan.cells)
    if (is_nominal(cell, base.study, compensation)) design.nominal.push_back(cell);
  for (auto const& part : further_parts) {
    auto const changes = (around.*part.changes)();
    if (!around.asks_for(part.factor) || changes.empty()) continue;
    if (auto study = read_part(part.name, base.path, catalogue, joined(pinned, changes), design.left_out))
      design.parts.push_back({part.name + suffix, std::move(*study)});
  }
  if (around.asks_for("precision"))
    for (auto const& reason : around.unobserved())
      if (!contains(design.left_out, reason)) design.left_out.push_back(reason);
}

/// Is every quantity a number of something?
void check_that_errors_are_observed(StudyFile const& base, Catalogue const& catalogue) {
  auto const is_count = [&](std::string const& name) {
    return catalogue.quantity(base.study.system, name).kind == Quantity::Kind::iterations;
  };
  if (std::all_of(base.study.quantities.begin(), base.study.quantities.end(), is_count))
    throw InputError(fmt::format("{}: {} has no law of growth to explain; expected an error among observe.quantities",
                                 base.path.string(), fmt::join(base.study.quantities, ", ")));
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
  check_that_errors_are_observed(base, catalogue);
  FactorialDesign design;
  for (bool const compensation : {true, false}) add_parts(design, base, catalogue, overrides, factors, compensation);
  return design;
}

}  // namespace brouwer
