#pragma once
#include <limits>

#include <brouwer/systems/state.hpp>

namespace brouwer {

/// When a fixed-point iteration has come to rest, lane by lane.
///
/// A component is at rest in a turn that moved it not at all, or no less than one before: rounding alone is left.
/// (E. Hairer, R. I. McLachlan, A. Razakarivony, BIT Numer. Math. 48 (2008) 231; by components M. Antoñana, J. Makazaga,
/// A. Murua, Numer. Algorithms 76 (2017) 861.) Where a tolerance τ is given, so is one that moved by no more than τ|y|. A
/// lane is at rest when all its components are in one turn, and none moved by more than 2¹⁰ ε of the size of the step:
/// above that growing moves are no noise.
template <State S>
struct ComingToRest {
  using Scalar = typename S::Scalar;
  S least;              ///< of each component, the smallest of its moves that were not zero
  Scalar noise;         ///< above this, moves are none
  Mask<Scalar> active;  ///< the lanes that are not at rest yet

  /// @param y       where the step begins
  /// @param change  by about how much it goes
  ComingToRest(S const& y, S const& change) : least(y), noise(0), active(Scalar(0) < Scalar(1)) {
    for_components(
        [this](Scalar& of_component, Scalar const& start, Scalar const& d) {
          using math::abs;
          noise = larger(Scalar(abs(start) + abs(d)), noise);
          of_component = std::numeric_limits<Scalar>::infinity();
        },
        least, y, change);
    noise = Scalar(1024) * epsilon<Scalar>() * noise;
  }

  /// After a turn in which the components moved by so much. A lane with a NaN goes on no more: it compares as no move.
  void look(S const& y, S const& moved, Scalar const& tolerance) {
    Scalar largest(0);
    auto falling = Scalar(1) < Scalar(0);
    for_components(
        [&](Scalar& of_component, Scalar const& move, Scalar const& start) {
          using math::abs;
          falling = either(falling, both(move > tolerance * abs(start), move < of_component));
          of_component = select(move > Scalar(0), smaller(move, of_component), of_component);
          largest = larger(move, largest);
        },
        least, moved, y);
    active = both(active, either(falling, largest > noise));
  }
};

}  // namespace brouwer
