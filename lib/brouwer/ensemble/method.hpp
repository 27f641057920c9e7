#pragma once
#include <brouwer/ensemble/arithmetics.hpp>
#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/ensemble/trajectories_of.hpp>
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
  /// Its bits depend on the machine's libm (sin, cos, atan …) with GSL's and Boost's functions, and in long double; the
  /// library's own functions of float, double and double-double do not.
  bool uses_libm = false;
};

/// Calls visit(name, Functions{}) for every variant of the elliptic functions.
template <class Visit>
void for_each_variant(Visit visit) {
  visit("own", OwnElliptic{});
  visit("gsl", GslElliptic{});
  visit("boost", BoostElliptic{});
}

/// Calls visit(name, Coefficients{}) for both ways to take modified coefficients.
template <class Visit>
void for_each_coefficients(Visit visit) {
  visit("per-step", PerStep{});
  visit("per-trajectory", PerTrajectory{});
}

// --- families: the steppers of one method ----------------------------------------------------------------------------
// Each is a value whose choose<T> calls use(std::type_identity<S>, make) with the class S of stepper over the scalar T
// that a request asks for, if it exists, and what makes one from a Setup. It knows its order, and what its option does to
// the method's entry.

/// Makes a stepper, which may be a Core without what its constructor was.
template <class S>
auto constructed() {
  return [](Setup<typename S::System> const& setup) -> typename CoreOf<S>::type { return S(setup); };
}

/// A stepper that is a template over the scalar alone.
template <template <class> class S>
struct Plain {
  using OfDouble = S<double>;
  static constexpr int order() { return OfDouble::order; }
  static void describe(MethodEntry&) {}

  template <class T, class Use>
  static void choose(TrajectoryRequest const&, Use use) {
    use(std::type_identity<typename CoreOf<S<T>>::type>{}, constructed<S<T>>());
  }
};

/// … that is also a template over the elliptic functions that it calls.
template <template <class, class> class S>
struct OverFunctions {
  using OfDouble = S<double, OwnElliptic>;
  static constexpr int order() { return OfDouble::order; }
  static void describe(MethodEntry& entry) { entry.uses_special_functions = true; }

  template <class T, class Use>
  static void choose(TrajectoryRequest const& request, Use use) {
    for_each_variant([&]<class Functions>(std::string const& name, Functions) {
      if constexpr (Functions::template exists_in<T>)
        if (name == request.special_functions) {
          using Chosen = S<T, Functions>;
          use(std::type_identity<typename CoreOf<Chosen>::type>{}, constructed<Chosen>());
        }
    });
  }
};

/// … that is also a template over where it takes its modified coefficients from.
template <template <class, class> class S>
struct OverCoefficients {
  using OfDouble = S<double, PerStep>;
  static constexpr int order() { return OfDouble::order; }
  static void describe(MethodEntry& entry) {
    for_each_coefficients([&](char const* name, auto) { entry.coefficients.emplace_back(name); });
  }

  template <class T, class Use>
  static void choose(TrajectoryRequest const& request, Use use) {
    for_each_coefficients([&]<class Coefficients>(std::string const& name, Coefficients) {
      if (name == request.coefficients) {
        using Chosen = S<T, Coefficients>;
        use(std::type_identity<typename CoreOf<Chosen>::type>{}, constructed<Chosen>());
      }
    });
  }
};

/// A stepper of any system whose method is data (weights, a tableau): one class for all methods of its kind.
template <template <class> class S, template <class> class System, class Method>
struct WithData {
  using OfDouble = S<System<double>>;
  Method const* method;
  int order() const { return method->order; }
  static void describe(MethodEntry&) {}

  template <class T, class Use>
  void choose(TrajectoryRequest const&, Use use) const {
    use(std::type_identity<S<System<T>>>{},
        [data = method](Setup<System<T>> const& setup) { return S<System<T>>(setup, *data); });
  }
};

// --- makers -----------------------------------------------------------------------------------------------------------

/// Steppers say so themselves: `static constexpr bool runs_in_lanes = true;`.
template <class S>
concept RunsInLanes = requires {
  requires S::runs_in_lanes;
};

/// Adds some arithmetics, number by number, to a method's entry.
template <class Arithmetics, class Family>
void add_numbers(MethodEntry& entry, Family const& family) {
  entry.makers.push_back({InstructionSet::none, [family](TrajectoryRequest const& request) {
                            std::unique_ptr<Trajectories> made;
                            if (request.rule.standard() == std::same_as<Arithmetics, ModelledArithmetics>) return made;
                            for_arithmetic<Arithmetics>(request.arithmetic, [&]<class T>(NamedArithmetic<T>) {
                              family.template choose<T>(request, [&]<class S>(std::type_identity<S>, auto make) {
                                made = begin_trajectories<S>(request, make);
                              });
                            });
                            return made;
                          }});
}

/// Adds chosen operations, number by number. A method that runs in lanes is made of operations of the scalar alone; the
/// others have parts that are computed elsewhere.
template <class Family>
void add_modelled(MethodEntry& entry, Family const& family) {
  if constexpr (RunsInLanes<typename Family::OfDouble>) add_numbers<ModelledArithmetics>(entry, family);
}

/// Adds the packs of this translation unit's registers.
template <class Family>
void add_packs(MethodEntry& entry, Family const& family) {
  if constexpr (RunsInLanes<typename Family::OfDouble>)
    entry.makers.push_back({native_instruction_set, [family](TrajectoryRequest const& request) {
                              std::unique_ptr<Trajectories> made;
                              if (!request.rule.standard()) return made;
                              for_arithmetic<HardwareArithmetics>(request.arithmetic, [&]<class T>(NamedArithmetic<T>) {
                                using P = typename PackOf<T, native_bytes>::type;
                                if constexpr (lanes < P >> 1)
                                  family.template choose<P>(request, [&]<class S>(std::type_identity<S>, auto make) {
                                    made = begin_trajectories<S>(request, make);
                                  });
                              });
                              return made;
                            }});
}

// --- entries of the catalogue -----------------------------------------------------------------------------------------

/// Without makers.
template <class Family>
MethodEntry described(Family const& family, MethodText const& text) {
  using S = typename Family::OfDouble;
  MethodEntry entry;
  entry.name = text.name;
  entry.system = text.system;
  entry.summary = text.summary;
  entry.source = text.source;
  entry.uses_libm = text.uses_libm;
  entry.order = family.order();
  entry.compensable = IncrementStep<S>;
  entry.counts_iterations = CountsIterations<S>;
  entry.runs_in_lanes = RunsInLanes<S>;
  family.describe(entry);
  return entry;
}

/// With everything that this translation unit can make.
template <class Family>
MethodEntry method_of(Family const& family, MethodText const& text) {
  MethodEntry entry = described(family, text);
  add_numbers<AllArithmetics>(entry, family);
  add_modelled(entry, family);
  add_packs(entry, family);
  return entry;
}

/// The entry of a stepper that is a template over the scalar alone: method<Dmv2>({"dmv-2", …}).
template <template <class> class S>
MethodEntry method(MethodText const& text) {
  return method_of(Plain<S>{}, text);
}
/// … over the scalar and the elliptic functions that it calls.
template <template <class, class> class S>
MethodEntry method_with_functions(MethodText const& text) {
  return method_of(OverFunctions<S>{}, text);
}
/// … over the scalar and where it takes its modified coefficients from.
template <template <class, class> class S>
MethodEntry method_with_coefficients(MethodText const& text) {
  return method_of(OverCoefficients<S>{}, text);
}

}  // namespace brouwer
