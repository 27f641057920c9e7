#pragma once
#include <array>
#include <memory>

#include <brouwer/systems/failure.hpp>
#include <brouwer/systems/state.hpp>

// What the methods have in common that go from a state to the next one by way of others, their stages.
namespace brouwer {

/// A state, or a part of it: an array of numbers. Both hand over their components in the same order. Arrays are unrolled:
/// a sum over stages then stays in registers (six bodies' 18 coordinates in packs: 1.8 times faster).
template <class F, class T, std::size_t n, class... Others>
void for_numbers(F f, std::array<T, n>& a, Others&... others) {
#pragma GCC unroll 32
  for (std::size_t i = 0; i < n; ++i) f(a[i], others[i]...);
}
template <class F, class T, std::size_t n, class... Others>
void for_numbers(F f, std::array<T, n> const& a, Others&... others) {
#pragma GCC unroll 32
  for (std::size_t i = 0; i < n; ++i) f(a[i], others[i]...);
}
template <class F, class S, class... Others>
requires State<std::remove_const_t<S>>
void for_numbers(F f, S& a, Others&... others) { for_components(f, a, others...); }

/// sum + weight · k, number by number: first the product. A weight is one number for all lanes.
template <class T, class Part>
void add_weighted(Part& sum, Element<T> const& weight, Part const& k) {
  T const w(weight);
  for_numbers([&w](T& a, T const& b) { a = a + w * b; }, sum, k);
}
template <class T, class Part>
Part weighted(Element<T> const& weight, Part k) {
  T const w(weight);
  for_numbers([&w](T& a) { a = w * a; }, k);
  return k;
}

/// a + b, number by number.
template <class T, class Part>
Part added(Part a, Part const& b) {
  for_numbers([](T& x, T const& y) { x = x + y; }, a, b);
  return a;
}

/// Up to n stages. Those that are not there yet cost nothing, whatever it costs to make a state of nothing: for packs,
/// zeros written to all of them took longer than a step of RK4.
template <State S, std::size_t n>
class StageList {
 public:
  StageList() {}  // NOLINT: = default is deleted, for the union
  StageList(StageList const&) = delete;
  StageList& operator=(StageList const&) = delete;
  ~StageList() { std::destroy_n(stages_, size_); }

  void push_back(S const& stage) { std::construct_at(stages_ + size_++, stage); }
  S& operator[](std::size_t i) { return stages_[i]; }
  S const& operator[](std::size_t i) const { return stages_[i]; }

 private:
  union {
    S stages_[n];
  };
  std::size_t size_ = 0;
};

template <State S>
bool is_finite(S const& y, int l) {
  bool finite = true;
  for_components(
      [&](auto const& c) {
        auto const v = lane(c, l);
        finite = finite && v - v == decltype(v)(0);
      },
      y);
  return finite;
}

/// What is the matter with a stage: what the system knows of it; if it knows nothing, whether it is finite.
template <class System>
Failure failure_of_stage(System const& system, typename System::State const& stage, int l) {
  if constexpr (KnowsFailures<System, typename System::State>)
    if (auto const known = system.failure(stage, l); known != Failure::none) return known;
  return is_finite(stage, l) ? Failure::none : Failure::diverged;
}

/// Why there is no step from y to y + change, all stages between them being finite: what is the matter with its ends.
template <class System>
Failure failure_of_ends(System const& system, typename System::State const& y, typename System::State const& change,
                        int l) {
  if (!is_finite(y, l)) return Failure::not_finite;
  return failure_of_stage(system, sum(y, change), l);
}

}  // namespace brouwer
