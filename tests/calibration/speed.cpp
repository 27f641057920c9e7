#include "tests/calibration/speed.hpp"

#include <fmt/format.h>
#include <omp.h>
#include <sys/resource.h>

#include <array>
#include <chrono>

#include "tests/benchmarks/text_table.hpp"
#include "tests/calibration/model.hpp"

namespace brouwer::calibration {
namespace {

constexpr Design large = {100'000, 200, Spacing::logarithmic, 1};
constexpr double goal = 30;  // seconds, for all ten
constexpr std::array<char const*, 10> quantities = {"walk",    "drift", "slopes", "noise",     "all",
                                                    "bounded", "t(5)",  "wild",   "transient", "oscillation"};

double seconds_of(Ensemble const& ensemble, Estimates& estimates) {
  auto const begin = std::chrono::steady_clock::now();
  estimates = estimate(ensemble, {});
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The most memory that this process has held, in GB.
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024 / 1e9;
}

}  // namespace

std::string speed_table() {
  benchmarks::TextTable table({"quantity", "seconds", "verdict"});
  double total = 0, data = 0;
  for (auto const* name : quantities) {
    auto const ensemble = ensemble_of(model(name), large, 0);
    data = static_cast<double>(ensemble.errors.size()) * sizeof(double) / 1e9;
    Estimates estimates;
    double const seconds = seconds_of(ensemble, estimates);
    total += seconds;
    table.add({name, fmt::format("{:.2f}", seconds), to_string(estimates.verdict)});
  }
  table.add({"all ten", fmt::format("{:.1f}", total), total < goal ? "goal 30: reached" : "goal 30: missed"});
  return fmt::format("{} processors; at most {:.2f} GB of memory, of which an ensemble is {:.2f} GB.\n\n{}",
                     omp_get_num_procs(), peak_memory(), data, table.text());
}

}  // namespace brouwer::calibration
