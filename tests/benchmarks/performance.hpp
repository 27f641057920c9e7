#pragma once
#include <benchmark/benchmark.h>

#include <memory>

#include "tests/benchmarks/kernels.hpp"

namespace brouwer::benchmarks {

/// Registers what the table of docs/performance.md needs and nothing else.
/// @return  prints the table once everything has been measured
std::unique_ptr<benchmark::BenchmarkReporter> register_performance(std::shared_ptr<Catalogue const> const& catalogue);

}  // namespace brouwer::benchmarks
