#pragma once
#include <memory>

#include "tests/benchmarks/kernels.hpp"
#include "tests/benchmarks/peak.hpp"

namespace brouwer::benchmarks {

// Counters of a kernel's benchmark, by which the table finds them again.
inline constexpr char const* counter_time = "ns/member-step";  ///< by the wall where threads share the work
inline constexpr char const* counter_flops = "flops/member-step";
inline constexpr char const* counter_peak = "of peak";  ///< flops over those of as many additions as multiplications
// … and the shares of the time for which units are busy; one of them near 100 % binds.
inline constexpr char const* counter_adders = "adders busy";
inline constexpr char const* counter_multipliers = "multipliers busy";
inline constexpr char const* counter_divider = "divider busy";
/// … and of a peak's.
inline constexpr char const* counter_rate = "operations/ns";

/// Each thread advances a work unit of its own.
void register_kernel(std::shared_ptr<Catalogue const> const& catalogue, Kernel const& kernel, int threads = 1);

std::string name_of(Mix mix, InstructionSet set, std::string const& arithmetic);
void register_peak(Mix mix, InstructionSet set, std::string const& arithmetic, int threads = 1);

}  // namespace brouwer::benchmarks
