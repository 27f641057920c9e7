// benchmarks                  everything that the catalogue can run here; see --help, and --benchmark_filter
// benchmarks --performance    the table of docs/performance.md (the target `performance`)
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/benchmarks/performance.hpp"
#include "tests/benchmarks/registered.hpp"

int main(int argc, char** argv) {
  using namespace brouwer::benchmarks;
  std::vector<std::string> arguments(argv, argv + argc);
  auto const asked = std::find(arguments.begin(), arguments.end(), "--performance");
  bool const table = asked != arguments.end();
  if (table) {
    arguments.erase(asked);
    // those of the command line come later and win; interleaved, because the clock drifts
    for (auto const* standard :
         {"--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.02", "--benchmark_repetitions=7"})
      arguments.insert(arguments.begin() + 1, standard);
  }
  std::vector<char*> pointers;
  for (auto& argument : arguments) pointers.push_back(argument.data());
  int count = static_cast<int>(pointers.size());
  pointers.push_back(nullptr);
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 2;

  auto const catalogue = std::make_shared<brouwer::Catalogue const>(brouwer::builtin_catalogue());
  if (table) {
    auto const reporter = register_performance(catalogue);
    benchmark::RunSpecifiedBenchmarks(reporter.get());
  } else {
    for (auto const& kernel : all_kernels(*catalogue)) register_kernel(catalogue, kernel);
    for (auto const set : {brouwer::InstructionSet::none, brouwer::InstructionSet::sse2, brouwer::InstructionSet::avx2,
                           brouwer::InstructionSet::avx512})
      if (set <= brouwer::widest_instruction_set())
        for (auto const mix : all_mixes)
          for (auto const* arithmetic : {"float", "double"}) register_peak(mix, set, arithmetic);
    benchmark::RunSpecifiedBenchmarks();
  }
  benchmark::Shutdown();
  return 0;
}
