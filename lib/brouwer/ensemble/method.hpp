#pragma once
#include <brouwer/ensemble/arithmetics.hpp>
#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/ensemble/member.hpp>
#include <brouwer/integrators/coefficients.hpp>
#include <brouwer/special/elliptic_variants.hpp>
#include <brouwer/systems/rigid_body_flow.hpp>

namespace brouwer {

/// What people read of a method; the rest of its entry follows from the stepper's type.
struct MethodText {
  char const* name;
  char const* system;
  char const* summary;
  char const* source;
  bool uses_libm = false;  ///< calls sin, cos, atan …: bits depend on the machine's libm
};

namespace detail {

template <Stepper S>
MethodEntry described(MethodText const& text) {
  MethodEntry entry;
  entry.name = text.name;
  entry.system = text.system;
  entry.summary = text.summary;
  entry.source = text.source;
  entry.uses_libm = text.uses_libm;
  entry.order = S::order;
  entry.compensable = IncrementStepper<S>;
  return entry;
}

}  // namespace detail

/// The catalogue entry of a stepper that is a template over the scalar alone: method<Dmv2>({"dmv-2", …}).
template <template <class> class S>
MethodEntry method(MethodText const& text) {
  MethodEntry entry = detail::described<S<double>>(text);
  entry.begin = [](TrajectoryRequest const& request) {
    std::unique_ptr<Trajectory> trajectory;
    for_arithmetic(request.arithmetic, [&]<class T>(NamedArithmetic<T>) { trajectory = begin_member<S<T>>(request); });
    return trajectory;
  };
  return entry;
}

/// Calls visit(name, Functions{}) for every variant of the elliptic functions.
template <class Visit>
void for_each_variant(Visit visit) {
  visit("own", OwnElliptic{});
  visit("gsl", GslElliptic{});
  visit("boost", BoostElliptic{});
}

/// The same for a stepper that is also a template over the elliptic functions that it calls.
template <template <class, class> class S>
MethodEntry method_with_functions(MethodText const& text) {
  MethodEntry entry = detail::described<S<double, OwnElliptic>>(text);
  entry.uses_special_functions = true;
  entry.begin = [](TrajectoryRequest const& request) {
    std::unique_ptr<Trajectory> trajectory;
    for_arithmetic(request.arithmetic, [&]<class T>(NamedArithmetic<T>) {
      for_each_variant([&]<class Functions>(std::string const& name, Functions) {
        if constexpr (Functions::template exists_in<T>)
          if (name == request.special_functions) trajectory = begin_member<S<T, Functions>>(request);
      });
    });
    return trajectory;
  };
  return entry;
}

/// Calls visit(name, Coefficients{}) for both ways to take modified coefficients.
template <class Visit>
void for_each_coefficients(Visit visit) {
  visit("per-step", PerStep{});
  visit("per-trajectory", PerTrajectory{});
}

/// The same for a stepper that is also a template over where it takes its modified coefficients from:
/// template <class T, class Coefficients> class S.
template <template <class, class> class S>
MethodEntry method_with_coefficients(MethodText const& text) {
  MethodEntry entry = detail::described<S<double, PerStep>>(text);
  entry.uses_coefficients = true;
  entry.begin = [](TrajectoryRequest const& request) {
    std::unique_ptr<Trajectory> trajectory;
    for_arithmetic(request.arithmetic, [&]<class T>(NamedArithmetic<T>) {
      for_each_coefficients([&]<class Coefficients>(std::string const& name, Coefficients) {
        if (name == request.coefficients) trajectory = begin_member<S<T, Coefficients>>(request);
      });
    });
    return trajectory;
  };
  return entry;
}

}  // namespace brouwer
