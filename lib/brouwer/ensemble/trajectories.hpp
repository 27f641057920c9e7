#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <brouwer/scalar/mpfr.hpp>
#include <brouwer/scalar/operation_rule.hpp>
#include <brouwer/systems/failure.hpp>

namespace brouwer {

/// Wide enough to hold a value of any arithmetic of the catalogue exactly; only the difference of two
/// trajectories and text output pass through it.
using Widest = Mpfr<1024>;

/// What one member starts from: the system's parameter fields and its other fields, one after the other. What is meant
/// is state + state_rest, for an arithmetic that can hold the sum: a state on the way is carried with its residue.
struct Start {
  std::vector<double> parameters, state;
  std::vector<double> state_rest = {};  ///< empty: 0
};

/// Names and numbers from which a method makes trajectories.
struct TrajectoryRequest {
  std::string arithmetic;
  std::string special_functions;
  std::string coefficients;  ///< per-step, standard …; not asked for by a method without them
  bool compensation = false;
  bool whole_state = true;        ///< false: the parts that nothing asks for may stay at their start
  double step = 0;                ///< h, held exactly; rounded to the arithmetic where that is narrower
  std::vector<Start> starts;      ///< of the members; at least one
  OperationRule rule = {};        ///< of every operation of a step
  std::uint64_t seed = 0;         ///< of stochastic rounding: a member's random numbers depend on the seed
  std::int64_t first_member = 0;  ///< and on its number in the study, first_member + its place here
};

/// When a member had no next state, and why.
struct MemberFailure {
  std::int64_t step = 0;  ///< after so many steps its state was still finite
  Failure reason = Failure::none;
};

/// Some members of a cell under way, side by side. The scalar (a number, or a pack with a member in each lane), the
/// steppers and the residues of compensated sums are inside; a call per sampling interval crosses this boundary, so
/// that it costs nothing. No member's numbers depend on the others.
class Trajectories {
 public:
  virtual ~Trajectories() = default;
  virtual std::size_t members() const = 0;
  virtual void advance(std::int64_t steps) = 0;

  /// Components of a member's state now (with the carried residue, where there is one).
  virtual void state(std::size_t member, std::span<Widest> components) const = 0;

  /// Errors of the first integrals since the start, [member][integral], in the order of the system's quantities that
  /// need no reference, component by component; formed in wider arithmetic (observing.hpp), rounded once.
  virtual void first_integral_errors(std::span<double> errors) const = 0;

  /// Errors of a member's state against `reference` (a state from Trajectories::state or exact_state), in the order
  /// of the quantities that need a reference.
  virtual void state_errors(std::size_t member, std::span<Widest const> reference, std::span<double> errors) const = 0;

  /// A member's first integrals minus those of `reference`, in the order and the scales of first_integral_errors.
  virtual void rounding_errors(std::size_t member, std::span<Widest const> reference,
                               std::span<double> errors) const = 0;

  /// Turns of the method's iteration that a member took since the start; NaN where the method does not count any.
  virtual double iterations(std::size_t member) const = 0;

  /// Nothing while a member is well.
  virtual std::optional<MemberFailure> failure(std::size_t member) const = 0;

  /// A member's first integrals now, rounded to Widest, in the order of first_integral_errors.
  virtual void first_integrals(std::size_t member, std::span<Widest> values) const = 0;

  /// The exact flow from a member's start, after `steps` steps of its h (as rounded to its arithmetic); evaluated
  /// directly, in wider arithmetic. Only where the scalar is a number.
  virtual void exact_state(std::size_t member, std::int64_t steps, std::span<Widest> components) const = 0;
};

}  // namespace brouwer
