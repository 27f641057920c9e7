#pragma once
#include <string>
#include <vector>

namespace brouwer {

/// The vector instructions that packs are compiled for, from narrow to wide. They decide how many members a pack holds
/// and nothing else: a member's bits are the same in all of them, and without packs.
enum class InstructionSet {
  none,    ///< no packs: one member after the other
  sse2,    ///< 16 bytes: 2 double, 4 float; every x86-64
  avx2,    ///< 32 bytes, with fused multiply-add (for double-double alone)
  avx512,  ///< 64 bytes: F, DQ, VL, BW
};

/// The one that this translation unit is compiled for, and the bytes of its registers.
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__) && defined(__FMA__)
inline constexpr InstructionSet native_instruction_set = InstructionSet::avx512;
inline constexpr int native_bytes = 64;
#elif defined(__AVX2__) && defined(__FMA__)
inline constexpr InstructionSet native_instruction_set = InstructionSet::avx2;
inline constexpr int native_bytes = 32;
#else
inline constexpr InstructionSet native_instruction_set = InstructionSet::sse2;
inline constexpr int native_bytes = 16;
#endif

/// "none", "sse2", "avx2", "avx512", in this order.
std::vector<std::string> const& instruction_set_names();
std::string const& name_of(InstructionSet set);
/// @throws InputError if there is no such name, or if this processor does not have it
InstructionSet instruction_set(std::string const& name);
/// The widest that this processor has.
InstructionSet widest_instruction_set();

}  // namespace brouwer
