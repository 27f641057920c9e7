#pragma once
#include <array>
#include <limits>
#include <span>

#include <brouwer/integrators/coming_to_rest.hpp>
#include <brouwer/integrators/gauss_coefficients.hpp>
#include <brouwer/integrators/stages.hpp>
#include <brouwer/integrators/stepper.hpp>
#include <brouwer/scalar/wider.hpp>
#include <brouwer/systems/system.hpp>

namespace brouwer {

/// An implicit Runge–Kutta method in one of the forms of its coefficients (gauss_coefficients.hpp):
///     Yᵢ = y + Σⱼ mᵢⱼkⱼ    kᵢ = hwᵢ rate(Yᵢ)    increment Σⱼ vⱼkⱼ
/// solved by fixed-point iteration for k, stage after stage, each with the newest of the others (Gauss–Seidel). Where the
/// system is separable a turn finds the velocities of all stages, then the forces: for as many evaluations it gains
/// twice the digits. The first iterate is k = hw rate(y): a step has no history to extrapolate from.
///
/// A lane is frozen when it has come to rest (coming_to_rest.hpp): in the standard form, which shows what a tolerance does,
/// at u|y|, u = ε/2; in the others where rounding alone is left. One that does not in `limit` turns becomes NaN.
///
/// In double-double the iteration begins where that of the high parts, in double, comes to rest: half the turns are cheap.
template <FieldSystem S>
class ImplicitRungeKutta {
 public:
  using System = S;
  using Scalar = typename System::Scalar;
  using State = typename System::State;
  static constexpr bool runs_in_lanes = true;
  static constexpr int limit = 50 + 8 * significand_bits<Scalar>;  ///< linear convergence, at worst 1/8 bit a turn

  ImplicitRungeKutta(Setup<System> const& setup, ImplicitMethod const& method, CoefficientForm form)
      : system_(setup.system),
        coefficients_(&implicit_coefficients<Element<Scalar>>(method, form)),
        tolerance_(form == CoefficientForm::standard ? Scalar(epsilon<Scalar>() / Scalar(2)) : Scalar(0)),
        high_(in_high_parts(setup, method, form)) {
    set_steps(setup.step);
  }

  State increment(State const& y) const {
    Scalar turns(0);
    return increment(y, turns);
  }

  State increment(State const& y, Scalar& turns) const {
    Iterate e = first_iterate(y);
    improve(y, e, turns);
    solve(y, e, turns);
    return finish(e);
  }

  /// Why the step from y gives no finite state.
  Failure failure(State const& y, int l) const {
    if (!is_finite(y, l)) return Failure::not_finite;
    if constexpr (has_high_part)
      if (auto const reason = high_.failure(high(y), l); reason != Failure::none) return reason;
    Scalar turns(0);
    Iterate e = first_iterate(y);
    improve(y, e, turns);
    for (int i = 0; i < limit && is_set(e.rest.active, l); ++i) {
      if (auto const reason = failure_of_stages(y, e, l); reason != Failure::none) return reason;
      turn(y, e);
    }
    if (is_set(e.rest.active, l)) return Failure::no_convergence;
    auto const reason = failure_of_stages(y, e, l);
    return reason == Failure::none ? failure_of_ends(system_, y, finish(e), l) : reason;
  }

 private:
  static constexpr std::size_t most_stages = ImplicitMethod::most_stages;
  using Stages = StageList<State, most_stages>;

  template <FieldSystem>
  friend class ImplicitRungeKutta;

  /// The same method over the leading parts of the scalar, if it has such.
  static constexpr bool has_high_part = !std::is_void_v<typename HighPart<Scalar>::type>;
  struct Nothing {};
  template <bool has_it, class Any>
  struct InHighParts {
    using type = Nothing;
  };
  template <class Any>
  struct InHighParts<true, Any> {
    using type = ImplicitRungeKutta<typename Any::template In<Leading<Scalar>>>;
  };
  using High = typename InHighParts<has_high_part, System>::type;

  /// The stages' changes, being found.
  struct Iterate {
    Stages k;
    ComingToRest<State> rest;

    /// k = hw rate(y)
    Iterate(State const& y, State const& rate, std::span<Scalar const> steps) : rest(y, scaled(steps[0], rate)) {
      for (auto const& step : steps) k.push_back(scaled(step, rate));
    }
  };

  static State scaled(Scalar const& step, State rate) {
    for_components([&step](Scalar& k) { k = step * k; }, rate);
    return rate;
  }

  std::size_t stages() const { return coefficients_->stages; }

  /// hwᵢ, rounded once. In the symplectic form the outermost are what the others leave of h, so that Σ hwᵢ = h to rounding:
  /// time goes on by h (Antoñana, Makazaga, Murua).
  void set_steps(Scalar const& h) {
    using W = Wider<Scalar>;
    std::size_t const s = stages();
    for (std::size_t i = 0; i < s; ++i) steps_[i] = rounded<Scalar>(W(W(h) * W(coefficients_->w[i])));
    if (s < 2 || coefficients_->w[0] == Wider<Element<Scalar>>(1)) return;
    W left(h);
    for (std::size_t i = 1; i + 1 < s; ++i) left = left - W(steps_[i]);
    steps_[0] = steps_[s - 1] = rounded<Scalar>(W(left / W(2)));
  }

  static High in_high_parts(Setup<System> const& setup, ImplicitMethod const& method, CoefficientForm form) {
    if constexpr (has_high_part)
      return High({setup.system.template in<Leading<Scalar>>(), setup.step.high(), high(setup.start)}, method, form);
    else
      return {};
  }
  static auto high(State const& y) requires has_high_part {
    typename High::State leading;
    for_components([](auto& a, Scalar const& b) { a = b.high(); }, leading, y);
    return leading;
  }

  void solve(State const& y, Iterate& e, Scalar& turns) const {
    for (int i = 0; i < limit && any(e.rest.active); ++i) {
      turns = turns + select(e.rest.active, Scalar(1), Scalar(0));
      turn(y, e);
    }
  }

  Iterate first_iterate(State const& y) const { return Iterate(y, system_.rate(y), std::span(steps_).first(stages())); }

  /// … to where the iteration in the high parts leads, if there are such.
  void improve(State const& y, Iterate& e, Scalar& turns) const {
    if constexpr (has_high_part) {
      auto leading = high_.first_iterate(high(y));
      typename High::Scalar leading_turns(0);
      high_.solve(high(y), leading, leading_turns);
      turns = turns + Scalar(leading_turns);
      for (std::size_t i = 0; i < stages(); ++i)
        for_components([](Scalar& k, auto const& from) { k = Scalar(from); }, e.k[i], leading.k[i]);
    } else {
      (void)y, (void)e, (void)turns;
    }
  }

  void turn(State const& y, Iterate& e) const {
    State moved = y;
    for_components([](Scalar& move) { move = Scalar(0); }, moved);
    if constexpr (SeparableSystem<System>) {
      for (std::size_t i = 0; i < stages(); ++i)
        accept(i, system_.velocity(stage_part(i, y, e, momenta)), e, moved, coordinates);
      for (std::size_t i = 0; i < stages(); ++i)
        accept(i, system_.force(stage_part(i, y, e, coordinates)), e, moved, momenta);
    } else {
      for (std::size_t i = 0; i < stages(); ++i) accept(i, system_.rate(stage_value(i, y, e)), e, moved, whole);
    }
    e.rest.look(y, moved, tolerance_);
  }

  // what of a state a stage is formed of, and a rate put in
  static constexpr auto whole = [](auto& s) -> auto& { return s; };
  static constexpr auto coordinates = [](auto& s) -> auto& { return s.q; };
  static constexpr auto momenta = [](auto& s) -> auto& { return s.p; };

  template <class PartOf>
  auto stage_part(std::size_t i, State const& y, Iterate const& e, PartOf part) const {
    auto const& c = *coefficients_;
    return added<Scalar>(part(y), combined(c.m[i], c.m_rest[i], e.k, part));
  }
  State stage_value(std::size_t i, State const& y, Iterate const& e) const { return stage_part(i, y, e, whole); }

  /// What the system knows of any stage goes before that another one is not finite.
  Failure failure_of_stages(State const& y, Iterate const& e, int l) const {
    Failure reason = Failure::none;
    for (std::size_t i = 0; i < stages(); ++i) {
      auto const of_this = failure_of_stage(system_, stage_value(i, y, e), l);
      if (of_this != Failure::none && (reason == Failure::none || reason == Failure::diverged)) reason = of_this;
    }
    return reason;
  }

  /// Σⱼ mⱼkⱼ from the first stage to the last, and the same with the rest, added at the end.
  template <class PartOf>
  auto combined(StageVector<Element<Scalar>> const& m, StageVector<Element<Scalar>> const& rest, Stages const& k,
                PartOf part) const {
    auto sum = combined(m, k, part);
    if (coefficients_->has_rest) sum = added<Scalar>(sum, combined(rest, k, part));
    return sum;
  }
  template <class PartOf>
  auto combined(StageVector<Element<Scalar>> const& m, Stages const& k, PartOf part) const {
    auto sum = weighted<Scalar>(m[0], part(k[0]));
    for (std::size_t j = 1; j < stages(); ++j) add_weighted<Scalar>(sum, m[j], part(k[j]));
    return sum;
  }

  template <class Rate, class PartOf>
  void accept(std::size_t i, Rate const& rate, Iterate& e, State& moved, PartOf part) const {
    for_numbers(
        [&](Scalar& k, Scalar& move, Scalar const& r) {
          using math::abs;
          Scalar const next = steps_[i] * r;
          move = larger(Scalar(abs(next - k)), move);
          k = select(e.rest.active, next, k);
        },
        part(e.k[i]), part(moved), rate);
  }

  State finish(Iterate const& e) const {
    auto const& c = *coefficients_;
    State change = combined(c.v, c.v_rest, e.k, whole);
    if (any(e.rest.active))
      for_components(
          [&e](Scalar& d) { d = select(e.rest.active, Scalar(std::numeric_limits<Scalar>::quiet_NaN()), d); }, change);
    return change;
  }

  System system_;
  ImplicitCoefficients<Element<Scalar>> const* coefficients_;  ///< kept for ever
  Scalar tolerance_;
  StageVector<Scalar> steps_{};  ///< hwᵢ
  [[no_unique_address]] High high_;
};

}  // namespace brouwer
