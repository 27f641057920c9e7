#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <brouwer/scalar/mpfr.hpp>

namespace brouwer {

/// Wide enough to hold a value of any arithmetic of the catalogue exactly; only the difference of two
/// trajectories and text output pass through it.
using Widest = Mpfr<1024>;

/// Names and numbers from which a method's `begin` makes a trajectory.
struct TrajectoryRequest {
  std::string arithmetic;
  std::string special_functions;
  std::string coefficients;
  bool compensation = false;
  bool attitude = true;            ///< false: nothing asks for the attitude, leave it at its start
  double step = 0;                 ///< h, held exactly; rounded to the arithmetic where that is narrower
  std::vector<double> parameters;  ///< the system's parameter fields, one after the other
  std::vector<double> start;       ///< the start's fields, one after the other
};

/// One member under way. The scalar, the stepper and the residue of a compensated sum are inside; a
/// call per sampling interval crosses this boundary, so that it costs nothing.
class Trajectory {
 public:
  virtual ~Trajectory() = default;
  virtual void advance(std::int64_t steps) = 0;

  /// Components of the state now (with the carried residue, where there is one).
  virtual void state(std::span<Widest> components) const = 0;

  /// Errors of the first integrals since the start, in the order of the system's quantities that need no
  /// reference, component by component; formed in wider arithmetic, rounded once.
  virtual void first_integral_errors(std::span<double> errors) const = 0;

  /// Errors of the state against `reference` (a state from Trajectory::state or exact_state), in the order
  /// of the quantities that need a reference.
  virtual void state_errors(std::span<Widest const> reference, std::span<double> errors) const = 0;

  /// First integrals now, rounded to Widest, in the order of first_integral_errors.
  virtual void first_integrals(std::span<Widest> values) const = 0;

  /// The exact flow from this member's start, after `steps` steps of this member's h (as rounded to
  /// its arithmetic); evaluated directly, in wider arithmetic.
  virtual void exact_state(std::int64_t steps, std::span<Widest> components) const = 0;
};

}  // namespace brouwer
