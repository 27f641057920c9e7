#pragma once
#include <brouwer/ensemble/start.hpp>
#include <string>
#include <vector>

namespace brouwer::benchmarks {

/// Something whose speed is measured: a cell of a study as `brouwer run` would run it, in one kind of packs.
struct Kernel {
  CellLabels cell;  ///< its steps are those of one call
  bool whole_state = true;
  InstructionSet set = InstructionSet::none;
};

inline constexpr int members = 64;  ///< one work unit's

/// "rigid_body/dmv-10/per-step/double/avx512/h:0.01/whole/compensated"
std::string name_of(Kernel const& kernel);

/// The kernel of a method; steps follow from the arithmetic.
Kernel kernel(Catalogue const& catalogue, MethodEntry const& method, std::string const& option,
              std::string const& arithmetic, InstructionSet set, double h, bool whole_state, bool compensation = false);

/// Everything that the catalogue can run on this processor.
std::vector<Kernel> all_kernels(Catalogue const& catalogue);

/// Options of a method: its variants of elliptic functions, or of coefficients, or "-".
std::vector<std::string> options_of(MethodEntry const& method);

/// Whether there are packs of exactly these registers; always for InstructionSet::none.
bool runs_in(MethodEntry const& method, std::string const& arithmetic, InstructionSet set);

/// The system's standard values, of which the first field that is no parameter is slightly different in each member.
std::vector<Start> starts_of_members(Catalogue const& catalogue, std::string const& system);

}  // namespace brouwer::benchmarks
