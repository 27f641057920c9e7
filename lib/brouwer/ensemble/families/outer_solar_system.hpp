#pragma once
#include <brouwer/ensemble/field_methods.hpp>
#include <brouwer/systems/outer_solar_system.hpp>

namespace brouwer::families::outer_solar_system {

template <class Visit>
void for_each_method(Visit visit) {
  for_each_kick_drift_method<OuterSolarSystem>("outer_solar_system", visit);
  for_each_runge_kutta_method<OuterSolarSystem>("outer_solar_system", visit);
}

}  // namespace brouwer::families::outer_solar_system
