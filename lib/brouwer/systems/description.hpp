#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace brouwer {

/// A named group of numbers of a system: a parameter (inertia) or a part of the start (momentum).
struct Field {
  std::string name;
  int size = 1;
  bool parameter = false;
  std::string unit;
  std::string help;
  std::vector<double> standard;  ///< the value when a study leaves it out; empty: it must be given
};

/// Something that can be observed. Its components are scalars with a sign: the statistics want errors, not norms.
struct Quantity {
  std::string name;
  std::vector<std::string> components;  ///< {"energy"} or {"spatial-momentum-1", …}
  std::string unit;
  bool needs_reference = false;  ///< an error of the state, not of a first integral
  bool needs_attitude = false;   ///< cannot be formed from the momentum alone
  std::string help;
};

using FieldValues = std::map<std::string, std::vector<double>>;

/// A system as data: what a study may say about it.
struct SystemDescription {
  std::string name;   ///< rigid_body
  std::string title;  ///< the free rigid body …
  std::vector<Field> fields;
  std::vector<Quantity> quantities;
  std::vector<std::string> state_components;  ///< y1 … q3
  /// How many components of the state, from the first, are always integrated; the rest (an attitude that follows from
  /// the momentum) only where a quantity needs it.
  std::size_t always_integrated = 0;
  bool has_exact_flow = false;
  /// Why these values are impossible ("inertia must be sorted …"), or nothing.
  std::function<std::optional<std::string>(FieldValues const&)> complaint;
  /// Puts values that were perturbed back where they must lie (a unit quaternion); may be empty.
  std::function<void(FieldValues&)> project = {};
};

}  // namespace brouwer
