#pragma once
#include <brouwer/ensemble/method.hpp>
#include <brouwer/integrators/explicit_runge_kutta.hpp>
#include <brouwer/integrators/implicit_runge_kutta.hpp>
#include <brouwer/integrators/kick_drift.hpp>

namespace brouwer {

// The methods of every system of differential equations: what is listed with its data (explicit_tableaux.hpp,
// gauss_coefficients.hpp, kick_drift.hpp) is offered to each. A kind of methods is one class for all of them.

template <template <class> class System>
using ExplicitRungeKuttaOf = WithData<ExplicitRungeKutta, System, ExplicitTableau>;

template <template <class> class System>
using KickDriftOf = WithData<KickDrift, System, KickDriftMethod>;

/// Implicit methods, whose factor `coefficients` says in which form these are held.
template <template <class> class System>
struct ImplicitRungeKuttaOf {
  using OfDouble = ImplicitRungeKutta<System<double>>;
  ImplicitMethod const* method;
  int order() const { return method->order; }
  void describe(MethodEntry& entry) const {
    for (auto const form : forms_of(*method)) entry.coefficients.emplace_back(name_of(form));
  }

  template <class T, class Use>
  void choose(TrajectoryRequest const& request, Use use) const {
    using S = ImplicitRungeKutta<System<T>>;
    for (auto const form : forms_of(*method))
      if (request.coefficients == name_of(form))
        use(std::type_identity<S>{},
            [data = method, form](Setup<System<T>> const& setup) { return S(setup, *data, form); });
  }
};

template <class Method>
MethodText text_of(Method const& method, char const* system) {
  return {method.name, system, method.summary, method.source};
}

template <template <class> class System, class Visit>
void for_each_runge_kutta_method(char const* system, Visit visit) {
  for (auto const& method : explicit_tableaux()) visit(ExplicitRungeKuttaOf<System>{&method}, text_of(method, system));
  for (auto const& method : implicit_methods()) visit(ImplicitRungeKuttaOf<System>{&method}, text_of(method, system));
}

/// Of systems q' = velocity(p), p' = force(q).
template <template <class> class System, class Visit>
void for_each_kick_drift_method(char const* system, Visit visit) {
  for (auto const& method : kick_drift_methods()) visit(KickDriftOf<System>{&method}, text_of(method, system));
}

}  // namespace brouwer
