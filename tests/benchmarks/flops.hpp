#pragma once
#include "tests/benchmarks/counting.hpp"
#include "tests/benchmarks/kernels.hpp"

namespace brouwer::benchmarks {

/// What a step of a kernel does, per member and step: the mean over some.
struct StepCost {
  double additions = 0, multiplications = 0, divisions = 0, roots = 0, fused = 0, comparisons = 0;
  double flops = 0;
};

/// Counted by running the kernel's stepper over Counting numbers from the same starts; nothing for long double, for
/// arithmetic in software, for elliptic functions of other libraries and for Runge-Kutta methods in double-double.
std::optional<StepCost> count_step(Catalogue const& catalogue, Kernel const& kernel);

}  // namespace brouwer::benchmarks
