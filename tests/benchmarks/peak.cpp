#include "tests/benchmarks/peak.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace brouwer::benchmarks {
namespace {

using Loop = void (*)(std::int64_t);

/// The loops of one instruction set and one type.
struct Loops {
  std::array<Loop, std::size(all_mixes)> by_mix;
  double numbers;  ///< in a register
};

constexpr std::size_t chains = 12;  // with three constants they fill the 16 registers of SSE2 and AVX2

// A turn does `statement` to each of the chains v, which start apart so that no two of them are one to the compiler, and
// stay near 1. A macro, because a function's target cannot be a template's parameter.
#define BROUWER_LOOP(name, target_options, V, E, statement)                                 \
  __attribute__((target(target_options))) void name(std::int64_t turns) {                   \
    [[maybe_unused]] V const a = V{} + E(1.0625), b = V{} + E(0.9375), c = V{} + E(0.0625); \
    V x[chains];                                                                            \
    for (std::size_t i = 0; i < chains; ++i) x[i] = V{} + (E(1) + E(i) / E(32));            \
    for (std::int64_t turn = 0; turn < turns; ++turn) {                                     \
      _Pragma("GCC unroll 12") for (V & v : x) { statement; }                               \
    }                                                                                       \
    V sum{};                                                                                \
    for (V const& v : x) sum = sum + v;                                                     \
    asm volatile("" : : "m"(sum));                                                          \
  }
#define BROUWER_LOOPS(suffix, target_options, V, E, root)                                           \
  BROUWER_LOOP(multiply_and_add_##suffix, target_options, V, E, v = v * b + c)                      \
  BROUWER_LOOP(add_##suffix, target_options, V, E, v = (v + a) - b)                                 \
  BROUWER_LOOP(multiply_##suffix, target_options, V, E, v = (v * a) * b)                            \
  BROUWER_LOOP(divide_##suffix, target_options, V, E, v = a / v)                                    \
  BROUWER_LOOP(root_##suffix, target_options, V, E, v = root(v + a))                                \
  constexpr Loops loops_##suffix{                                                                   \
      {multiply_and_add_##suffix, add_##suffix, multiply_##suffix, divide_##suffix, root_##suffix}, \
      double(sizeof(V) / sizeof(E))};

BROUWER_LOOPS(double_none, "default", double, double, std::sqrt)
BROUWER_LOOPS(float_none, "default", float, float, std::sqrt)

#if defined(__x86_64__)
typedef double Double2 __attribute__((vector_size(16)));
typedef double Double4 __attribute__((vector_size(32)));
typedef double Double8 __attribute__((vector_size(64)));
typedef float Float4 __attribute__((vector_size(16)));
typedef float Float8 __attribute__((vector_size(32)));
typedef float Float16 __attribute__((vector_size(64)));
#define BROUWER_ROOT_AVX512D(v) Double8(_mm512_maskz_sqrt_pd(0xff, v))
#define BROUWER_ROOT_AVX512F(v) Float16(_mm512_maskz_sqrt_ps(0xffff, v))
BROUWER_LOOPS(double_sse2, "sse2", Double2, double, _mm_sqrt_pd)
BROUWER_LOOPS(float_sse2, "sse2", Float4, float, _mm_sqrt_ps)
BROUWER_LOOPS(double_avx2, "avx2", Double4, double, _mm256_sqrt_pd)
BROUWER_LOOPS(float_avx2, "avx2", Float8, float, _mm256_sqrt_ps)
BROUWER_LOOPS(double_avx512, "avx512f", Double8, double, BROUWER_ROOT_AVX512D)
BROUWER_LOOPS(float_avx512, "avx512f", Float16, float, BROUWER_ROOT_AVX512F)
constexpr std::array<Loops, 4> loops_double = {loops_double_none, loops_double_sse2, loops_double_avx2,
                                               loops_double_avx512};
constexpr std::array<Loops, 4> loops_float = {loops_float_none, loops_float_sse2, loops_float_avx2, loops_float_avx512};
#else
constexpr std::array<Loops, 1> loops_double = {loops_double_none};
constexpr std::array<Loops, 1> loops_float = {loops_float_none};
#endif

double operations_of(Mix mix) {
  bool const two = mix == Mix::multiply_and_add || mix == Mix::add || mix == Mix::multiply;
  return (two ? 2 : 1) * static_cast<double>(chains);
}

}  // namespace

std::string const& name_of(Mix mix) {
  static std::array<std::string, std::size(all_mixes)> const names = {"multiply-and-add", "add", "multiply", "divide",
                                                                      "root"};
  return names.at(static_cast<std::size_t>(mix));
}

PeakLoop::PeakLoop(Mix mix, InstructionSet set, std::string const& arithmetic) {
  auto const& loops = (arithmetic == "float" ? loops_float : loops_double).at(static_cast<std::size_t>(set));
  loop_ = loops.by_mix.at(static_cast<std::size_t>(mix));
  operations_ = operations_of(mix) * loops.numbers;
}

double PeakLoop::rate() const {
  using Clock = std::chrono::steady_clock;
  constexpr std::int64_t turns = 1000;
  constexpr int runs = 8;
  double best = 0;
  for (int i = 0; i < runs; ++i) {
    auto const begin = Clock::now();
    run(turns);
    std::chrono::duration<double, std::nano> const time = Clock::now() - begin;
    best = std::max(best, static_cast<double>(turns) * operations_ / time.count());
  }
  return best;
}

Peak::Peak(InstructionSet set, std::string const& arithmetic)
    : multiply_and_add(PeakLoop(Mix::multiply_and_add, set, arithmetic).rate()),
      add(PeakLoop(Mix::add, set, arithmetic).rate()),
      multiply(PeakLoop(Mix::multiply, set, arithmetic).rate()),
      divide(PeakLoop(Mix::divide, set, arithmetic).rate()),
      root(PeakLoop(Mix::root, set, arithmetic).rate()) {}

}  // namespace brouwer::benchmarks
