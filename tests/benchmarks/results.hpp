#pragma once
#include <benchmark/benchmark.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace brouwer::benchmarks {

/// Of the repetitions of a benchmark.
struct Summary {
  double median = 0;
  double spread = 0;  ///< half the distance of the quartiles, over the median
};

/// What the benchmarks of a run have counted, by name.
class Results {
 public:
  void add(benchmark::BenchmarkReporter::Run const& run);
  /// Nothing where the benchmark or the counter does not exist.
  std::optional<Summary> of(std::string const& name, std::string const& counter, std::int64_t threads = 1) const;

 private:
  struct Key {
    std::string name, counter;
    std::int64_t threads;
    auto operator<=>(Key const&) const = default;
  };
  std::map<Key, std::vector<double>> values_;
};

}  // namespace brouwer::benchmarks
