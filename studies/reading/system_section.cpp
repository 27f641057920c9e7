#include <fmt/format.h>

#include <algorithm>
#include <brouwer/spelling.hpp>

#include "studies/reading/names.hpp"
#include "studies/reading/study_sections.hpp"

namespace brouwer {
namespace {

void read_field(Section& section, Field const& field, Study& study) {
  auto const kind = numbers(static_cast<std::size_t>(field.size));
  auto const given = field.standard.empty() ? section.required(field.name, kind) : section.value(field.name, kind);
  if (given)
    study.values[field.name] = *given;
  else if (!field.standard.empty())
    study.values[field.name] = field.standard;
}

bool complete(SystemDescription const& system, Study const& study) {
  return std::all_of(system.fields.begin(), system.fields.end(),
                     [&](Field const& field) { return study.values.contains(field.name); });
}

/// [system.NAME]: exactly one, known to the catalogue.
SystemDescription const* read_system_name(Section& systems, Catalogue const& catalogue) {
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

}  // namespace

SystemDescription const* read_system(Section& root, Catalogue const& catalogue, Study& study) {
  Section systems = root.section("system");
  SystemDescription const* system = read_system_name(systems, catalogue);
  if (!system) return nullptr;
  study.system = system->name;
  Section fields = systems.section(system->name);
  for (auto const& field : system->fields) read_field(fields, field, study);
  fields.refuse_unknown_keys();
  if (complete(*system, study) && system->complaint)
    if (auto const impossible = system->complaint(study.values)) fields.complain(*impossible);
  return system;
}

}  // namespace brouwer
