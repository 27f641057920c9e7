#pragma once
#include <cstdint>

namespace brouwer {

// Beyond these a number in a study file is taken for a mistake.
constexpr std::int64_t most_members = 1'000'000'000;
constexpr std::int64_t most_steps =
    1'000'000'000'000'000;  // 10^15: years on any machine, and still counted exactly by a double
constexpr std::int64_t most_samples = 100'000;
constexpr std::int64_t most_ulps = 1'000'000;

}  // namespace brouwer
