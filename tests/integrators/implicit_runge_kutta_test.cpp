// The iteration of implicit Runge–Kutta methods, and the statistics of their round-off.
#include <brouwer/integrators/implicit_runge_kutta.hpp>
#include <brouwer/scalar/pack.hpp>

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include "tests/contracts/field_systems.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Growth;
using testing_support::Uniform;

// --- turns ------------------------------------------------------------------------------------------------------------

/// Turns of the implicit midpoint rule for q̇ = λq from q = 1.
template <class T>
T turns_of_midpoint_rule(double h_lambda, CoefficientForm form) {
  std::array const lambda{T(1)};
  typename Growth<T>::State const y{{T(1)}, {T(0)}};
  ImplicitRungeKutta<Growth<T>> const step({Growth<T>(std::span<T const>(lambda)), T(h_lambda), y},
                                           implicit_methods()[1], form);
  T turns(0);
  step.increment(y, turns);
  return turns;
}

/// With hλ = 2⁻⁹ a turn brings k nearer by hλ/2 = 2⁻¹⁰, and all of it is exact: the stage 1 + k/2 begins at 1 + 2⁻¹⁰ and
/// turn n adds 2⁻¹⁰⁽ⁿ⁺¹⁾, to k 2⁻⁹⁻¹⁰ⁿ, for as long as the stage has the bits; the next turn moves nothing.
TEST(ImplicitRungeKutta, MakesAsManyTurnsAsTheContractionAsksFor) {
  auto const expect = [](auto zero, int to_tolerance, int to_rest) {
    using T = decltype(zero);
    EXPECT_EQ(turns_of_midpoint_rule<T>(0x1p-9, CoefficientForm::standard), to_tolerance);
    EXPECT_EQ(turns_of_midpoint_rule<T>(0x1p-9, CoefficientForm::split), to_rest);
    EXPECT_EQ(turns_of_midpoint_rule<T>(0x1p-9, CoefficientForm::symplectic), to_rest);
  };
  expect(0.0F, 2, 3);  // moves 2⁻¹⁹, 2⁻²⁹ ≤ u = 2⁻²⁴, none: 1 + 2⁻¹⁰ + 2⁻²⁰ has no room for 2⁻³⁰
  expect(0.0, 5, 6);   // 2⁻¹⁹ … 2⁻⁵⁹ ≤ u = 2⁻⁵³, none
  expect(0.0L, 6, 7);  // 2⁻¹⁹ … 2⁻⁶⁹ ≤ u = 2⁻⁶⁴, none
}

TEST(ImplicitRungeKutta, CountsTheTurnsOfEachLane) {
  using P = Pack<double, 4>;
  std::array const lambda{P(1)};
  Growth<P>::State const y{{P(1)}, {P(0)}};
  P const h = from_lanes<P>([](int l) { return std::ldexp(1.0, -5 * (l + 1)); });
  ImplicitRungeKutta<Growth<P>> const step({Growth<P>(std::span<P const>(lambda)), h, y}, implicit_methods()[1],
                                           CoefficientForm::symplectic);
  P turns(100);
  step.increment(y, turns);
  for (int l = 0; l < 4; ++l)
    EXPECT_EQ(turns[l], 100 + turns_of_midpoint_rule<double>(h[l], CoefficientForm::symplectic)) << l;
}

/// The same field, its separability hidden.
struct AsOne : HenonHeiles<double> {
  template <class U>
  using In = HenonHeiles<U>;
  using HenonHeiles<double>::HenonHeiles;

  template <std::same_as<double>>
  AsOne in() const {
    return *this;
  }

 private:
  using HenonHeiles<double>::velocity;
  using HenonHeiles<double>::force;
};

TEST(ImplicitRungeKutta, NeedsHalfTheTurnsWhereTheSystemIsSeparable) {
  PhaseState<double, 2> const start{{0.125, 0.25}, {0.375, 0.125}};
  auto const turns = [&]<class System>(System const& system) {
    ImplicitRungeKutta<System> const step({system, 0.1, start}, implicit_methods()[4], CoefficientForm::symplectic);
    auto y = start;
    double sum = 0;
    advance(step, y, 100, sum);
    return sum / 100;
  };
  double const separable = turns(HenonHeiles<double>()), whole = turns(AsOne());
  EXPECT_LT(separable, 7.5);
  EXPECT_GT(whole, 1.4 * separable);
}

TEST(ImplicitRungeKutta, GivesUpAtItsLimit) {
  using System = testing_support::Bounded<double>;
  System::State const y{{0.7}, {0.2}};
  ImplicitRungeKutta<System> const step({System(), 40, y}, implicit_methods()[2], CoefficientForm::split);
  double turns = 0;
  EXPECT_FALSE(is_finite(step.increment(y, turns), 0));
  EXPECT_EQ(turns, (ImplicitRungeKutta<System>::limit));
}

TEST(ImplicitRungeKutta, StaysAtRest) {
  using System = HenonHeiles<double>;
  System::State const y{{0, 0}, {0, 0}};
  for (auto form : coefficient_forms) {
    double turns = 0;
    auto const change = ImplicitRungeKutta<System>({System(), 0.1, y}, implicit_methods()[8], form).increment(y, turns);
    for_components([](double c) { EXPECT_EQ(c, 0); }, change);
    EXPECT_EQ(turns, 1);
  }
}

// --- statistics of round-off ------------------------------------------------------------------------------------------

constexpr int in_pack = 8, members = 64;
using P = Pack<double, in_pack>;
using Star = HenonHeiles<P>;

/// About the standard start.
Star::State next_start(Uniform& uniform) {
  auto const about = [&](double a) { return from_lanes<P>([&](int) { return a + uniform(-0.01, 0.01); }); };
  return {{about(0), about(0.25)}, {about(0.375), about(0.125)}};
}

/// H in lane l of the state that is meant.
Float128 energy(Compensated<Star::State> const& y, int l) {
  PhaseState<Float128, 2> meant;
  for_components([l](Float128& a, P const& v, P const& r) { a = Float128(v[l]) + Float128(r[l]); }, meant, y.value,
                 y.residue);
  return HenonHeiles<Float128>().energy(meant);
}

/// Mean and t of the relative energy errors after so many steps, a step.
struct Drift {
  double mean, t;
};

Drift drift(ImplicitMethod const& method, CoefficientForm form, double h, std::int64_t steps) {
  Uniform uniform(5);
  std::vector<double> slopes;
  for (int first = 0; first < members; first += in_pack) {
    Compensated<Star::State> y(next_start(uniform));
    auto const start = y;
    advance(ImplicitRungeKutta<Star>({Star(), P(h), y.value}, method, form), y, steps);
    for (int l = 0; l < in_pack; ++l) {
      auto const before = energy(start, l);
      slopes.push_back(static_cast<double>(Float128((energy(y, l) - before) / before)) / static_cast<double>(steps));
    }
  }
  double mean = 0, variance = 0;
  for (double s : slopes) mean += s / members;
  for (double s : slopes) variance += squared(s - mean) / (members - 1);
  return {mean, mean / std::sqrt(variance / members)};
}

/// Hénon–Heiles with compensation; what is seen of the standard form's drift has been measured with 1024
/// members: (3.9 ± 0.1)·10⁻¹⁹ a step with eight stages at h = 0.3, (−1.09 ± 0.02)·10⁻¹⁹ with four at h = 0.05. Of the
/// others none was seen, below 10⁻²⁰ and 2·10⁻²¹.
TEST(ImplicitRungeKuttaStatistics, EnergyDriftsWithRoundedCoefficientsAndNotWithTheOtherForms) {
  auto const& eight_stages = implicit_methods()[8];
  auto const rounded_ones = drift(eight_stages, CoefficientForm::standard, 0.3, 8'000);
  EXPECT_GT(rounded_ones.t, 6);
  EXPECT_NEAR(rounded_ones.mean, 3.9e-19, 1.2e-19);
  for (auto form : {CoefficientForm::split, CoefficientForm::symplectic}) {
    auto const d = drift(eight_stages, form, 0.3, 8'000);
    EXPECT_GT(2 * gsl_cdf_tdist_Q(std::abs(d.t), members - 1), 1e-3) << name_of(form) << ": drift " << d.mean;
  }
}

TEST(ImplicitRungeKuttaStatistics, TheDriftIsThatOfTheCoefficients) {  // another method, another sign
  auto const d = drift(implicit_methods()[4], CoefficientForm::standard, 0.05, 8'000);
  EXPECT_LT(d.t, -10);
  EXPECT_NEAR(d.mean, -1.09e-19, 0.2e-19);
  EXPECT_LT(std::abs(drift(implicit_methods()[4], CoefficientForm::symplectic, 0.05, 8'000).t), 3.4);
}

}  // namespace
}  // namespace brouwer
