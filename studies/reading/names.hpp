#pragma once
#include <brouwer/ensemble/catalogue.hpp>
#include <string>
#include <vector>

namespace brouwer {

/// The names of systems, methods, arithmetics, quantities or fields.
template <class Entries>
std::vector<std::string> names_of(Entries const& entries) {
  std::vector<std::string> names;
  for (auto const& entry : entries) names.push_back(entry.name);
  return names;
}

inline std::vector<std::string> method_names(Catalogue const& catalogue, std::string const& system) {
  std::vector<std::string> names;
  for (auto const& method : catalogue.methods)
    if (method.system == system) names.push_back(method.name);
  return names;
}

}  // namespace brouwer
