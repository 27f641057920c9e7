#pragma once
#include <array>
#include <vector>

#include <brouwer/integrators/explicit_tableaux.hpp>
#include <brouwer/integrators/stages.hpp>
#include <brouwer/integrators/stepper.hpp>
#include <brouwer/scalar/wider.hpp>
#include <brouwer/systems/system.hpp>

namespace brouwer {

/// An explicit Runge–Kutta method, by its tableau: kᵢ = h rate(y + Σ aᵢⱼ kⱼ), increment Σ bᵢ kᵢ. Sums run from the first
/// stage to the last over the coefficients that are not zero, before y is added; stages that nothing uses (the eleventh of
/// Fehlberg's order 8 is there for order 7) are not evaluated.
template <FieldSystem S>
class ExplicitRungeKutta {
 public:
  using System = S;
  using Scalar = typename System::Scalar;
  using State = typename System::State;
  static constexpr bool runs_in_lanes = true;

  ExplicitRungeKutta(Setup<System> const& setup, ExplicitTableau const& tableau)
      : system_(setup.system), step_(setup.step) {
    auto const s = static_cast<std::size_t>(tableau.stages);
    for (std::size_t i = 0; i < s; ++i)
      if (tableau.uses(i)) rows_.push_back(terms(tableau, std::span(tableau.a[i], i)));
    weights_ = terms(tableau, std::span(tableau.b, s));
  }

  State increment(State const& y) const {
    return walk(y, [](State const&) { return true; });
  }

  /// Why the step from y gives no finite state.
  Failure failure(State const& y, int l) const {
    Failure reason = is_finite(y, l) ? Failure::none : Failure::not_finite;
    if (reason != Failure::none) return reason;
    State const change = walk(y, [&](State const& stage) {
      reason = failure_of_stage(system_, stage, l);
      return reason == Failure::none;
    });
    return reason == Failure::none ? failure_of_ends(system_, y, change, l) : reason;
  }

 private:
  using Stages = StageList<State, ExplicitTableau::most_stages>;

  struct Term {
    std::size_t stage;  ///< of those that are evaluated
    Element<Scalar> weight;
  };

  /// What is not zero, rounded once.
  static std::vector<Term> terms(ExplicitTableau const& tableau, std::span<Ratio const> row) {
    using W = Wider<Element<Scalar>>;
    std::vector<Term> kept;
    std::size_t evaluated = 0;
    for (std::size_t j = 0; j < row.size(); ++j) {
      if (!row[j].is_zero()) kept.push_back({evaluated, rounded<Element<Scalar>>(row[j].in<W>())});
      if (tableau.uses(j)) ++evaluated;
    }
    return kept;
  }

  /// As far as `go_on(stage)` says before the rate is taken there.
  template <class GoOn>
  State walk(State const& y, GoOn go_on) const {
    Stages k;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      State const stage = i == 0 ? y : sum(y, combined(rows_[i], k));
      if (!go_on(stage)) return stage;
      State change = system_.rate(stage);
      for_components([this](Scalar& a) { a = step_ * a; }, change);
      k.push_back(change);
    }
    return combined(weights_, k);
  }

  static State combined(std::vector<Term> const& row, Stages const& k) {
    State change = weighted<Scalar>(row[0].weight, k[row[0].stage]);
    for (std::size_t n = 1; n < row.size(); ++n) add_weighted<Scalar>(change, row[n].weight, k[row[n].stage]);
    return change;
  }

  System system_;
  Scalar step_;
  std::vector<std::vector<Term>> rows_;  ///< the first is empty
  std::vector<Term> weights_;
};

}  // namespace brouwer
