#include <brouwer/ensemble/plan.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include <brouwer/ensemble/operations.hpp>
#include <brouwer/ensemble/start.hpp>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <brouwer/store/folder.hpp>

namespace brouwer {
namespace {

constexpr std::int64_t most_steps = 1'000'000'000'000'000;  // 10^15: exact as a double, and more than anyone waits for

std::int64_t steps_of(Study const& study, double h) {
  if (study.steps) return *study.steps;
  double const steps = std::round(*study.until / h);
  if (!(steps >= 1 && steps <= static_cast<double>(most_steps)))
    throw InputError(
        fmt::format("until = {} with step = {} makes {} steps; expected 1 to {}", *study.until, h, steps, most_steps));
  return static_cast<std::int64_t>(steps);
}

/// The variants of elliptic functions that a method has: those of the study, or none.
std::vector<std::string> variants_of(MethodEntry const& method, Study const& study) {
  return method.uses_special_functions ? study.special_functions : std::vector<std::string>{no_level};
}

/// The levels of coefficients that a method has: those of the study, its first where the study names none of its own, or
/// none.
std::vector<std::string> coefficients_of(MethodEntry const& method, Study const& study) {
  if (method.coefficients.empty()) return {no_level};
  std::vector<std::string> levels;
  for (auto const& level : study.coefficients)
    if (contains(method.coefficients, level)) levels.push_back(level);
  return levels.empty() ? std::vector<std::string>{method.coefficients.front()} : levels;
}

/// Every combination of levels in which no factor is left that the method does not have: a method without elliptic
/// functions has the one variant "-".
std::vector<CellLabels> crossed(Study const& study, Catalogue const& catalogue) {
  std::vector<CellLabels> cells;
  for (auto const& method : study.methods) {
    auto const& entry = catalogue.method(study.system, method);
    auto const variants = variants_of(entry, study);
    auto const sources = coefficients_of(entry, study);
    for (auto const& arithmetic : study.arithmetics)
      for (auto const& variant : variants)
        for (auto const& coefficients : sources)
          for (bool const compensation : study.compensation)
            for (double const h : study.step)
              for (auto const& cell : crossed_operations(study, {study.system, method, arithmetic, variant,
                                                                 coefficients, compensation, h, steps_of(study, h)}))
                cells.push_back(cell);
  }
  return cells;
}

/// Why a combination does not exist, or "".
std::string reason_to_skip(CellLabels const& cell, Catalogue const& catalogue) {
  auto const& method = catalogue.method(cell.system, cell.method);
  if (cell.compensation && !method.compensable)
    return cell.method + " computes new values, not increments: compensation does not apply";
  if (method.uses_special_functions && !variant_exists(cell.special_functions, cell.arithmetic))
    return fmt::format("the '{}' elliptic functions do not exist in {}", cell.special_functions, cell.arithmetic);
  if (!method.runs_in_lanes && !operation_rule(cell).standard())
    return cell.method + " computes in part by libraries, whose operations are the processor's alone";
  return no_such_operations(cell);
}

/// Members of a unit: full blocks of packs (64 members where the packs hold 8 doubles), but small ensembles in small
/// units, so that threads share them; never more than 256 units a cell.
std::int64_t unit_size(std::int64_t members) {
  std::int64_t const base = members < 64 ? 16 : members < 128 ? 32 : 64, most_units = 256;
  std::int64_t const needed = (members + most_units - 1) / most_units;
  return std::max(base, (needed + base - 1) / base * base);
}

bool any_method(Study const& study, Catalogue const& catalogue, std::function<bool(MethodEntry const&)> const& is) {
  return std::any_of(study.methods.begin(), study.methods.end(),
                     [&](auto const& name) { return is(catalogue.method(study.system, name)); });
}

/// A level that none of the methods has would be run by nobody.
void check_coefficients(Study const& study, Catalogue const& catalogue) {
  auto const known = coefficient_levels(catalogue, study.system);
  for (auto const& level : study.coefficients) {
    if (!contains(known, level))
      throw InputError(fmt::format("there is no level of coefficients '{}'{}", level, suggestion(level, known)));
    if (!any_method(study, catalogue, [&](auto const& method) { return contains(method.coefficients, level); }))
      throw InputError(fmt::format("coefficients = '{}' is a level of none of the methods {}", level,
                                   fmt::join(study.methods, ", ")));
  }
}

void check_iterations(Study const& study, Catalogue const& catalogue, Quantity const& quantity) {
  if (quantity.kind == Quantity::Kind::iterations &&
      !any_method(study, catalogue, [](auto const& method) { return method.counts_iterations; }))
    throw InputError(fmt::format("quantity '{}' is of methods that count the turns of an iteration, and {} do not",
                                 quantity.name, fmt::join(study.methods, ", ")));
}

/// Every field has its numbers.
void check_fields(Study const& study, SystemDescription const& system) {
  for (auto const& field : system.fields) {
    auto const found = study.values.find(field.name);
    if (found == study.values.end())
      throw InputError(fmt::format("'{}' of {} is missing: expected {} numbers", field.name, system.name, field.size));
    if (found->second.size() != static_cast<std::size_t>(field.size))
      throw InputError(fmt::format("'{}' of {}: expected {} numbers, found {}", field.name, system.name, field.size,
                                   found->second.size()));
  }
}

void check(Study const& study, Catalogue const& catalogue) {
  auto const& system = catalogue.system(study.system);
  check_fields(study, system);
  if (auto complaint = system.complaint(study.values)) throw InputError(*complaint);
  for (auto const& name : study.arithmetics) catalogue.arithmetic(name);
  check_coefficients(study, catalogue);
  for (auto const& name : study.quantities) {
    auto const& quantity = catalogue.quantity(study.system, name);
    check_iterations(study, catalogue, quantity);
    if (quantity.needs_reference() && study.reference.kind == Reference::Kind::none)
      throw InputError(fmt::format("quantity '{}' needs a reference: add reference = \"exact\" or \"float128\"", name));
  }
  if (study.reference.kind == Reference::Kind::exact && !system.has_exact_flow)
    throw InputError(fmt::format("{} has no exact flow: take reference = \"float128\"", study.system));
  if (study.reference.kind == Reference::Kind::same_method) catalogue.arithmetic(study.reference.arithmetic);
  if (study.members < 1) throw InputError("members must be at least 1");
}

/// The same method in the reference's arithmetic must exist, and hold more bits than what it judges.
void check_reference(Study const& study, Catalogue const& catalogue, CellLabels const& cell) {
  if (study.reference.kind != Reference::Kind::same_method) return;
  auto const& reference = catalogue.arithmetic(study.reference.arithmetic);
  auto const& own = catalogue.arithmetic(cell.arithmetic);
  if (reference.bits <= own.bits)
    throw InputError(fmt::format("a reference in {} cannot judge {}: it needs more than {} bits", reference.name,
                                 own.name, own.bits));
}

std::string reference_of(Study const& study) {
  switch (study.reference.kind) {
    case Reference::Kind::none:
      return "none";
    case Reference::Kind::exact:
      return "exact";
    case Reference::Kind::same_method:
      return study.reference.arithmetic;
  }
  return "";
}

}  // namespace

Plan make_plan(Study const& study, Catalogue const& catalogue) {
  check(study, catalogue);
  Plan plan;
  for (auto const& cell : crossed(study, catalogue)) {
    if (auto const reason = reason_to_skip(cell, catalogue); !reason.empty()) {
      plan.skipped.push_back({cell, reason});
      continue;
    }
    check_reference(study, catalogue, cell);
    if (rounded_to(cell.arithmetic, cell.step) == 0)
      throw InputError(fmt::format("step = {} is 0 in {}", cell.step, cell.arithmetic));
    sample_steps(study.samples, cell.steps);  // complains where there are too few steps
    plan.cells.push_back(cell);
  }
  if (plan.cells.empty()) throw InputError("nothing is left to run: " + plan.skipped.front().reason);

  if (auto const& warning = catalogue.system(study.system).warning)
    if (auto const sentence = warning(study.values)) plan.warnings.push_back(*sentence);
  plan.references.assign(plan.cells.size(), reference_of(study));
  std::int64_t const size = unit_size(study.members);
  for (std::size_t c = 0; c < plan.cells.size(); ++c)
    for (std::int64_t first = 0; first < study.members; first += size)
      plan.units.push_back({c, first, std::min(size, study.members - first), unit_path(c, first)});
  return plan;
}

std::int64_t compared_members(Study const& study, Unit const& unit) {
  if (study.reference.kind == Reference::Kind::none) return 0;
  return std::clamp<std::int64_t>(study.reference.members - unit.first_member, 0, unit.members);
}

std::vector<std::int64_t> sample_steps(Samples const& samples, std::int64_t steps) {
  auto const count = samples.count;
  if (count < 1) throw InputError("samples.count must be at least 1");
  if (steps < count)
    throw InputError(fmt::format("{} steps cannot be sampled {} times: expected steps >= samples.count", steps, count));
  std::vector<std::int64_t> at;
  for (std::int64_t j = 1; j <= count; ++j) {
    double const share = static_cast<double>(j) / static_cast<double>(count);
    bool const linear = samples.spacing == Samples::Spacing::linear;
    double const place =
        linear ? share * static_cast<double>(steps)
               : std::pow(static_cast<double>(steps),
                          static_cast<double>(j - 1) / static_cast<double>(std::max<std::int64_t>(count - 1, 1)));
    // rounding must neither repeat a step nor run past the steps that are left for the samples to come
    std::int64_t const previous = at.empty() ? 0 : at.back();
    at.push_back(std::clamp<std::int64_t>(std::llround(place), previous + 1, steps - (count - j)));
  }
  at.back() = steps;
  return at;
}

}  // namespace brouwer
