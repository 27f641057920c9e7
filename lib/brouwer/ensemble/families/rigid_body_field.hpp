#pragma once
#include <brouwer/ensemble/field_methods.hpp>
#include <brouwer/systems/rigid_body.hpp>

/// The rigid body as a system of differential equations like any other.
namespace brouwer::families::rigid_body_field {

template <class Visit>
void for_each_method(Visit visit) {
  for_each_runge_kutta_method<RigidBody>("rigid_body", visit);
}

}  // namespace brouwer::families::rigid_body_field
