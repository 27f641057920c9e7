#pragma once
#include <brouwer/ensemble/field_methods.hpp>
#include <brouwer/systems/pendulum.hpp>

namespace brouwer::families::pendulum {

template <class Visit>
void for_each_method(Visit visit) {
  for_each_kick_drift_method<Pendulum>("pendulum", visit);
  for_each_runge_kutta_method<Pendulum>("pendulum", visit);
}

}  // namespace brouwer::families::pendulum
