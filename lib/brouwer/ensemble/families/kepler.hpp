#pragma once
#include <brouwer/ensemble/field_methods.hpp>
#include <brouwer/systems/kepler_flow.hpp>

namespace brouwer::families::kepler {

template <class Visit>
void for_each_method(Visit visit) {
  for_each_kick_drift_method<Kepler>("kepler", visit);
  for_each_runge_kutta_method<Kepler>("kepler", visit);
}

}  // namespace brouwer::families::kepler
