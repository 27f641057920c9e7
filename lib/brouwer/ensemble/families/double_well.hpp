#pragma once
#include <brouwer/ensemble/field_methods.hpp>
#include <brouwer/systems/double_well.hpp>

namespace brouwer::families::double_well {

template <class Visit>
void for_each_method(Visit visit) {
  for_each_kick_drift_method<DoubleWell>("double_well", visit);
  for_each_runge_kutta_method<DoubleWell>("double_well", visit);
}

}  // namespace brouwer::families::double_well
