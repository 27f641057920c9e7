#pragma once
#include <concepts>
#include <cstdint>

#include <brouwer/systems/state.hpp>

namespace brouwer {

/// What a stepper is made from.
template <class System>
struct Setup {
  System system;
  typename System::Scalar step;  ///< h, in the system's unit of time
  typename System::State
      start;             ///< constants of one trajectory (first integrals, lengths of series) are taken from here
  bool attitude = true;  ///< false: the part of the state that nothing asks for stays at its start
};

/// A stepper advances a state by one step of the size that it was built for. It is a value: copyable, no clock, no
/// history; the system's parameters and the method's constants live in it, rounded once, in its constructor.
///
/// It gives either the next value (a DirectStepper) or the change (an IncrementStepper); how a change is added,
/// plainly or with compensation, is the state's business. Only increments can be compensated.
template <class S>
concept DirectStepper = std::copyable<S> && State<typename S::State> &&
    std::constructible_from<S, Setup<typename S::System>> && requires(S const step, typename S::State const y) {
  { step(y) } -> std::same_as<typename S::State>;
  { S::order } -> std::convertible_to<int>;  // 0: exact up to rounding
};

template <class S>
concept IncrementStepper = std::copyable<S> && State<typename S::State> &&
    std::constructible_from<S, Setup<typename S::System>> && requires(S const step, typename S::State const y) {
  { step.increment(y) } -> std::same_as<typename S::State>;
  { S::order } -> std::convertible_to<int>;
};

template <class S>
concept Stepper = DirectStepper<S> || IncrementStepper<S>;

/// One step.
template <Stepper S>
void take_step(S const& step, typename S::State& y) {
  if constexpr (IncrementStepper<S>)
    y = sum(y, step.increment(y));
  else
    y = step(y);
}

/// One step, with what rounding costs carried along.
template <IncrementStepper S>
void take_step(S const& step, Compensated<typename S::State>& y) {
  y.add(step.increment(y.value));
}

/// The loop over steps, written once for every method, arithmetic and kind of summation.
template <Stepper S, class Y>
void advance(S const& step, Y& y, std::int64_t steps) {
  for (std::int64_t i = 0; i < steps; ++i) take_step(step, y);
}

}  // namespace brouwer
