#pragma once
#include <brouwer/ensemble/instruction_set.hpp>
#include <string>
#include <vector>

#include "tests/benchmarks/flops.hpp"

namespace brouwer::benchmarks {

/// What is done in a loop to see how fast it goes: in twelve independent chains, enough to hide every latency.
enum class Mix { multiply_and_add, add, multiply, divide, root };
inline constexpr Mix all_mixes[] = {Mix::multiply_and_add, Mix::add, Mix::multiply, Mix::divide, Mix::root};
std::string const& name_of(Mix mix);

/// A loop in the registers of one instruction set, without fused multiply-add; InstructionSet::none: one number in each.
class PeakLoop {
 public:
  /// @param arithmetic  float, double, or double-double, which is made of double
  PeakLoop(Mix mix, InstructionSet set, std::string const& arithmetic);
  void run(std::int64_t turns) const { loop_(turns); }
  /// Numbers that a turn computes.
  double operations_per_turn() const { return operations_; }
  /// Operations a nanosecond now: the best of some runs of microseconds, so that nothing else came between.
  double rate() const;

 private:
  void (*loop_)(std::int64_t);
  double operations_;
};

/// The processor's speed as it is now: the clock drifts.
struct Peak {
  double multiply_and_add, add, multiply, divide, root;  ///< operations a nanosecond

  Peak(InstructionSet set, std::string const& arithmetic);
  // Nanoseconds for which a step keeps a kind of unit busy at least.
  double adders(StepCost const& cost) const { return cost.additions / add; }
  double multipliers(StepCost const& cost) const { return (cost.multiplications + cost.fused) / multiply; }
  double divider(StepCost const& cost) const { return cost.divisions / divide + cost.roots / root; }
};

}  // namespace brouwer::benchmarks
