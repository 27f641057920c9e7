// Systems H = ½p² + V(q): derivatives of their potentials, and what Störmer–Verlet conserves of them.
#include <brouwer/systems/double_well.hpp>
#include <brouwer/systems/pendulum.hpp>

#include <gtest/gtest.h>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Judge;

template <template <class> class V_>
struct PotentialFamily {
  using V = V_<Judge>;
  using System = OneDegreeOfFreedom<Judge, V_>;
};
template <class Family>
struct EveryPotential : testing::Test {
  std::vector<Judge> const parameters{Judge("1.3")};  // the pendulum's frequency
};
using Potentials = testing::Types<PotentialFamily<DoubleWellPotential>, PotentialFamily<PendulumPotential>>;
TYPED_TEST_SUITE(EveryPotential, Potentials);

TYPED_TEST(EveryPotential, GivesDerivativesOfOneAnotherAndTheForce) {
  typename TypeParam::V const potential(std::span<Judge const>(this->parameters));
  Judge const h("1e-20");
  for (char const* at : {"-1.7", "-0.2", "0", "1", "2.4"}) {
    Judge const q(at);
    auto const here = potential.derivatives(q), up = potential.derivatives(Judge(q + h)),
               down = potential.derivatives(Judge(q - h));
    for (std::size_t k = 0; k + 1 < here.size(); ++k)
      EXPECT_LT(abs(Judge((up[k] - down[k]) / (2 * h) - here[k + 1])), Judge("1e-37")) << k << " at " << at;
    EXPECT_LT(abs(Judge(potential.force(q) + here[1])), Judge("1e-75")) << at;
  }
}

/// The largest |F − F(0)| of the three energies over a time of 20 of Störmer–Verlet, kick, drift, kick.
template <class System>
std::array<double, 3> deviations(System const& system, Judge const& h) {
  PhaseState<Judge, 1> y{{Judge("1.5")}, {Judge("0.3")}};
  auto const start = system.first_integrals(y, h);
  std::array<double, 3> worst{};
  for (Judge t = 0; t < 20; t += h) {
    y.p[0] += h / 2 * system.force(y.q)[0];
    y.q[0] += h * y.p[0];
    y.p[0] += h / 2 * system.force(y.q)[0];
    auto const now = system.first_integrals(y, h);
    for (std::size_t k = 0; k < 3; ++k)
      worst[k] = std::max(worst[k], static_cast<double>(abs(Judge(now[k] - start[k]))));
  }
  return worst;
}

TYPED_TEST(EveryPotential, ModifiedEnergiesAreConservedByStoermerVerletToTheOrders2And4And6) {
  typename TypeParam::System const system(std::span<Judge const>(this->parameters));
  auto const coarse = deviations(system, Judge("0.02")), fine = deviations(system, Judge("0.01"));
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(std::log2(coarse[k] / fine[k]), 2 * static_cast<double>(k + 1), 0.02) << k;
}

TYPED_TEST(EveryPotential, ModifiedEnergiesAreTheEnergyWhereTheStepIsNone) {
  typename TypeParam::System const system(std::span<Judge const>(this->parameters));
  PhaseState<Judge, 1> const y{{Judge("0.8")}, {Judge("-1.1")}};
  auto const energies = system.first_integrals(y, Judge(0));
  EXPECT_EQ(energies[0], system.energy(y));
  EXPECT_EQ(energies[1], energies[0]);
  EXPECT_EQ(energies[2], energies[0]);
}

TEST(DoubleWell, RestsInItsWellsAndOnItsHill) {
  DoubleWellPotential<double> const potential;
  for (double q : {-1.0, 0.0, 1.0}) EXPECT_EQ(potential.force(q), 0) << q;
  EXPECT_EQ(potential.derivatives(1.0)[2], 8);  // ω² of the wells
  EXPECT_EQ(potential.derivatives(0.0)[0], 1);
}

TEST(DoubleWell, StandardStartGoesOverTheHill) {
  DoubleWell<double> const system(std::span<double const>{});
  EXPECT_EQ(system.energy({{1.5}, {0}}), 1.5625);
}

TEST(Pendulum, ScaleOfItsEnergyIsThatOverTheLowestPoint) {
  Pendulum<Judge> const system(std::span<Judge const>(std::vector<Judge>{Judge(2)}));
  // |H| is 0 for this swing, and says nothing of how large an error is
  PhaseState<Judge, 1> const level{{pi<Judge>() / 2}, {Judge(0)}}, rest{{Judge(0)}, {Judge(0)}};
  EXPECT_LT(abs(Judge(system.energy(level))), Judge("1e-70"));
  EXPECT_LT(abs(Judge(system.first_integral_scales(level)[0] - 4)), Judge("1e-70"));
  EXPECT_EQ(system.first_integral_scales(rest)[2], 1);
}

}  // namespace
}  // namespace brouwer
