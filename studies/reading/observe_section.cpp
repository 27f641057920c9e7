#include <fmt/format.h>

#include <algorithm>

#include "studies/reading/limits.hpp"
#include "studies/reading/names.hpp"
#include "studies/reading/study_sections.hpp"

namespace brouwer {
namespace {

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
    auto const wanted = reference.value("members", whole(1, most_members));
    study.reference.members = std::min(wanted.value_or(usual_members), study.members);  // --members may have left fewer
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

void refuse_missing_flow(Section& observe, SystemDescription const& system, Study const& study) {
  if (study.reference.kind == Reference::Kind::exact && !system.has_exact_flow)
    observe.complain("reference", fmt::format(": the exact flow of {} is not known; expected an arithmetic such as "
                                              "\"float128\": the same method in it",
                                              system.name));
}

/// Every error that can be observed with the reference that there is.
std::vector<std::string> observable(SystemDescription const& system, Reference const& reference) {
  std::vector<std::string> names;
  for (auto const& quantity : system.quantities)
    if (quantity.kind == Quantity::Kind::integral ||
        (quantity.kind == Quantity::Kind::state && reference.kind != Reference::Kind::none))
      names.push_back(quantity.name);
  return names;
}

void refuse_missing_reference(Section& observe, SystemDescription const& system, Study const& study) {
  if (study.reference.kind != Reference::Kind::none) return;
  for (auto const& quantity : system.quantities) {
    bool const wanted =
        std::find(study.quantities.begin(), study.quantities.end(), quantity.name) != study.quantities.end();
    if (wanted && quantity.needs_reference())
      observe.complain("quantities", fmt::format(": '{}' is an error against a reference, and observe.reference is "
                                                 "none; expected \"exact\" or an arithmetic such as \"float128\"",
                                                 quantity.name));
  }
}

void read_samples(Section& observe, Study& study) {
  Section samples = observe.section("samples");
  study.samples.count = samples.value("count", whole(1, most_samples)).value_or(Samples{}.count);
  auto const spacing = samples.value("spacing", one_of("spacing", {"log", "linear"}));
  if (spacing) study.samples.spacing = *spacing == "log" ? Samples::Spacing::log : Samples::Spacing::linear;
  samples.refuse_unknown_keys();
}

}  // namespace

void read_observe(Section& root, Catalogue const& catalogue, SystemDescription const& system, Study& study) {
  Section observe = root.section("observe");
  study.quantities = observe.levels("quantities", one_of("quantity", names_of(system.quantities)));
  read_reference(observe, catalogue, study);
  if (!observe.has("quantities")) study.quantities = observable(system, study.reference);
  read_samples(observe, study);
  study.states = observe.value("states", flag()).value_or(false);
  refuse_narrow_reference(observe, catalogue, study);
  refuse_missing_flow(observe, system, study);
  refuse_missing_reference(observe, system, study);
  observe.refuse_unknown_keys();
}

}  // namespace brouwer
