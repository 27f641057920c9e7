#pragma once
#include <brouwer/ensemble/catalogue.hpp>

namespace brouwer {

inline Field small_field(std::string name, bool parameter, std::vector<double> standard) {
  Field field;
  field.name = std::move(name);
  field.size = 3;
  field.parameter = parameter;
  field.standard = std::move(standard);
  return field;
}

inline Quantity small_quantity(std::string name, std::vector<std::string> components, bool needs_reference) {
  Quantity quantity;
  quantity.name = std::move(name);
  quantity.components = std::move(components);
  quantity.kind = needs_reference ? Quantity::Kind::state : Quantity::Kind::integral;
  return quantity;
}

inline MethodEntry small_method(std::string name, std::string system, bool compensable) {
  MethodEntry method;
  method.name = std::move(name);
  method.system = std::move(system);
  method.compensable = compensable;
  method.uses_special_functions = !compensable;
  return method;
}

inline MethodEntry small_preprocessed_method() {
  auto method = small_method("dmv-10", "rigid_body", true);
  method.coefficients = {"per-step", "per-trajectory"};
  return method;
}

/// A catalogue of names alone, to read studies with: nothing in it can run.
inline Catalogue small_catalogue() {
  SystemDescription body;
  body.name = "rigid_body";
  body.title = "the free rigid body";
  body.fields = {small_field("inertia", true, {0.6, 0.8, 1.0}), small_field("momentum", false, {})};
  body.quantities = {small_quantity("energy", {"energy"}, false),
                     small_quantity("spatial-momentum", {"spatial-momentum-1", "spatial-momentum-2"}, false),
                     small_quantity("state", {"y1", "y2"}, true)};
  body.state_components = {"y1", "y2"};
  body.has_exact_flow = true;
  body.complaint = [](FieldValues const& values) -> std::optional<std::string> {
    auto const& inertia = values.at("inertia");
    if (inertia[0] <= inertia[1] && inertia[1] <= inertia[2] && inertia[0] > 0) return std::nullopt;
    return "inertia must be positive and sorted";
  };
  Catalogue catalogue;
  catalogue.systems = {body};
  catalogue.methods = {small_method("elliptic-naive", "rigid_body", false), small_method("dmv-2", "rigid_body", true),
                       small_preprocessed_method(), small_method("leapfrog", "pendulum", true)};
  catalogue.arithmetics = {{"float", 24, ""}, {"double", 53, ""}, {"float128", 113, ""}};
  return catalogue;
}

}  // namespace brouwer
