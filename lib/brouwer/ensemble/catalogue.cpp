#include <brouwer/ensemble/catalogue.hpp>

#include <algorithm>

#include <brouwer/ensemble/families.hpp>
#include <brouwer/ensemble/method.hpp>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <brouwer/systems/double_pendulum.hpp>
#include <brouwer/systems/double_well.hpp>
#include <brouwer/systems/henon_heiles.hpp>
#include <brouwer/systems/kepler.hpp>
#include <brouwer/systems/outer_solar_system.hpp>
#include <brouwer/systems/pendulum.hpp>

namespace brouwer {
namespace {

/// The entry of that name, or a sentence with the nearest one.
template <class Entry>
Entry const& find(std::vector<Entry> const& entries, std::string const& what, std::string const& name,
                  std::string const& system = "") {
  std::vector<std::string> names;
  for (auto const& entry : entries) {
    if constexpr (requires { entry.system; })
      if (entry.system != system) continue;
    if (entry.name == name) return entry;
    names.push_back(entry.name);
  }
  throw InputError("there is no " + what + " '" + name + "'" + suggestion(name, names));
}

std::vector<ArithmeticEntry> arithmetic_entries() {
  std::vector<ArithmeticEntry> entries;
  AllArithmetics::for_each([&]<class T>(NamedArithmetic<T> arithmetic) {
    entries.push_back({arithmetic.name, significand_bits<T>, arithmetic.summary});
  });
  return entries;
}

}  // namespace

void Catalogue::add(SystemDescription const& system) { systems.push_back(with_common_quantities(system)); }

SystemDescription const& Catalogue::system(std::string const& name) const { return find(systems, "system", name); }

MethodEntry const& Catalogue::method(std::string const& system, std::string const& name) const {
  return find(methods, "method", name, system);
}

MethodEntry& Catalogue::method(std::string const& system, std::string const& name) {
  return const_cast<MethodEntry&>(std::as_const(*this).method(system, name));  // NOLINT: one search for both
}

ArithmeticEntry const& Catalogue::arithmetic(std::string const& name) const {
  return find(arithmetics, "arithmetic", name);
}

Quantity const& Catalogue::quantity(std::string const& system_name, std::string const& name) const {
  return find(system(system_name).quantities, "quantity", name);
}

std::vector<std::string> const& special_function_variants() {
  static std::vector<std::string> const names = [] {
    std::vector<std::string> collected;
    for_each_variant([&](char const* name, auto) { collected.emplace_back(name); });
    return collected;
  }();
  return names;
}

bool variant_exists(std::string const& variant, std::string const& arithmetic) {
  bool exists = false;
  for_arithmetic(arithmetic, [&]<class T>(NamedArithmetic<T>) {
    for_each_variant([&]<class Functions>(std::string const& name, Functions) {
      if (name == variant) exists = Functions::template exists_in<T>;
    });
  });
  return exists;
}

std::vector<std::string> coefficient_levels(Catalogue const& catalogue, std::string const& system) {
  std::vector<std::string> levels;
  for (auto const& method : catalogue.methods)
    for (auto const& level : method.coefficients)
      if (method.system == system && !contains(levels, level)) levels.push_back(level);
  return levels;
}

Catalogue builtin_catalogue() {
  Catalogue catalogue;
  catalogue.arithmetics = arithmetic_entries();
  for (auto const& system :
       {describe_rigid_body(), describe_double_well(), describe_pendulum(), describe_henon_heiles(),
        describe_double_pendulum(), describe_kepler(), describe_outer_solar_system()})
    catalogue.add(system);
#define BROUWER_ADD_NUMBERS(family)         \
  BROUWER_ADD(family, hardware)(catalogue); \
  BROUWER_ADD(family, software)(catalogue); \
  BROUWER_ADD(family, modelled)(catalogue);
#define BROUWER_ADD_SSE2(family) BROUWER_ADD(family, sse2)(catalogue);
#define BROUWER_ADD_AVX2(family) BROUWER_ADD(family, avx2)(catalogue);
#define BROUWER_ADD_AVX512(family) BROUWER_ADD(family, avx512)(catalogue);
  BROUWER_FAMILIES(BROUWER_ADD_NUMBERS)
  BROUWER_FAMILIES(BROUWER_ADD_SSE2)
#if defined(__x86_64__)
  if (widest_instruction_set() >= InstructionSet::avx2) {
    BROUWER_FAMILIES(BROUWER_ADD_AVX2)
  }
  if (widest_instruction_set() >= InstructionSet::avx512) {
    BROUWER_FAMILIES(BROUWER_ADD_AVX512)
  }
#endif
  return catalogue;
}

}  // namespace brouwer
