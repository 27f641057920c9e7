#pragma once
#include <brouwer/ensemble/field_methods.hpp>
#include <brouwer/systems/double_pendulum.hpp>

namespace brouwer::families::double_pendulum {

template <class Visit>
void for_each_method(Visit visit) {
  for_each_runge_kutta_method<DoublePendulum>("double_pendulum", visit);
}

}  // namespace brouwer::families::double_pendulum
