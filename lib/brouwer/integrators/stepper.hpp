#pragma once
#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <brouwer/systems/failure.hpp>
#include <brouwer/systems/state.hpp>

namespace brouwer {

/// What a stepper is made from.
template <class System>
struct Setup {
  System system;
  typename System::Scalar step;  ///< h, in the system's unit of time
  typename System::State
      start;                ///< constants of one trajectory (first integrals, lengths of series) are taken from here
  bool whole_state = true;  ///< false: a part of the state that nothing asks for may stay at its start
};

/// A step gives either the next value or the change; how a change is added, plainly or with compensation, is the state's
/// business. Only increments can be compensated.
template <class S>
concept DirectStep = std::copyable<S> && State<typename S::State> && requires(S const step, typename S::State const y) {
  { step(y) } -> std::same_as<typename S::State>;
};

template <class S>
concept IncrementStep = std::copyable<S> && State<typename S::State> &&
    requires(S const step, typename S::State const y) {
  { step.increment(y) } -> std::same_as<typename S::State>;
};

template <class S>
concept Step = DirectStep<S> || IncrementStep<S>;

/// A stepper is a step of the size and the start that it was built for. It is a value: copyable, no clock, no history; the
/// system's parameters and the method's constants live in it, rounded once, in its constructor.
///
/// Steppers that differ in their constructors alone may name a base as their `Core`, which then is compiled once.
template <class S>
concept Stepper = Step<S> && std::constructible_from<S, Setup<typename S::System>> && requires {
  { S::order } -> std::convertible_to<int>;  // 0: exact up to rounding
};

template <class S>
struct CoreOf {
  using type = S;
};
template <class S>
requires requires { typename S::Core; }
struct CoreOf<S> {
  using type = typename S::Core;
};

/// An IncrementStep that solves an equation by iteration shows its phases, so that the packs of a block can go
/// through them side by side: the latency of one is hidden behind the others. Its increment(y) is
///     e = begin(y); turn(y, e) blind_turns() times; settle(y, e, blind_turns()); finish(y, e).
/// settle is told how many turns were made, of those that no lane can do without: at most blind_turns().
template <class S>
concept IterativeStep = IncrementStep<S> &&
    requires(S const step, typename S::State const y, typename S::Equation e, int made) {
  { step.begin(y) } -> std::same_as<typename S::Equation>;
  { step.blind_turns() } -> std::same_as<int>;
  step.turn(y, e);
  step.settle(y, e, made);
  { step.finish(y, e) } -> std::same_as<typename S::State>;
};

/// A step whose iteration may take another number of turns each time can be asked how many it took: they are added to
/// `turns`, lane by lane.
template <class S>
concept CountsIterations = IncrementStep<S> &&
    requires(S const step, typename S::State const y, typename S::Scalar& turns) {
  { step.increment(y, turns) } -> std::same_as<typename S::State>;
};

/// A Step that is a long chain of operations shows itself in stages, for the same reason. A step is
///     stage<0>(y, w); …; stage<stages − 1>(y, w); finish(y, w)
/// where finish alone changes y: in place, because stores are what a block of packs has fewest of.
template <class S>
concept StagedStep = Step<S> && requires(S const step, typename S::State const y, typename S::Work w) {
  { S::stages } -> std::convertible_to<int>;
  step.template stage<0>(y, w);
  requires requires(typename S::State next) { step.finish(next, w); };
};

/// What a stepper sees of a state, and how a change is added: plainly, or with what rounding costs carried along.
template <State S>
S const& value_of(S const& y) {
  return y;
}
template <State S>
S const& value_of(Compensated<S> const& y) {
  return y.value;
}
template <State S>
void add(S& y, S const& increment) {
  for_components([](auto& a, auto const& d) { a = a + d; }, y, increment);
}
template <State S>
void add(Compensated<S>& y, S const& increment) {
  y.add(increment);
}

/// What a scalar remembers of its last operation (modelled.hpp) ends with the step.
template <State S>
void settle(S& y) {
  if constexpr (requires(typename S::Scalar & a) { a.settle(); }) for_components([](auto& a) { a.settle(); }, y);
}

/// One step.
template <Step S, class Y>
void take_step(S const& step, Y& y) {
  if constexpr (IncrementStep<S>) {
    add(y, step.increment(value_of(y)));
  } else {
    y = step(y);
    settle(y);
  }
}

/// The loop over steps, written once for every method, arithmetic and kind of summation.
template <Step S, class Y>
void advance(S const& step, Y& y, std::int64_t steps) {
  for (std::int64_t i = 0; i < steps; ++i) take_step(step, y);
}

/// The same, and how many turns of the method's iteration that took, lane by lane.
template <CountsIterations S, class Y>
void advance(S const& step, Y& y, std::int64_t steps, typename S::Scalar& turns) {
  for (std::int64_t i = 0; i < steps; ++i) add(y, step.increment(value_of(y), turns));
}

/// The same for a block of states (packs of members), each with its stepper: step by step through all of them, so that
/// a processor which reorders instructions overlaps one pack's with the next one's. Flattened: everything is inlined.
template <Step S, class Y>
[[gnu::flatten]] void advance_block(std::span<S const> steppers, std::span<Y> states, std::int64_t steps) {
  for (std::int64_t i = 0; i < steps; ++i)
    for (std::size_t p = 0; p < states.size(); ++p) take_step(steppers[p], states[p]);
}

template <IterativeStep S, class Y>
[[gnu::flatten]] void advance_block(std::span<S const> steppers, std::span<Y> states, std::int64_t steps) {
  std::vector<typename S::Equation> equations(states.size());
  int blind = std::numeric_limits<int>::max();
  for (auto const& step : steppers) blind = std::min(blind, step.blind_turns());
  std::size_t const packs = states.size();
  for (std::int64_t i = 0; i < steps; ++i) {
    for (std::size_t p = 0; p < packs; ++p) equations[p] = steppers[p].begin(value_of(states[p]));
    for (int turn = 0; turn < blind; ++turn)
      for (std::size_t p = 0; p < packs; ++p) steppers[p].turn(value_of(states[p]), equations[p]);
    for (std::size_t p = 0; p < packs; ++p) steppers[p].settle(value_of(states[p]), equations[p], blind);
    for (std::size_t p = 0; p < packs; ++p) add(states[p], steppers[p].finish(value_of(states[p]), equations[p]));
  }
}

template <StagedStep S, class Y>
[[gnu::flatten]] void advance_block(std::span<S const> steppers, std::span<Y> states, std::int64_t steps) {
  std::vector<typename S::Work> work(states.size());
  std::size_t const packs = states.size();
  for (std::int64_t i = 0; i < steps; ++i) {
    [&]<int... stage>(std::integer_sequence<int, stage...>) {
      (
          [&] {
            for (std::size_t p = 0; p < packs; ++p) steppers[p].template stage<stage>(value_of(states[p]), work[p]);
          }(),
          ...);
    }
    (std::make_integer_sequence<int, S::stages>());
    for (std::size_t p = 0; p < packs; ++p) steppers[p].finish(states[p], work[p]);
  }
}

}  // namespace brouwer
