// Where members were: the start, then the samples, of those units that kept states.
#include <brouwer/store/orbits.hpp>

#include <cmath>
#include <gmock/gmock.h>

#include <brouwer/store/results.hpp>

#include "tests/store/sample_unit.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;

struct StatesInAFolder : testing::Test {
  StatesInAFolder() {
    create_result_folder(folder.path(), sample_unit().study_hash, "members = 10\n", "", {}, {sample_cell()});
  }
  void put(UnitRecord const& unit) const { write_unit(folder / unit_path(0, unit.first_member), unit); }
  Orbits orbits() const { return Results(folder.path()).orbits(0); }
  Scratch folder;
};

TEST_F(StatesInAFolder, AreThoseOfTheStartAndOfTheSamples) {
  auto const first = full_unit(0), second = full_unit(5);
  put(second), put(first);
  auto const found = orbits();
  EXPECT_EQ(found.cell, sample_cell());
  EXPECT_EQ(found.members, 10u);
  EXPECT_THAT(found.times, ElementsAre(0, 1, 10, 100, 1000));
  EXPECT_THAT(found.names, ElementsAre("y1", "y2", "q0"));
  EXPECT_EQ(found.at(2, 0, 0), first.start[2 * 2 + 1]) << "y1 is the second column of the start";
  EXPECT_TRUE(std::isnan(found.at(2, 0, 1))) << "y2 is no part of the start";
  EXPECT_EQ(found.at(2, 3, 1), first.states[(2 * 4 + 2) * 3 + 1]);
  EXPECT_EQ(found.at(7, 4, 2), second.states[(2 * 4 + 3) * 3 + 2]);
}

TEST_F(StatesInAFolder, EndWhereAMemberFailed) {
  auto const unit = full_unit(0);  // member 1 fails at step 17
  put(unit);
  EXPECT_EQ(orbits().at(1, 2, 0), unit.states[(1 * 4 + 1) * 3]) << "step 10";
  EXPECT_TRUE(std::isnan(orbits().at(1, 3, 0))) << "step 100";
}

TEST_F(StatesInAFolder, AreNoneWhereNoUnitKeptThem) {
  put(sample_unit(0, 5));
  EXPECT_EQ(orbits().members, 0u);
  put(full_unit(5));
  EXPECT_EQ(orbits().members, 5u);
}

}  // namespace
}  // namespace brouwer
