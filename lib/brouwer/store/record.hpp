#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace brouwer {

/// The level of an option that a method does not have.
inline constexpr char const* no_level = "-";

/// The level of every factor of a study in one cell of the factorial design, and what it ran.
struct CellLabels {
  std::string system;
  std::string method;
  std::string arithmetic;
  std::string special_functions;  ///< own, gsl, boost; "-" where the method uses none
  std::string coefficients;       ///< per-step, per-trajectory; "-" where the method has no modified ones
  bool compensation = false;
  double step = 0;                    ///< h, in the system's unit of time
  std::int64_t steps = 0;             ///< how many
  std::string rounding = "nearest";   ///< of every operation of a step: nearest, up, down, toward-zero, stochastic
  std::string constants = "rounded";  ///< of the method: rounded, or exact (held in two numbers each)
  bool contraction = false;           ///< are products that are added fused with the sum, as compilers may?

  bool operator==(CellLabels const&) const = default;
};

/// The errors of one scalar quantity, member by member: (value now − value at the start) / the system's scale for first
/// integrals (energy and Casimir: relative, see `unit`), or value − reference for the state; formed in wider arithmetic
/// and rounded once.
struct Series {
  std::string name;            ///< component, e.g. "energy", "spatial-momentum-1"
  std::string quantity;        ///< the quantity it belongs to, e.g. "spatial-momentum"
  std::string unit;            ///< for people
  std::int64_t members = 0;    ///< the unit's first members that have it (all, unless it needs a reference)
  std::vector<double> errors;  ///< [member][sample], row-major; NaN from the sample on at which a member failed
  bool count = false;  ///< a number of something, iterations per step say: it has a mean and a spread but no law of
                       ///< growth
};

/// Members that have no next state for one reason.
struct Failures {
  std::string reason;  ///< a clause, "the iteration did not converge", or one noun, "collision"; "" where not recorded
  std::int64_t members = 0;
  std::int64_t first_step = -1;  ///< the earliest step at which one of them failed; −1 where not recorded
  bool operator==(Failures const&) const = default;
};

/// What one work unit observed: a block of consecutive members of one cell.
struct UnitRecord {
  std::string study_hash;
  CellLabels cell;
  std::string reference;  ///< with what states were compared: none, exact, or an arithmetic in which the method ran
  std::int64_t first_member = 0;
  std::int64_t members = 0;
  std::vector<std::int64_t> sample_steps;  ///< increasing step numbers, the last is cell.steps
  std::vector<Series> series;              ///< series with members == 0 are kept, with empty errors

  std::vector<std::string> start_names;  ///< parameters and state components: inertia-1 …, y1 …, q3
  std::vector<double> start;             ///< [member][start_names]: exactly what was integrated
  std::vector<std::string> state_names;  ///< y1 … q3
  std::vector<double> final_state;       ///< [member][state_names], rounded to double

  std::vector<std::int64_t> failed_at;  ///< [member]: the step at which it had no next state, or −1; empty in units
                                        ///< from before this was recorded
  std::vector<std::string>
      failure;  ///< [member]: why, in words ("the iteration did not converge"); "" where none. With failed_at = −1: what
                ///< became of its comparison with the reference
  std::vector<double> states;  ///< [member][sample][state_names], rounded to double, for pictures of phase
                               ///< space; empty unless the study asked for it
};

}  // namespace brouwer
