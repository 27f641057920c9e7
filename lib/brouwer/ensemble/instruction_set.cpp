#include <brouwer/ensemble/instruction_set.hpp>

#include <fmt/format.h>

#include <algorithm>

#include <brouwer/error.hpp>
#include <brouwer/spelling.hpp>

namespace brouwer {

std::vector<std::string> const& instruction_set_names() {
  static std::vector<std::string> const names = {"none", "sse2", "avx2", "avx512"};
  return names;
}

std::string const& name_of(InstructionSet set) { return instruction_set_names().at(static_cast<std::size_t>(set)); }

InstructionSet widest_instruction_set() {
#if defined(__x86_64__)
  bool const fused = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  bool const wide = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                    __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512bw") != 0;
  if (fused && wide) return InstructionSet::avx512;
  if (fused) return InstructionSet::avx2;
#endif
  return InstructionSet::sse2;
}

InstructionSet instruction_set(std::string const& name) {
  auto const& names = instruction_set_names();
  auto const found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError(fmt::format("there is no instruction set '{}'{}", name, suggestion(name, names)));
  auto const set = static_cast<InstructionSet>(found - names.begin());
  if (set > widest_instruction_set())
    throw InputError(
        fmt::format("this processor does not have {}: its widest is {}", name, name_of(widest_instruction_set())));
  return set;
}

}  // namespace brouwer
