// What a step costs, and what the abstractions cost over a loop written by hand. Not a test: these machines are noisy;
// read ratios within one run:  build/release/benchmarks --benchmark_repetitions=5
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>

#include <brouwer/ensemble/start.hpp>
#include <brouwer/integrators/dmv.hpp>
#include <brouwer/integrators/elliptic_branch_free.hpp>
#include <brouwer/integrators/elliptic_naive.hpp>
#include <brouwer/integrators/elliptic_three_constants.hpp>

namespace {

using namespace brouwer;

constexpr double h = 0.01;
constexpr std::int64_t steps = 10'000;

RigidBody<double> standard_body() { return RigidBody<double>(Vector3<double>{0.6, 0.8, 1.0}); }
RigidBodyState<double> standard_start() { return {{1.8, 0.4, -0.9}, {1, 0, 0, 0}}; }

void report(benchmark::State& state) {
  state.counters["ns/step"] = benchmark::Counter(static_cast<double>(state.iterations() * steps) * 1e-9,
                                                 benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// The arithmetic of Dmv2, operation by operation, as one would write it for this body and this scalar alone.
void dmv_by_hand(benchmark::State& state) {
  double const I[3] = {0.6, 0.8, 1.0};
  double const eta[3] = {h / (2 * I[0]), h / (2 * I[1]), h / (2 * I[2])};
  double const kappa[3] = {(I[1] - I[2]) / I[0], (I[2] - I[0]) / I[1], (I[0] - I[1]) / I[2]};
  for (auto _ : state) {
    double y[3] = {1.8, 0.4, -0.9}, q[4] = {1, 0, 0, 0};
    for (std::int64_t n = 0; n < steps; ++n) {
      double const p[3] = {eta[0] * y[0], eta[1] * y[1], eta[2] * y[2]};
      double c[3] = {p[0], p[1], p[2]}, change = INFINITY;
      for (int i = 0; i < 474; ++i) {
        double const a = 1 + (c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
        double const c1 = a * p[0] + kappa[0] * c[1] * c[2];
        double const c2 = a * p[1] + kappa[1] * c[2] * c1;
        double const c3 = a * p[2] + kappa[2] * c1 * c2;
        double const moved = std::fmax(std::fmax(std::fabs(c1 - c[0]), std::fabs(c2 - c[1])), std::fabs(c3 - c[2]));
        double const size = std::fmax(std::fmax(std::fabs(c1), std::fabs(c2)), std::fabs(c3));
        c[0] = c1, c[1] = c2, c[2] = c3;
        if (!(moved > 0) || !(moved < change || moved > 16 * 0x1p-52 * size)) break;
        change = moved;
      }
      double const c2 = c[0] * c[0] + c[1] * c[1] + c[2] * c[2], a = 1 + c2, root = std::sqrt(a);
      y[0] += 2 * (kappa[0] * (c[1] * c[2])) / (a * eta[0]);
      y[1] += 2 * (kappa[1] * (c[2] * c[0])) / (a * eta[1]);
      y[2] += 2 * (kappa[2] * (c[0] * c[1])) / (a * eta[2]);
      double const r[4] = {-c2 / (1 + root) / root, c[0] / root, c[1] / root, c[2] / root};
      double const d[4] = {
          q[0] * r[0] - q[1] * r[1] - q[2] * r[2] - q[3] * r[3], q[0] * r[1] + q[1] * r[0] + q[2] * r[3] - q[3] * r[2],
          q[0] * r[2] + q[2] * r[0] + q[3] * r[1] - q[1] * r[3], q[0] * r[3] + q[3] * r[0] + q[1] * r[2] - q[2] * r[1]};
      for (int j = 0; j < 4; ++j) q[j] += d[j];
    }
    benchmark::DoNotOptimize(y);
    benchmark::DoNotOptimize(q);
  }
  report(state);
}
BENCHMARK(dmv_by_hand);

template <class S, bool attitude>
void stepper(benchmark::State& state) {
  S const step({standard_body(), h, standard_start(), attitude});
  for (auto _ : state) {
    auto y = standard_start();
    advance(step, y, steps);
    benchmark::DoNotOptimize(y);
  }
  report(state);
}
BENCHMARK(stepper<Dmv2<double>, true>)->Name("dmv-2");
BENCHMARK(stepper<EllipticNaive<double>, false>)->Name("elliptic-naive, momentum");
BENCHMARK(stepper<EllipticThreeConstants<double>, false>)->Name("elliptic-three-constants, momentum");
BENCHMARK(stepper<EllipticAddition<double>, false>)->Name("elliptic-addition, momentum");
BENCHMARK(stepper<EllipticBranchFree<double>, false>)->Name("elliptic-branch-free, momentum");
BENCHMARK(stepper<EllipticIncrement<double>, false>)->Name("elliptic-increment, momentum");
BENCHMARK(stepper<EllipticIncrement<double>, true>)->Name("elliptic-increment, momentum and attitude");

void compensated(benchmark::State& state) {
  Dmv2<double> const step({standard_body(), h, standard_start()});
  for (auto _ : state) {
    Compensated<RigidBodyState<double>> y(standard_start());
    advance(step, y, steps);
    benchmark::DoNotOptimize(y);
  }
  report(state);
}
BENCHMARK(compensated)->Name("dmv-2, compensated");

/// Through the catalogue's names and the virtual call, as `brouwer run` does it.
void by_name(benchmark::State& state) {
  auto const catalogue = builtin_catalogue();
  CellLabels const cell{"rigid_body", "dmv-2", "double", "-", "-", false, h, steps};
  Start const start{{0.6, 0.8, 1.0}, {1.8, 0.4, -0.9, 1, 0, 0, 0}};
  for (auto _ : state) {
    auto const trajectory = begin_trajectory(catalogue, cell, start, true);
    trajectory->advance(steps);
    benchmark::DoNotOptimize(trajectory.get());
  }
  report(state);
}
BENCHMARK(by_name)->Name("dmv-2, by name");

}  // namespace

BENCHMARK_MAIN();
