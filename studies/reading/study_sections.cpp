#include "studies/reading/study_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <brouwer/spelling.hpp>
#include <cmath>

namespace brouwer {
namespace {

constexpr std::int64_t most_members = 1'000'000'000;
constexpr std::int64_t most_steps = 1'000'000'000'000'000;  // 10^15: beyond this a double no longer counts steps safely
constexpr std::int64_t most_samples = 100'000;
constexpr std::int64_t most_ulps = 1'000'000;

template <class Entries>
std::vector<std::string> names_of(Entries const& entries) {
  std::vector<std::string> names;
  for (auto const& entry : entries) names.push_back(entry.name);
  return names;
}

template <class T>
std::vector<T> or_else(std::vector<T> levels, std::vector<T> standard) {
  return levels.empty() ? standard : levels;
}

void read_field(Section& section, Field const& field, Study& study) {
  auto const kind = numbers(static_cast<std::size_t>(field.size));
  auto const given = field.standard.empty() ? section.required(field.name, kind) : section.value(field.name, kind);
  if (given)
    study.values[field.name] = *given;
  else if (!field.standard.empty())
    study.values[field.name] = field.standard;
}

bool complete(SystemEntry const& system, Study const& study) {
  return std::all_of(system.fields.begin(), system.fields.end(),
                     [&](Field const& field) { return study.values.contains(field.name); });
}

/// [system.NAME]: exactly one, known to the catalogue.
SystemEntry const* read_system_name(Section& systems, Catalogue const& catalogue) {
  auto const keys = systems.keys();
  auto const known = names_of(catalogue.systems);
  if (keys.size() != 1) {
    systems.complain(
        fmt::format("expected one table [system.NAME], found {}; known are {}", keys.size(), fmt::join(known, ", ")));
    return nullptr;
  }
  for (auto const& system : catalogue.systems)
    if (folded_key(system.name) == folded_key(keys.front())) return &system;
  systems.complain(keys.front(),
                   fmt::format(": there is no system '{}'{}", keys.front(), suggestion(keys.front(), known)));
  return nullptr;
}

SystemEntry const* read_system(Section& root, Catalogue const& catalogue, Study& study) {
  Section systems = root.section("system");
  SystemEntry const* system = read_system_name(systems, catalogue);
  if (!system) return nullptr;
  study.system = system->name;
  Section fields = systems.section(system->name);
  for (auto const& field : system->fields) read_field(fields, field, study);
  fields.refuse_unknown_keys();
  if (complete(*system, study) && system->complaint)
    if (auto const impossible = system->complaint(study.values)) fields.complain(*impossible);
  return system;
}

std::vector<std::string> methods_of(Catalogue const& catalogue, std::string const& system) {
  std::vector<std::string> names;
  for (auto const& method : catalogue.methods)
    if (method.system == system) names.push_back(method.name);
  return names;
}

/// steps or until: one of them.
void read_length(Section& integrate, Study& study) {
  study.steps = integrate.value("steps", whole(1, most_steps));
  study.until = integrate.value("until", positive());
  bool const steps = integrate.has("steps"), until = integrate.has("until");
  if (steps && until) integrate.complain("both integrate.steps and integrate.until are given, expected one of them");
  if (!steps && !until)
    integrate.complain("neither integrate.steps nor integrate.until is given, expected one of them");
}

void read_integrate(Section& root, Catalogue const& catalogue, Study& study) {
  Section integrate = root.section("integrate");
  if (!integrate.has("methods")) integrate.complain("'integrate.methods' is missing, expected at least one method");
  if (!integrate.has("step")) integrate.complain("'integrate.step' is missing, expected at least one step size");
  study.methods = integrate.levels("methods", one_of("method", methods_of(catalogue, study.system)));
  study.arithmetics = or_else(integrate.levels("arithmetic", one_of("arithmetic", names_of(catalogue.arithmetics))),
                              {std::string("double")});
  study.special_functions = or_else(
      integrate.levels("special_functions", one_of("variant", special_function_variants())), {std::string("own")});
  study.compensation = or_else(integrate.levels("compensation", flag()), {false});
  study.step = integrate.levels("step", positive());
  read_length(integrate, study);
  integrate.refuse_unknown_keys();
}

/// { uniform = 1e-2 }, { normal = 1e-3 } or { ulps = 4 }.
void read_perturbation(Section& perturb, Field const& field, Study& study) {
  if (!perturb.has(field.name)) return;
  Section laws = perturb.section(field.name);
  using Law = Perturbation::Law;
  std::vector<Perturbation> given;
  if (auto const size = laws.value("uniform", positive())) given.push_back({Law::uniform, *size});
  if (auto const size = laws.value("normal", positive())) given.push_back({Law::normal, *size});
  if (auto const size = laws.value("ulps", whole(1, most_ulps)))
    given.push_back({Law::ulps, static_cast<double>(*size)});
  laws.refuse_unknown_keys();
  if (laws.present() && laws.keys().size() != 1)
    laws.complain(laws.path("") + " expected one of uniform, normal, ulps");
  if (given.size() == 1) study.perturb[field.name] = given.front();
}

void read_ensemble(Section& root, SystemEntry const& system, Study& study) {
  Section ensemble = root.section("ensemble");
  study.members = ensemble.value("members", whole(1, most_members)).value_or(Study{}.members);
  study.seed = static_cast<std::uint64_t>(
      ensemble.value("seed", whole(0, std::numeric_limits<std::int64_t>::max())).value_or(0));
  Section perturb = ensemble.section("perturb");
  for (auto const& field : system.fields) read_perturbation(perturb, field, study);
  perturb.refuse_unknown_keys();
  ensemble.refuse_unknown_keys();
  if (perturb.keys().empty() && study.members > 1)
    ensemble.complain(
        fmt::format("'ensemble.perturb' is missing: all {} members would be the same; expected for example "
                    "perturb = {{ {} = {{ uniform = 1e-2 }} }}",
                    study.members, system.fields.back().name));
}

/// "exact", "none" or the name of an arithmetic.
void set_reference(Study& study, std::string const& name) {
  using Kind = Reference::Kind;
  study.reference.kind = name == "none" ? Kind::none : name == "exact" ? Kind::exact : Kind::same_method;
  if (study.reference.kind == Kind::same_method) study.reference.arithmetic = name;
}

/// Short form: reference = "float128"; long: reference = { arithmetic = "float128", members = 16 }.
void read_reference(Section& observe, Catalogue const& catalogue, Study& study) {
  constexpr std::int64_t usual_members = 16;
  auto known = names_of(catalogue.arithmetics);
  known.insert(known.end(), {"exact", "none"});
  auto const name = one_of("reference", known);
  study.reference.members = std::min(usual_members, study.members);
  toml::node const* node = observe.find("reference");
  if (!node || !node->is_table()) {
    if (auto const given = observe.value("reference", name)) set_reference(study, *given);
  } else {
    Section reference = observe.section("reference");
    if (auto const given = reference.required("arithmetic", name)) set_reference(study, *given);
    auto const members = reference.value("members", whole(1, study.members));
    study.reference.members = members.value_or(study.reference.members);
    reference.refuse_unknown_keys();
  }
  if (study.reference.kind == Reference::Kind::none) study.reference.members = 0;
}

/// Round-off is judged by a reference that has less of it.
void refuse_narrow_reference(Section& observe, Catalogue const& catalogue, Study const& study) {
  if (study.reference.kind != Reference::Kind::same_method) return;
  int const reference_bits = catalogue.arithmetic(study.reference.arithmetic).bits;
  for (auto const& working : study.arithmetics)
    if (catalogue.arithmetic(working).bits >= reference_bits)
      observe.complain(
          "reference",
          fmt::format(": '{}' ({} bits) is not wider than '{}' ({} bits) of integrate.arithmetic",
                      study.reference.arithmetic, reference_bits, working, catalogue.arithmetic(working).bits));
}

/// Everything that can be observed with the reference that there is.
std::vector<std::string> observable(SystemEntry const& system, Reference const& reference) {
  std::vector<std::string> names;
  for (auto const& quantity : system.quantities)
    if (!quantity.needs_reference || reference.kind != Reference::Kind::none) names.push_back(quantity.name);
  return names;
}

void refuse_missing_reference(Section& observe, SystemEntry const& system, Study const& study) {
  if (study.reference.kind != Reference::Kind::none) return;
  for (auto const& quantity : system.quantities) {
    bool const wanted =
        std::find(study.quantities.begin(), study.quantities.end(), quantity.name) != study.quantities.end();
    if (wanted && quantity.needs_reference)
      observe.complain("quantities", fmt::format(": '{}' is an error against a reference, and observe.reference is "
                                                 "none; expected \"exact\" or an arithmetic such as \"float128\"",
                                                 quantity.name));
  }
}

void read_samples(Section& observe, Study& study) {
  Section samples = observe.section("samples");
  study.samples.count = samples.value("count", whole(2, most_samples)).value_or(Samples{}.count);
  auto const spacing = samples.value("spacing", one_of("spacing", {"log", "linear"}));
  if (spacing) study.samples.spacing = *spacing == "log" ? Samples::Spacing::log : Samples::Spacing::linear;
  samples.refuse_unknown_keys();
}

void read_observe(Section& root, Catalogue const& catalogue, SystemEntry const& system, Study& study) {
  Section observe = root.section("observe");
  study.quantities = observe.levels("quantities", one_of("quantity", names_of(system.quantities)));
  read_reference(observe, catalogue, study);
  if (!observe.has("quantities")) study.quantities = observable(system, study.reference);
  read_samples(observe, study);
  refuse_narrow_reference(observe, catalogue, study);
  refuse_missing_reference(observe, system, study);
  observe.refuse_unknown_keys();
}

/// A cell must have at least as many steps as samples, and a number of steps that can be counted.
void check_lengths(Section& root, Study const& study) {
  Section integrate = root.section("integrate");
  for (double const h : study.step) {
    double const steps = study.steps ? static_cast<double>(*study.steps) : std::round(study.until.value_or(0) / h);
    char const* key = study.steps ? "steps" : "until";
    if (steps > static_cast<double>(most_steps))
      integrate.complain(
          key, fmt::format(" needs {:.3g} steps of h = {}, expected at most {:.0e}", steps, h, double(most_steps)));
    else if (steps < static_cast<double>(study.samples.count))
      integrate.complain(
          key, fmt::format(" gives {} steps of h = {}, fewer than the {} samples of observe.samples.count", steps, h,
                           study.samples.count));
  }
}

}  // namespace

void read_study_sections(Section& root, Catalogue const& catalogue, Study& study) {
  study.question = root.value("question", text()).value_or("");
  study.source = root.value("source", text()).value_or("");
  SystemEntry const* system = read_system(root, catalogue, study);
  for (auto const* known : {"integrate", "ensemble", "observe", "expect"}) root.find(known);
  root.refuse_unknown_keys();
  if (!system) return;
  read_integrate(root, catalogue, study);
  read_ensemble(root, *system, study);
  read_observe(root, catalogue, *system, study);
  if (study.steps || study.until) check_lengths(root, study);
}

}  // namespace brouwer
