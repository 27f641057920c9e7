#include <brouwer/ensemble/catalogue.hpp>

#include <algorithm>

#include <brouwer/ensemble/builtin.hpp>
#include <brouwer/ensemble/method.hpp>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>

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

std::vector<std::string> const& coefficient_levels() {
  static std::vector<std::string> const names = [] {
    std::vector<std::string> collected;
    for_each_coefficients([&](char const* name, auto) { collected.emplace_back(name); });
    return collected;
  }();
  return names;
}

Catalogue builtin_catalogue() {
  Catalogue catalogue;
  catalogue.arithmetics = arithmetic_entries();
  catalogue.systems.push_back(describe_rigid_body());
  add_elliptic_methods(catalogue);
  add_elliptic_software(catalogue);
  add_dmv_methods(catalogue);
  add_dmv_software(catalogue);
  brouwer_add_elliptic_packs_sse2(catalogue);
  brouwer_add_dmv_packs_sse2(catalogue);
#if defined(__x86_64__)
  if (widest_instruction_set() >= InstructionSet::avx2) {
    brouwer_add_elliptic_packs_avx2(catalogue);
    brouwer_add_dmv_packs_avx2(catalogue);
  }
  if (widest_instruction_set() >= InstructionSet::avx512) {
    brouwer_add_elliptic_packs_avx512(catalogue);
    brouwer_add_dmv_packs_avx512(catalogue);
  }
#endif
  return catalogue;
}

}  // namespace brouwer
