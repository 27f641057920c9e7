// Promises that every method for any system keeps.
#include <brouwer/scalar/double_double.hpp>

#include <gtest/gtest.h>

#include "tests/contracts/field_methods.hpp"
#include "tests/contracts/field_systems.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Bounded;
using testing_support::Fall;
using testing_support::field_methods;
using testing_support::FieldMethod;
using testing_support::Geodesics;
using testing_support::identifier;
using testing_support::Judge;
using testing_support::methods_of_any_field;
using testing_support::with_step;

template <class T>
HenonHeiles<T> star() {
  return HenonHeiles<T>();
}
template <class T>
PhaseState<T, 2> star_start() {
  return {{T(1) / T(8), T(1) / T(4)}, {T(3) / T(8), T(1) / T(8)}};
}
template <class T>
Geodesics<T> geodesics() {
  std::array const curvature{T(1) / T(2)};
  return Geodesics<T>(std::span<T const>(curvature));
}

template <class System>
typename System::State advanced(FieldMethod const& method, System const& system, typename System::State y,
                                typename System::Scalar const& h, int steps) {
  with_step<System>(method, {system, h, y}, [&](auto const& step) { advance(step, y, steps); });
  return y;
}

template <class State>
double distance(State const& a, State const& b) {
  Judge worst = 0;
  for_components([&](Judge const& x, Judge const& y) { worst = larger(worst, Judge(abs(Judge(x - y)))); }, a, b);
  return static_cast<double>(worst);
}

struct AFieldMethod : testing::TestWithParam<FieldMethod> {
  static bool needs_separable() { return GetParam().for_separable_only(); }
};
INSTANTIATE_TEST_SUITE_P(Of, AFieldMethod, testing::ValuesIn(field_methods()),
                         [](auto const& one) { return identifier(one.param.name); });

// --- order ------------------------------------------------------------------------------------------------------------

/// The state at the time 1, by steps of a high order: right to 50 digits.
template <class System>
typename System::State at_time_one(System const& system) {
  auto const methods = field_methods();
  return advanced(methods.back(), system, star_start<Judge>(), Judge(1) / 96, 96);
}

/// log₂ of the ratio of errors at the time 1, where the step is halved.
template <class System>
double measured_order(FieldMethod const& method, System const& system) {
  static auto const exact = at_time_one(system);
  int const steps = method.order <= 2 ? 128 : method.order <= 10 ? 32 : 24;
  auto const error = [&](int n) {
    return distance(advanced(method, system, star_start<Judge>(), Judge(1) / n, n), exact);
  };
  return std::log2(error(steps) / error(2 * steps));
}

TEST_P(AFieldMethod, ConvergesAtItsStatedOrder) {
  EXPECT_NEAR(measured_order(GetParam(), star<Judge>()), GetParam().order, 0.1);
  if (!needs_separable()) {
    EXPECT_NEAR(measured_order(GetParam(), geodesics<Judge>()), GetParam().order, 0.1);
  }
}

// --- geometry ---------------------------------------------------------------------------------------------------------

template <class System>
double distance_after_a_walk_there_and_back(FieldMethod const& method, System const& system) {
  auto const start = star_start<Judge>(), there = advanced(method, system, start, Judge("0.1"), 5);
  return distance(advanced(method, system, there, Judge("-0.1"), 5), start);
}

TEST_P(AFieldMethod, RetracesItsStepsWhenTimeIsReversedIfItIsSymmetric) {
  auto const check = [](double back) {
    if (GetParam().symmetric) {
      EXPECT_LT(back, 1e-74);
    } else {
      EXPECT_GT(back, 1e-20);
    }
  };
  check(distance_after_a_walk_there_and_back(GetParam(), star<Judge>()));
  if (!needs_separable()) check(distance_after_a_walk_there_and_back(GetParam(), geodesics<Judge>()));
}

/// The largest entry of JᵀΩJ − Ω, J the Jacobian of one step by central differences, right to 45 digits.
template <class System>
double symplectic_defect(FieldMethod const& method, System const& system) {
  using State = PhaseState<Judge, 2>;
  Judge const delta("1e-24");
  std::vector<State> columns;
  for (std::size_t c = 0; c < 4; ++c) {
    auto const moved = [&](Judge const& by) {
      State y = star_start<Judge>();
      Judge& component = c < 2 ? y.q[c] : y.p[c - 2];
      component += by;
      return advanced(method, system, y, Judge("0.25"), 1);
    };
    State column = moved(delta);
    State const other = moved(-delta);
    for_components([&](Judge& a, Judge const& b) { a = (a - b) / (2 * delta); }, column, other);
    columns.push_back(column);
  }
  Judge worst = 0;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < 4; ++b) {
      Judge form = b == a + 2 ? -1 : a == b + 2 ? 1 : 0;
      for (std::size_t i = 0; i < 2; ++i) form += columns[a].q[i] * columns[b].p[i] - columns[a].p[i] * columns[b].q[i];
      worst = larger(worst, Judge(abs(form)));
    }
  return static_cast<double>(worst);
}

TEST_P(AFieldMethod, IsSymplecticIfItSaysSoAndNotElse) {
  auto const check = [](double defect) {
    if (GetParam().symplectic) {
      EXPECT_LT(defect, 1e-44);
    } else {
      EXPECT_GT(defect, 1e-20);
    }
  };
  check(symplectic_defect(GetParam(), star<Judge>()));
  if (!needs_separable()) check(symplectic_defect(GetParam(), geodesics<Judge>()));
}

TEST_P(AFieldMethod, ConservesQuadraticFirstIntegralsIfItIsSymplectic) {
  if (needs_separable()) return;
  auto const turn = [](PhaseState<Judge, 2> const& y) { return Judge(y.q[0] * y.p[1] - y.q[1] * y.p[0]); };
  auto const start = star_start<Judge>(), end = advanced(GetParam(), geodesics<Judge>(), start, Judge("0.25"), 10);
  double const error = static_cast<double>(abs(Judge(turn(end) - turn(start))));
  if (GetParam().symplectic) {
    EXPECT_LT(error, 1e-75);
  } else {
    EXPECT_GT(error, 1e-20);
  }
}

// --- arithmetic -------------------------------------------------------------------------------------------------------

constexpr int few_steps = 20;

/// What they cost in rounding, in ε(T), plainly and with compensation. (Start and step are exact in every arithmetic.)
template <class T>
std::array<double, 2> rounding_errors(FieldMethod const& method, PhaseState<Judge, 2> const& exact) {
  using State = PhaseState<T, 2>;
  State plain = star_start<T>();
  Compensated<State> compensated(plain);
  with_step<HenonHeiles<T>>(method, {star<T>(), T(1) / T(16), plain}, [&](auto const& step) {
    advance(step, plain, few_steps);
    advance(step, compensated, few_steps);
  });
  PhaseState<Judge, 2> a, b;
  for_components([](Judge& w, T const& v) { w = Judge(v); }, a, plain);
  for_components([](Judge& w, T const& v, T const& r) { w = Judge(v) + Judge(r); }, b, compensated.value,
                 compensated.residue);
  double const ulp = static_cast<double>(epsilon<T>());
  return {distance(a, exact) / ulp, distance(b, exact) / ulp};
}

TEST_P(AFieldMethod, RoundsLittleInEveryArithmeticAndLessWithCompensation) {
  auto const exact = advanced(GetParam(), star<Judge>(), star_start<Judge>(), Judge(1) / 16, few_steps);
  auto const check = [&](auto zero, double most, double most_compensated) {
    auto const [plain, compensated] = rounding_errors<decltype(zero)>(GetParam(), exact);
    EXPECT_LT(plain, most);
    EXPECT_LT(compensated, most_compensated);
  };
  check(0.0F, 1.2, 0.6);
  check(0.0, 1.2, 0.6);
  check(0.0L, 1.2, 0.6);
  check(Float128(0), 1.2, 0.6);
  check(DoubleDouble<double>(0), 1.2, 0.6);
}

TEST_P(AFieldMethod, IsAValue) {
  using System = HenonHeiles<double>;
  auto a = star_start<double>(), b = a;
  with_step<System>(GetParam(), {star<double>(), 0.1, a}, [&](auto const& original) {
    auto const copy = original;
    advance(original, a, 50);
    advance(original, b, 20);
    advance(copy, b, 30);
  });
  EXPECT_EQ(a.q, b.q);
  EXPECT_EQ(a.p, b.p);
}

// --- failures ---------------------------------------------------------------------------------------------------------

template <class System>
Failure failure_of_a_step(System const& system, double h, typename System::State const& y) {
  Failure reason = Failure::none;
  with_step<System>(AFieldMethod::GetParam(), {system, h, y}, [&](auto const& step) {
    auto next = y;
    take_step(step, next);
    reason = step.failure(y, 0);
    EXPECT_EQ(reason == Failure::none, is_finite(next, 0))
        << "a reason is given where there is no step, and only there";
  });
  return reason;
}

TEST_P(AFieldMethod, SaysWhyThereIsNoStep) {
  double const infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(failure_of_a_step(star<double>(), 0.1, star_start<double>()), Failure::none);
  EXPECT_EQ(failure_of_a_step(star<double>(), 0.1, {{0, infinity}, {0, 0}}), Failure::not_finite);
  EXPECT_EQ(failure_of_a_step(star<double>(), 10.0, {{1e200, 1e200}, {-1e200, 1e200}}), Failure::diverged);
}

/// Beyond the centre is no force, in a stage or at the end: then the next step has none.
TEST_P(AFieldMethod, AsksTheSystemWhyThereIsNoStep) {
  using System = Fall<double>;
  with_step<System>(GetParam(), {System(), 0.125, {{0.25}, {-1}}}, [](auto const& step) {
    typename System::State y{{0.25}, {-1}}, last = y;
    for (int i = 0; i < 20 && is_finite(y, 0); ++i) {
      last = y;
      take_step(step, y);
    }
    EXPECT_FALSE(is_finite(y, 0));
    EXPECT_EQ(step.failure(last, 0), Failure::collision);
  });
}

TEST_P(AFieldMethod, SaysWhetherItsIterationCameToNoEnd) {
  auto const reason = failure_of_a_step(Bounded<double>(), 40.0, {{0.7}, {0.2}});
  EXPECT_EQ(reason, GetParam().iterates() ? Failure::no_convergence : Failure::none);
}

}  // namespace
}  // namespace brouwer
