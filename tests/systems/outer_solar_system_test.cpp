// The outer solar system: its numbers, its frame, its forces, encounters.
#include <brouwer/systems/outer_solar_system.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/contracts/systems.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;
using testing_support::components_of;
using testing_support::Judge;
using testing_support::standard_values;
using testing_support::SystemCase;
using Case = SystemCase<OuterSolarSystem<Judge>>;

SystemDescription const description = describe_outer_solar_system();

/// The standard start, in the frame of the barycentre or as it is given.
FieldValues values_of(bool recentred) {
  auto values = standard_values(description);
  values.at("recentre")[0] = recentred ? 1 : 0;
  description.project(values);
  return values;
}

/// The numbers behind each `key = ` of the data file, in their order.
std::vector<double> numbers_in_file(std::string const& key) {
  std::ifstream in(BROUWER_SOURCE "/data/outer_solar_system.toml");
  std::vector<double> numbers;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(key + " = ")) continue;
    std::istringstream rest(line.substr(line.find('=') + 1));
    for (char skipped; (rest >> std::ws).good() && rest.peek() != '#';)
      if (double number; rest.peek() == '[' || rest.peek() == ',' || rest.peek() == ']')
        rest >> skipped;
      else if (rest >> number)
        numbers.push_back(number);
  }
  return numbers;
}

TEST(OuterSolarSystem, HasTheNumbersOfTheDataFile) {
  auto const values = standard_values(description);
  EXPECT_EQ(values.at("gravitational-constant"), numbers_in_file("gravitational_constant"));
  EXPECT_EQ(values.at("masses"), numbers_in_file("mass"));
  EXPECT_EQ(values.at("position"), numbers_in_file("position"));
  EXPECT_EQ(values.at("velocity"), numbers_in_file("velocity"));
}

TEST(OuterSolarSystem, HasPlanetsOnTheirOrbits) {
  Case const one(description, values_of(false));
  std::array const axes{5.2, 9.5, 19.2, 30.1, 39.5};  // AU
  auto const G = one.parameters[0];
  for (std::size_t i = 1; i < outer_bodies; ++i) {
    auto const at = [&](auto const& part) { return Vector3<Judge>{part[3 * i], part[3 * i + 1], part[3 * i + 2]}; };
    Judge const r = sqrt(squared_norm(at(one.state.q))), mu = G * (one.parameters[1] + one.parameters[i + 1]);
    Judge const axis = 1 / (2 / r - squared_norm(at(one.state.p)) / mu);
    EXPECT_NEAR(static_cast<double>(axis), axes[i - 1], 0.02 * axes[i - 1]) << outer_body_names[i];
  }
}

TEST(OuterSolarSystem, IsRecentredAsWellAsDoublesCan) {
  Case const one(description, values_of(true));
  for (int c = 0; c < 3; ++c) {
    // half an ulp of the Sun's 5·10⁻⁶ AU a day and of its 7·10⁻³ AU
    EXPECT_LT(abs(one.system.linear_momentum(one.state)[c]), Judge("5e-22")) << c;
    EXPECT_LT(abs(one.system.barycentre(one.state)[c]), Judge("5e-19")) << c;
  }
  Case const given(description, values_of(false));
  for (std::size_t i = 3; i < 18; ++i) {  // and nothing moves against the Sun but by rounding
    std::size_t const sun = i % 3;
    EXPECT_LT(abs(Judge(one.state.q[i] - one.state.q[sun] - (given.state.q[i] - given.state.q[sun]))), Judge("4e-15"));
    EXPECT_LT(abs(Judge(one.state.p[i] - one.state.p[sun] - (given.state.p[i] - given.state.p[sun]))), Judge("1e-18"));
  }
}

TEST(OuterSolarSystem, StaysWhereItIsWhenRecentredAgain) {
  auto const once = values_of(true);
  auto twice = once;
  description.project(twice);
  EXPECT_EQ(once, twice);
}

TEST(OuterSolarSystem, WarnsOfADriftingFrameAndOnlyOfThat) {
  auto drifting = values_of(false), centred = values_of(true);
  auto const warning = description.warning(drifting);
  ASSERT_TRUE(warning);
  EXPECT_EQ(
      *warning,
      "the centre of mass moves by 6.8e-06 AU/day: a drifting frame masquerades as round-off; recentre = 1 removes it");
  EXPECT_EQ(description.warning(standard_values(description)), std::nullopt);
  centred.at("recentre")[0] = 0;  // a user who has done it
  EXPECT_EQ(description.warning(centred), std::nullopt);
}

TEST(OuterSolarSystem, BarycentreShowsTheDrift) {
  Case const one(description, values_of(false));
  auto const later = testing_support::moved(one.state, one.system.rate(one.state), Judge(1));
  auto const before = one.system.barycentre(one.state), after = one.system.barycentre(later);
  Judge const moved = sqrt(squared_norm(Vector3<Judge>(after - before)));
  EXPECT_NEAR(static_cast<double>(moved), 6.750e-6, 1e-9);  // in a day
}

TEST(OuterSolarSystem, ActionIsReaction) {
  Case const one(description, values_of(true));
  auto const force = one.system.force(one.state.q);
  for (std::size_t c = 0; c < 3; ++c) {
    Judge sum = 0;
    for (std::size_t i = 0; i < outer_bodies; ++i) sum += one.system.masses()[i] * force[3 * i + c];
    EXPECT_LT(abs(sum), Judge("1e-78"));
  }
}

TEST(OuterSolarSystem, IsKeplersProblemWherePlanetsHaveNoMass) {
  auto values = values_of(true);
  values.at("masses") = {1, 0, 0, 0, 0, 0};
  Case const one(description, values);
  auto const force = one.system.force(one.state.q);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(force[i], 0);
  for (std::size_t i = 3; i < 18; i += 3) {
    Vector3<Judge> const d{one.state.q[i] - one.state.q[0], one.state.q[i + 1] - one.state.q[1],
                           one.state.q[i + 2] - one.state.q[2]};
    Judge const r = sqrt(squared_norm(d));
    for (int c = 0; c < 3; ++c)
      EXPECT_LT(abs(Judge(force[i + static_cast<std::size_t>(c)] + one.parameters[0] * d[c] / (r * r * r))),
                Judge("1e-78"));
  }
}

TEST(OuterSolarSystem, HasNoForceAndNamesACollisionWhereTwoBodiesMeet) {
  auto values = values_of(true);
  for (std::size_t c = 0; c < 3; ++c) values.at("position")[9 + c] = values.at("position")[6 + c] + 0.0028 * (c != 0);
  SystemCase<OuterSolarSystem<double>> const one(description, values);
  EXPECT_EQ(one.system.failure(one.state, 0), Failure::collision);
  auto const force = one.system.force(one.state.q);
  EXPECT_TRUE(std::isnan(force[6]) && std::isnan(force[9]));
  EXPECT_TRUE(std::isfinite(force[15])) << "Pluto has not met anybody";
  EXPECT_THAT(*description.complaint(values), HasSubstr("position of saturn and uranus"));
}

TEST(OuterSolarSystem, ErrorsOfAStateAreEachPlanetsOwn) {
  Case const one(description, values_of(true));
  auto late = one.state;
  auto const rate = one.system.rate(one.state);
  for (std::size_t c = 6; c < 9; ++c) late.q[c] += (rate.q[c] - rate.q[c - 6]) / 1000;  // Saturn, a thousandth of a day
  auto const errors = one.system.state_errors(late, one.state);
  for (std::size_t k = 0; k < errors.size(); ++k)
    if (k == 16)
      EXPECT_LT(abs(Judge(errors[k] - Judge("0.001"))), Judge("1e-60"));
    else if (k < 3 || k > 5)
      EXPECT_EQ(errors[k], 0) << k;
    else
      EXPECT_GT(abs(errors[k]), Judge("1e-6")) << k;
}

TEST(OuterSolarSystem, ErrorsOfAStateDoNotKnowWhereTheSunIs) {
  Case const one(description, values_of(true));
  auto shifted = one.state;
  for (std::size_t i = 0; i < 18; ++i) shifted.q[i] += static_cast<int>(i % 3) + 1;
  for (auto const& error : one.system.state_errors(shifted, one.state)) EXPECT_LT(abs(error), Judge("1e-70"));
}

}  // namespace
}  // namespace brouwer
