#include <fmt/format.h>

#include <algorithm>
#include <brouwer/ensemble/operations.hpp>
#include <brouwer/error.hpp>

#include "studies/reading/limits.hpp"
#include "studies/reading/names.hpp"
#include "studies/reading/study_sections.hpp"

namespace brouwer {
namespace {

template <class T>
std::vector<T> or_else(std::vector<T> levels, std::vector<T> standard) {
  return levels.empty() ? standard : levels;
}

/// A method of the system; for one of others it is said of which.
Kind<std::string> method_of(Catalogue const& catalogue, std::string const& system) {
  auto kind = one_of("method", method_names(catalogue, system));
  return {kind.expected, [&catalogue, system, own = kind.read](toml::node const& node) {
            auto const word = node.value<std::string>().value_or("");
            std::vector<std::string> others;
            for (auto const& method : catalogue.methods)
              if (method.name == word) others.push_back(method.system);
            if (others.empty() || std::find(others.begin(), others.end(), system) != others.end()) return own(node);
            throw InputError(fmt::format("'{}' is a method of {}, not of {}", word, fmt::join(others, ", "), system));
          }};
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

}  // namespace

void read_integrate(Section& root, Catalogue const& catalogue, Study& study) {
  Section integrate = root.section("integrate");
  if (!integrate.has("methods")) integrate.complain("'integrate.methods' is missing, expected at least one method");
  if (!integrate.has("step")) integrate.complain("'integrate.step' is missing, expected at least one step size");
  study.methods = integrate.levels("methods", method_of(catalogue, study.system));
  study.arithmetics = or_else(integrate.levels("arithmetic", one_of("arithmetic", names_of(catalogue.arithmetics))),
                              {std::string("double")});
  study.special_functions = or_else(
      integrate.levels("special_functions", one_of("variant", special_function_variants())), {std::string("own")});
  study.coefficients =
      integrate.levels("coefficients", one_of("level of coefficients", coefficient_levels(catalogue, study.system)));
  study.compensation = or_else(integrate.levels("compensation", flag()), {false});
  study.rounding = or_else(integrate.levels("rounding", one_of("rounding", rounding_levels())), study.rounding);
  study.constants =
      or_else(integrate.levels("constants", one_of("kind of constants", constants_levels())), study.constants);
  study.contraction = or_else(integrate.levels("contraction", flag()), study.contraction);
  study.step = integrate.levels("step", positive());
  read_length(integrate, study);
  integrate.refuse_unknown_keys();
}

}  // namespace brouwer
