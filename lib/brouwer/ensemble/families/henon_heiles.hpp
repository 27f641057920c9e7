#pragma once
#include <brouwer/ensemble/field_methods.hpp>
#include <brouwer/systems/henon_heiles.hpp>

namespace brouwer::families::henon_heiles {

template <class Visit>
void for_each_method(Visit visit) {
  for_each_kick_drift_method<HenonHeiles>("henon_heiles", visit);
  for_each_runge_kutta_method<HenonHeiles>("henon_heiles", visit);
}

}  // namespace brouwer::families::henon_heiles
