#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <brouwer/ensemble/plan.hpp>
#include <brouwer/ensemble/run.hpp>
#include <brouwer/store/local_errors.hpp>

namespace brouwer {

/// Which steps of which members are looked at one by one: of each of the first `members` members `windows` windows of
/// `length` consecutive steps. Each window lies at random in its own part of the first `covered` steps, for each member
/// elsewhere, so that no period of the motion is in step with them.
struct ProbeDesign {
  std::int64_t members = 64;
  std::int64_t windows = 8;
  std::int64_t length = 64;
  std::int64_t covered = 8192;

  std::int64_t steps() const { return windows * length; }  ///< of each member
};

/// The design as far as a cell goes: a run shorter than `covered` is covered whole, in shorter windows where need be.
ProbeDesign fitted(ProbeDesign design, Study const& study, CellLabels const& cell);

/// The step at which a member's window begins; depends on (seed, member, window) and the design alone (Philox).
std::int64_t window_begin(ProbeDesign const& design, std::uint64_t seed, std::int64_t member, std::int64_t window);

/// The arithmetic in which a cell's steps are judged: double-double for numbers of up to 64 bits (a local error is then
/// right to 40 bits, and lanes compute it), mpfr-256 for double-double. "" where a state, with its carried residue, would
/// not fit into the two doubles from which a high-precision step begins: float128, mpfr, compensated double-double.
std::string judge_of(Catalogue const& catalogue, CellLabels const& cell);

/// Why a cell cannot be probed, in one sentence: states that judge_of does not know, fewer than 2 members, fewer steps than
/// windows of 4 need; "" where it can.
std::string reason_not_to_probe(Study const& study, Catalogue const& catalogue, CellLabels const& cell,
                                ProbeDesign const& design);

/// What a probe of a cell found, and what it took.
struct Probe {
  std::vector<LocalErrors> errors;  ///< of each component of the study's quantities, in the study's order; no counts
  ProbeDesign design;               ///< as fitted to the cell
  double seconds = 0;               ///< processor time, of all threads together
};

/// Walks the members of a cell along their trajectories and, in the windows, compares steps with steps of the same method
/// in higher precision from the same state, value and carried residue, both exactly. Depends on (study, cell, design)
/// alone: not on threads or lanes.
///
/// The first step of every window is always compared. Where these change no first integral by more than 2⁻¹⁶ of what
/// rounding does, the method conserves them all, and the local error of any other step is what the working step changes;
/// elsewhere every step of the windows is compared.
/// @throws InputError where there is a reason not to
Probe probe(Study const& study, Catalogue const& catalogue, CellLabels const& cell, ProbeDesign const& design,
            RunOptions const& options);

}  // namespace brouwer
