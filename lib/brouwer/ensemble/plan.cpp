#include <brouwer/ensemble/plan.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

/// The levels of an option that only some methods have: those of the study, or none.
std::vector<std::string> levels_of(bool has_option, std::vector<std::string> const& levels) {
  return has_option ? levels : std::vector<std::string>{no_level};
}

/// Every combination of levels in which no factor is left that the method does not have: a method without elliptic
/// functions has the one variant "-".
std::vector<CellLabels> crossed(Study const& study, Catalogue const& catalogue) {
  std::vector<CellLabels> cells;
  for (auto const& method : study.methods) {
    auto const& entry = catalogue.method(study.system, method);
    auto const variants = levels_of(entry.uses_special_functions, study.special_functions);
    auto const sources = levels_of(entry.uses_coefficients, study.coefficients);
    for (auto const& arithmetic : study.arithmetics)
      for (auto const& variant : variants)
        for (auto const& coefficients : sources)
          for (bool const compensation : study.compensation)
            for (double const h : study.step)
              cells.push_back(
                  {study.system, method, arithmetic, variant, coefficients, compensation, h, steps_of(study, h)});
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
  return "";
}

/// Members of a unit: full blocks of packs (64 members where the packs hold 8 doubles), but small ensembles in small
/// units, so that threads share them; never more than 256 units a cell.
std::int64_t unit_size(std::int64_t members) {
  std::int64_t const base = members < 64 ? 16 : members < 128 ? 32 : 64, most_units = 256;
  std::int64_t const needed = (members + most_units - 1) / most_units;
  return std::max(base, (needed + base - 1) / base * base);
}

void check_coefficients(std::vector<std::string> const& levels) {
  auto const& known = coefficient_levels();
  for (auto const& level : levels)
    if (std::find(known.begin(), known.end(), level) == known.end())
      throw InputError(fmt::format("there is no level of coefficients '{}'{}", level, suggestion(level, known)));
}

void check(Study const& study, Catalogue const& catalogue) {
  auto const& system = catalogue.system(study.system);
  if (auto complaint = system.complaint(study.values)) throw InputError(*complaint);
  for (auto const& name : study.arithmetics) catalogue.arithmetic(name);
  check_coefficients(study.coefficients);
  for (auto const& name : study.quantities) {
    bool const needs_reference = catalogue.quantity(study.system, name).needs_reference();
    if (needs_reference && study.reference.kind == Reference::Kind::none)
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
