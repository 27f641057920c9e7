#include "tests/benchmarks/results.hpp"

#include <algorithm>
#include <cmath>

namespace brouwer::benchmarks {
namespace {

/// Linear between the values around it.
double quantile(std::vector<double> const& sorted, double fraction) {
  double const place = fraction * static_cast<double>(sorted.size() - 1), below = std::floor(place);
  auto const index = static_cast<std::size_t>(below);
  double const next = sorted[std::min(index + 1, sorted.size() - 1)];
  return sorted[index] + (place - below) * (next - sorted[index]);
}

}  // namespace

void Results::add(benchmark::BenchmarkReporter::Run const& run) {
  if (run.run_type != benchmark::BenchmarkReporter::Run::RT_Iteration || run.error_occurred) return;
  for (auto const& [counter, value] : run.counters)
    values_[{run.run_name.function_name, counter, run.threads}].push_back(value.value);
}

std::optional<Summary> Results::of(std::string const& name, std::string const& counter, std::int64_t threads) const {
  auto const found = values_.find({name, counter, threads});
  if (found == values_.end()) return std::nullopt;
  auto sorted = found->second;
  std::sort(sorted.begin(), sorted.end());
  double const median = quantile(sorted, 0.5);
  return Summary{median, (quantile(sorted, 0.75) - quantile(sorted, 0.25)) / (2 * median)};
}

}  // namespace brouwer::benchmarks
