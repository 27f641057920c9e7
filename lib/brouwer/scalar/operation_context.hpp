#pragma once
#include <Random123/philox.h>

#include <array>
#include <bit>
#include <cstdint>

#include <brouwer/scalar/operation_rule.hpp>

namespace brouwer {

/// Random numbers of one member: xoshiro256+ (D. Blackman, S. Vigna, ACM Trans. Math. Softw. 47 (2021) 36), whose state
/// is what Philox 4×64-10 makes of (seed, member). A value: a copy gives the same numbers again.
class MemberRandom {
 public:
  MemberRandom() = default;
  /// The last word of the counter is 1: the draws of starts (ensemble/start.cpp) have 0 there.
  MemberRandom(std::uint64_t seed, std::uint64_t member) {
    auto const words = r123::Philox4x64{}({{0, 0, 0, 1}}, {{seed, member}});
    for (std::size_t i = 0; i < 4; ++i) state_[i] = words[i];
  }

  /// One of 0, 2⁻⁵³, … , 1 − 2⁻⁵³.
  double next() {
    std::uint64_t const sum = state_[0] + state_[3], shifted = state_[1] << 17U;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = std::rotl(state_[3], 45);
    return static_cast<double>(sum >> 11U) * 0x1p-53;
  }

  bool operator==(MemberRandom const&) const = default;

 private:
  std::array<std::uint64_t, 4> state_ = {1, 2, 3, 4};
};

/// How Modelled numbers (modelled.hpp) compute in this thread at this moment.
struct OperationContext {
  OperationRule rule = {};
  bool forming_constants = false;  ///< rounded to nearest; with exact constants, to about twice the bits
  MemberRandom random = {};
};

inline thread_local constinit OperationContext operation_context = {};

/// For the time of its life this thread computes in another context.
class ContextScope {
 public:
  explicit ContextScope(OperationContext const& context) : former_(operation_context) { operation_context = context; }
  ~ContextScope() { operation_context = former_; }
  ContextScope(ContextScope const&) = delete;
  ContextScope& operator=(ContextScope const&) = delete;

 private:
  OperationContext former_;
};

}  // namespace brouwer
