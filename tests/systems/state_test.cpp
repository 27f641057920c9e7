// Compensated summation is part of the state: what rounding takes away comes back.
#include <brouwer/systems/rigid_body.hpp>

#include <gtest/gtest.h>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using State7 = RigidBodyState<double>;

State7 filled(double value) { return {{value, value, value}, {value, value, value, value}}; }

TEST(CompensatedState, SumsAMillionTenthsToTheLastBit) {
  Compensated<State7> y(filled(0));
  auto plain = filled(0);
  for (int i = 0; i < 1'000'000; ++i) {
    y.add(filled(0.1));
    plain = sum(plain, filled(0.1));
  }
  // 10⁶ × the double nearest 0.1, to 113 bits
  Float128 const exact = Float128(0.1) * 1'000'000;
  for_components([&](double value, double residue) { EXPECT_LT(abs(Float128(value) + residue - exact), 1e-20); },
                 y.value, y.residue);
  EXPECT_GT(std::abs(plain.momentum[0] - 100000.0), 1e-8) << "without compensation the error is large";
}

TEST(CompensatedState, LosesOnlyRoundingOfTheIncrementsWhereAComponentCrossesZero) {
  Compensated<State7> y(filled(0));
  testing_support::Uniform uniform(1);
  Float128 exact = 0;
  double const size = 1e-3;
  for (int i = 0; i < 10'000; ++i) {
    double const step = uniform(-size, size);
    y.add(filled(step));
    exact += step;
  }
  // each addition may lose half an ulp of an increment, 10⁴ of them in random directions
  double const bound = 3 * 100 * 0.5 * 0x1p-53 * size;
  for_components([&](double value, double residue) { EXPECT_LT(abs(Float128(value) + residue - exact), bound); },
                 y.value, y.residue);
}

TEST(CompensatedState, BeginsWithoutAResidue) {
  Compensated<State7> const y(filled(0.3));
  for_components(
      [](double value, double residue) {
        EXPECT_EQ(value, 0.3);
        EXPECT_EQ(residue, 0);
      },
      y.value, y.residue);
}

TEST(StateComponents, KeepTheOrderOfTheirNames) {
  State7 const y{{1, 2, 3}, {4, 5, 6, 7}};
  std::vector<double> seen;
  for_components([&seen](double c) { seen.push_back(c); }, y);
  EXPECT_EQ(seen, (std::vector<double>{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(State7::from_components(seen).attitude.z(), 7);
  EXPECT_EQ(describe_rigid_body().state_components.size(), seen.size());
}

}  // namespace
}  // namespace brouwer
