#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "studies/reading/limits.hpp"
#include "studies/reading/study_sections.hpp"

namespace brouwer {
namespace {

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
  if (laws.present() && laws.keys().size() != 1) laws.complain(laws.path() + ": expected one of uniform, normal, ulps");
  if (given.size() == 1) study.perturb[field.name] = given.front();
}

/// An ensemble lives on its differences.
void refuse_equal_members(Section& ensemble, SystemDescription const& system, Study const& study) {
  auto const start = std::find_if_not(system.fields.begin(), system.fields.end(), std::mem_fn(&Field::parameter));
  std::string const example = start == system.fields.end() ? system.fields.front().name : start->name;
  ensemble.complain(
      fmt::format("'ensemble.perturb' is missing: all {} members would be the same; expected for example "
                  "perturb = {{ {} = {{ uniform = 1e-2 }} }}",
                  study.members, example));
}

}  // namespace

void read_ensemble(Section& root, SystemDescription const& system, Study& study) {
  Section ensemble = root.section("ensemble");
  study.members = ensemble.value("members", whole(1, most_members)).value_or(Study{}.members);
  study.seed = static_cast<std::uint64_t>(
      ensemble.value("seed", whole(0, std::numeric_limits<std::int64_t>::max())).value_or(0));
  Section perturb = ensemble.section("perturb");
  for (auto const& field : system.fields) read_perturbation(perturb, field, study);
  perturb.refuse_unknown_keys();
  ensemble.refuse_unknown_keys();
  if (perturb.keys().empty() && study.members > 1) refuse_equal_members(ensemble, system, study);
}

}  // namespace brouwer
