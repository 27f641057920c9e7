#pragma once
#include <array>
#include <span>
#include <vector>

#include <brouwer/integrators/composition.hpp>
#include <brouwer/integrators/stages.hpp>
#include <brouwer/integrators/stepper.hpp>
#include <brouwer/scalar/wider.hpp>
#include <brouwer/systems/system.hpp>

namespace brouwer {

/// A method for q̇ = velocity(p), ṗ = force(q) that takes kicks p += c h force(q) and drifts q += d h velocity(p) in turns,
/// as data: the composition of a base sequence. All of them are symplectic, and those with a symmetric base symmetric.
struct KickDriftMethod {
  enum class Base { kick_drift, drift_kick, kick_drift_kick, drift_kick_drift };
  char const* name;
  int order;
  char const* summary;
  char const* source;
  Base base;
  Composition const* composition = &base_method;

  constexpr bool begins_with_kick() const { return base == Base::kick_drift || base == Base::kick_drift_kick; }
  constexpr bool symmetric() const { return base == Base::kick_drift_kick || base == Base::drift_kick_drift; }
};

/// c₁, d₁, c₂ … (or d₁, c₁, d₂ … ) of a method, in units of h. Where two kicks (or drifts) of the composition meet they are
/// one.
template <Real W>
std::vector<W> kicks_and_drifts(KickDriftMethod const& method) {
  if (!method.symmetric()) return {W(1), W(1)};
  std::vector<W> lengths{W(0)};
  for (auto const& weight : composition_weights<W>(*method.composition)) {
    W const half = weight / W(2);
    lengths.back() = lengths.back() + half;
    lengths.push_back(weight);
    lengths.push_back(half);
  }
  return lengths;
}

/// A KickDriftMethod in increment form: the changes of q and p since the step's begin are summed by themselves, and a force
/// (velocity) is taken at the sum of start and change, rounded. What rounding costs an increment is then h times less than
/// what it costs a state.
///
/// A step has no history: the force at its end, which is that of the next one's begin, is evaluated in both. Per step
/// and stage of a composition there are one force and one velocity, and one force more; position Verlet has one of each.
template <SeparableSystem S>
class KickDrift {
 public:
  using System = S;
  using Scalar = typename System::Scalar;
  using State = typename System::State;
  static constexpr bool runs_in_lanes = true;

  KickDrift(Setup<System> const& setup, KickDriftMethod const& method)
      : system_(setup.system), begins_with_kick_(method.begins_with_kick()) {
    using W = Wider<Scalar>;
    for (W const& length : kicks_and_drifts<W>(method)) lengths_.push_back(rounded<Scalar>(W(length * W(setup.step))));
  }

  State increment(State const& y) const {
    return walk(y, [](State const&) { return true; });
  }

  /// Why the step from y gives no finite state.
  Failure failure(State const& y, int l) const {
    Failure reason = failure_of_ends(system_, y, zero(y), l);
    if (reason == Failure::none)
      walk(y, [&](State const& change) {
        reason = failure_of_stage(system_, sum(y, change), l);
        return reason == Failure::none;
      });
    return reason;
  }

 private:
  static State zero(State y) {
    for_components([](Scalar& a) { a = Scalar(0); }, y);
    return y;
  }

  /// As far as `go_on(change)` says after each kick and drift.
  template <class GoOn>
  State walk(State const& y, GoOn go_on) const {
    State change = zero(y);
    bool kick = begins_with_kick_;
    for (auto const& length : lengths_) {
      if (kick)
        advance_part(change.p, length, system_.force(added<Scalar>(y.q, change.q)));
      else
        advance_part(change.q, length, system_.velocity(added<Scalar>(y.p, change.p)));
      if (!go_on(change)) break;
      kick = !kick;
    }
    return change;
  }

  static void advance_part(typename State::Part& change, Scalar const& length, typename State::Part const& rate) {
    for (std::size_t i = 0; i < change.size(); ++i) change[i] = change[i] + length * rate[i];
  }

  System system_;
  bool begins_with_kick_;
  std::vector<Scalar> lengths_;  ///< times h, rounded once
};

// --- the methods ------------------------------------------------------------------------------------------------------

namespace detail {
constexpr KickDriftMethod composed_verlet(Composition const& c, char const* summary) {
  return {c.name.data(), c.order, summary, c.source.data(), KickDriftMethod::Base::kick_drift_kick, &c};
}
}  // namespace detail

/// All of them, by order and cost. Compositions are of Störmer–Verlet, kick-drift-kick.
inline std::span<KickDriftMethod const> kick_drift_methods() {
  using Base = KickDriftMethod::Base;
  using detail::composed_verlet;
  static constexpr std::array methods{
      KickDriftMethod{"symplectic-euler-kick-drift", 1, "symplectic Euler: a kick, then a drift with the new momenta",
                      "R. de Vogelaere, Report 4, Dept. of Math., Univ. of Notre Dame, 1956", Base::kick_drift},
      KickDriftMethod{"symplectic-euler-drift-kick", 1,
                      "symplectic Euler: a drift, then a kick at the new place (the other's adjoint)",
                      "R. de Vogelaere, Report 4, Dept. of Math., Univ. of Notre Dame, 1956", Base::drift_kick},
      KickDriftMethod{"stoermer-verlet", 2, "Stoermer-Verlet (leapfrog): half a kick, a drift, half a kick",
                      "L. Verlet, Phys. Rev. 159 (1967) 98; E. Hairer, C. Lubich, G. Wanner, Acta Numer. 12 (2003) 399",
                      Base::kick_drift_kick},
      KickDriftMethod{"position-verlet", 2, "position Verlet: half a drift, a kick, half a drift; one force a step",
                      "M. Tuckerman, B. J. Berne, G. J. Martyna, J. Chem. Phys. 97 (1992) 1990",
                      Base::drift_kick_drift},
      composed_verlet(forest_ruth_4, "three Stoermer-Verlet steps, the middle one backwards"),
      composed_verlet(suzuki_4, "five Stoermer-Verlet steps: a fractal composition"),
      composed_verlet(mclachlan_4, "five Stoermer-Verlet steps, for small error constants"),
      composed_verlet(yoshida_6, "seven Stoermer-Verlet steps: the fewest of order 6"),
      composed_verlet(mclachlan_6, "nine Stoermer-Verlet steps, for small error constants"),
      composed_verlet(kahan_li_6, "nine Stoermer-Verlet steps, for small error constants"),
      composed_verlet(sofroniou_spaletta_6, "eleven Stoermer-Verlet steps, for small error constants"),
      composed_verlet(suzuki_umeno_8, "fifteen Stoermer-Verlet steps: the fewest of order 8"),
      composed_verlet(kahan_li_8, "seventeen Stoermer-Verlet steps, for small error constants"),
      composed_verlet(sofroniou_spaletta_10, "thirty-five Stoermer-Verlet steps, for small error constants")};
  return methods;
}

}  // namespace brouwer
