#pragma once
#include <array>
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
  enum class Kind {
    integral,  ///< the error of a first integral since the start
    state,     ///< the error of a state against a reference
    rounding,  ///< a first integral's difference from the reference's, whatever the method conserves: where the reference
               ///< is the same method, what rounding did to it
    iterations,  ///< no error but a count: turns of an iteration, per step since the start
  };
  std::string name;
  std::vector<std::string> components;  ///< {"energy"} or {"spatial-momentum-1", …}
  std::string unit;
  Kind kind = Kind::integral;
  bool needs_whole_state = true;  ///< cannot be formed from the components that are always integrated
  std::string help;

  bool needs_reference() const { return kind == Kind::state || kind == Kind::rounding; }
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
  /// What a user of these values should know ("the centre of mass moves …"), or nothing; may be empty.
  std::function<std::optional<std::string>(FieldValues const&)> warning = {};
  /// The two components of the state that show it best in a plane (indices).
  std::array<std::size_t, 2> plane = {0, 1};
  double usual_step = 0.01;  ///< h at which methods of order 2 follow the standard start

  /// How many numbers the quantities of a kind have together.
  std::size_t count(Quantity::Kind kind) const {
    std::size_t components = 0;
    for (auto const& quantity : quantities)
      if (quantity.kind == kind) components += quantity.components.size();
    return components;
  }
};

/// The quantities that every system has: the twin of each first integral that is compared with the reference, and the
/// count of methods that solve equations by iteration.
inline SystemDescription with_common_quantities(SystemDescription system) {
  using Kind = Quantity::Kind;
  std::vector<Quantity> common;
  for (auto const& quantity : system.quantities) {
    if (quantity.kind != Kind::integral) continue;
    Quantity twin = quantity;
    twin.name = "rounding-of-" + quantity.name;
    for (auto& component : twin.components) component = "rounding-of-" + component;
    twin.kind = Kind::rounding;
    twin.help = "the same, minus that of the reference: what rounding did, where the method does not conserve it";
    common.push_back(twin);
  }
  common.push_back({"iterations",
                    {"iterations"},
                    "per step",
                    Kind::iterations,
                    false,
                    "turns of the method's iteration per step, mean since the start"});
  system.quantities.insert(system.quantities.end(), common.begin(), common.end());
  return system;
}

}  // namespace brouwer
