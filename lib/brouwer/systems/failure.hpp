#pragma once
#include <concepts>

namespace brouwer {

/// Why a member has no next state. A step that fails gives NaN, which costs the loop over steps nothing; the reason is
/// asked for afterwards (trajectories_of.hpp).
enum class Failure {
  none,
  not_finite,      ///< a number overflowed, and nobody knows more
  no_convergence,  ///< an iteration came to no end
  diverged,        ///< a step, or one of its stages, grew beyond all bounds
  step_too_large,  ///< the method does not exist for this step and start
  collision,       ///< bodies met
};

/// In words that follow "because": "the iteration did not converge".
constexpr char const* in_words(Failure failure) {
  switch (failure) {
    case Failure::none:
      return "";
    case Failure::not_finite:
      return "the state was no longer finite";
    case Failure::no_convergence:
      return "the iteration did not converge";
    case Failure::diverged:
      return "a step diverged";
    case Failure::step_too_large:
      return "the step is too large for the method";
    case Failure::collision:
      return "bodies collided";
  }
  return "";
}

/// A system or a stepper may know why there is no step (no rate of change) from a state in a lane. A system gives
/// Failure::none for states with which nothing is the matter.
template <class S, class State>
concept KnowsFailures = requires(S const s, State const y, int lane) {
  { s.failure(y, lane) } -> std::same_as<Failure>;
};

}  // namespace brouwer
