#include <fmt/format.h>

#include <algorithm>
#include <brouwer/ensemble/operations.hpp>
#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>
#include <brouwer/store/whole_file.hpp>
#include <set>

#include "studies/commands/commands.hpp"
#include "studies/reading/toml.hpp"

namespace brouwer {
namespace {

std::string field_text(Field const& field) {
  std::string const standard =
      field.standard.empty() ? "to be given" : fmt::format("[{}]", fmt::join(field.standard, ", "));
  return fmt::format("    {:<14} {} ({}); standard: {}\n", field.name, field.help,
                     field.parameter ? "parameter" : "start", standard);
}

void list_systems(Catalogue const& catalogue) {
  for (auto const& system : catalogue.systems) {
    fmt::print("  {}: {}\n", system.name, system.title);
    for (auto const& field : system.fields) fmt::print("{}", field_text(field));
  }
}

std::string traits(MethodEntry const& method) {
  std::string text = method.order == 0 ? "exact up to rounding" : fmt::format("order {}", method.order);
  if (method.compensable) text += ", compensation applies";
  if (method.uses_special_functions) text += ", special functions apply";
  if (!method.coefficients.empty()) text += fmt::format(", coefficients {}", fmt::join(method.coefficients, ", "));
  if (method.counts_iterations) text += ", counts iterations";
  if (method.runs_in_lanes) text += ", runs in lanes";
  if (method.uses_libm) text += ", libm with others' functions and in long double";
  return text;
}

/// The systems that have a method of this name.
std::vector<std::string> systems_with(std::string const& method, Catalogue const& catalogue) {
  std::vector<std::string> systems;
  for (auto const& entry : catalogue.methods)
    if (entry.name == method) systems.push_back(entry.system);
  return systems;
}

/// Each name once, however many systems have it.
void list_methods(Catalogue const& catalogue) {
  std::set<std::string> listed;
  for (auto const& method : catalogue.methods)
    if (listed.insert(method.name).second)
      fmt::print("  {:<28} {}\n{:31}{}\n{:31}{}\n{:31}{}\n", method.name, method.summary, "",
                 fmt::join(systems_with(method.name, catalogue), ", "), "", traits(method), "", method.source);
}

void list_arithmetics(Catalogue const& catalogue) {
  for (auto const& arithmetic : catalogue.arithmetics)
    fmt::print("  {:<16} {:>5} bits  {}\n", arithmetic.name, arithmetic.bits, arithmetic.summary);
}

void list_operations(Catalogue const&) {
  fmt::print("  {:<16} {}: how every operation of a step is rounded\n", "rounding", fmt::join(rounding_levels(), ", "));
  fmt::print("  {:<16} {}: whether the method's constants keep what rounding takes from them\n", "constants",
             fmt::join(constants_levels(), ", "));
  fmt::print("  {:<16} false, true: whether products that are added are fused with the sum\n", "contraction");
  fmt::print(
      "  In float and double, with our own elliptic functions, for methods that run in lanes; number by number.\n");
}

void list_quantities(Catalogue const& catalogue) {
  for (auto const& system : catalogue.systems)
    for (auto const& quantity : system.quantities)
      fmt::print("  {:<18} {}; {}{}\n", quantity.name, quantity.help, system.name,
                 quantity.needs_reference() ? "; needs a reference" : "");
}

/// The question of a study, or what is the matter with the file.
std::string question_of(std::filesystem::path const& file) {
  try {
    return parse_toml(read_whole(file), file.string())["question"].value_or<std::string>("(no question)");
  } catch (std::exception const& error) {
    return fmt::format("({})", error.what());
  }
}

/// Study files in ./studies and in the current folder.
void list_studies(Catalogue const&) {
  std::vector<std::filesystem::path> files;
  for (auto const* folder : {"studies", "."}) {
    std::error_code unreadable;
    for (auto const& entry : std::filesystem::directory_iterator(folder, unreadable))
      if (entry.path().extension() == ".toml" && entry.is_regular_file())
        files.push_back(entry.path().lexically_normal());
  }
  std::sort(files.begin(), files.end());
  for (auto const& file : files) fmt::print("  {:<32} {}\n", file.string(), question_of(file));
  if (files.empty()) fmt::print("  none in ./studies or in the current folder\n");
}

struct Listing {
  char const* name;
  void (*print)(Catalogue const&);
};
constexpr Listing listings[] = {{"systems", list_systems},         {"methods", list_methods},
                                {"arithmetics", list_arithmetics}, {"operations", list_operations},
                                {"quantities", list_quantities},   {"studies", list_studies}};

}  // namespace

std::vector<std::string> listing_names() {
  std::vector<std::string> names;
  for (auto const& listing : listings) names.emplace_back(listing.name);
  return names;
}

int list(ListCommand const& command, Catalogue const& catalogue) {
  std::string const what = command.what == "integrators" ? "methods" : command.what;
  auto const names = listing_names();
  if (!what.empty() && std::find(names.begin(), names.end(), what) == names.end())
    throw InputError(fmt::format("there is no list of '{}'{}", command.what, suggestion(command.what, names)));
  for (auto const& listing : listings) {
    if (!what.empty() && what != listing.name) continue;
    fmt::print("{}:\n", listing.name);
    listing.print(catalogue);
  }
  return done;
}

}  // namespace brouwer
