// The double pendulum against mechanics in Cartesian coordinates, and against the known frequencies of small oscillations.
#include <brouwer/systems/double_pendulum.hpp>

#include <gtest/gtest.h>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Judge;

DoublePendulumParameters<Judge> const uneven{{Judge("0.7"), Judge("1.9")}, {Judge("1.3"), Judge("0.4")}, Judge("9.81")};
PhaseState<Judge, 2> const swinging{{Judge("0.8"), Judge("-2.1")}, {Judge("1.7"), Judge("-0.6")}};

TEST(DoublePendulum, MomentaAndEnergyAreThoseOfTheMassPoints) {
  DoublePendulum<Judge> const system(uneven);
  auto const& [length, mass, gravity] = uneven;
  auto const& [q, p] = swinging;
  auto const w = system.rate(swinging).q;
  // velocities in the plane, x to the right and y upwards, and their derivatives by q̇₁ and q̇₂
  std::array<Judge, 2> const along1{length[0] * cos(q[0]), length[0] * sin(q[0])},
      along2{length[1] * cos(q[1]), length[1] * sin(q[1])};
  std::array<Judge, 2> const v1{along1[0] * w[0], along1[1] * w[0]},
      v2{v1[0] + along2[0] * w[1], v1[1] + along2[1] * w[1]};
  Judge const p1 = mass[0] * inner_product(v1, along1) + mass[1] * inner_product(v2, along1),
              p2 = mass[1] * inner_product(v2, along2);
  EXPECT_LT(abs(Judge(p1 - p[0])), Judge("1e-75"));
  EXPECT_LT(abs(Judge(p2 - p[1])), Judge("1e-75"));

  Judge const height1 = -length[0] * cos(q[0]), height2 = height1 - length[1] * cos(q[1]);
  Judge const energy = (mass[0] * inner_product(v1, v1) + mass[1] * inner_product(v2, v2)) / 2 +
                       gravity * (mass[0] * height1 + mass[1] * height2);
  EXPECT_LT(abs(Judge(system.energy(swinging) - energy)), Judge("1e-74"));
}

TEST(DoublePendulum, SwingsNearRestWithTheFrequenciesOfItsModes) {
  // equal rods and masses: ω² = (2 ∓ √2) g/l, and the lower point swings ±√2 as far
  DoublePendulum<Judge> const system({{Judge(1), Judge(1)}, {Judge(1), Judge(1)}, Judge(1)});
  Judge const e("1e-20");
  for (int side : {1, -1}) {
    Judge const ratio = side * sqrt(Judge(2)), frequency2 = 2 - ratio;
    // momenta of the velocities (1, ratio) at rest: p = M q̇, M = (2 1; 1 1)
    auto const velocity = system.rate({{Judge(0), Judge(0)}, {e * (2 + ratio), e * (1 + ratio)}}).q;
    EXPECT_LT(abs(Judge(velocity[0] / e - 1)), Judge("1e-38"));
    EXPECT_LT(abs(Judge(velocity[1] / e - ratio)), Judge("1e-38"));
    auto const force = system.rate({{e, e * ratio}, {Judge(0), Judge(0)}}).p;
    EXPECT_LT(abs(Judge(force[0] / e + frequency2 * (2 + ratio))), Judge("1e-38"));
    EXPECT_LT(abs(Judge(force[1] / e + frequency2 * (1 + ratio))), Judge("1e-38"));
  }
}

TEST(DoublePendulum, ScaleOfItsEnergyIsThatOverRest) {
  DoublePendulum<double> const system({{1, 1}, {1, 1}, 1});
  EXPECT_NEAR(system.first_integral_scales({{0.75, 0.5}, {0, 0}})[0], 2 * (1 - std::cos(0.75)) + 1 - std::cos(0.5),
              1e-15);
  EXPECT_EQ(system.first_integral_scales({{0, 0}, {0, 0}})[0], 1);
}

}  // namespace
}  // namespace brouwer
