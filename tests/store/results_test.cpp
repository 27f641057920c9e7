// What the statistics see of a result folder: all finished members, in order, and nothing of doubtful origin.
#include <brouwer/store/results.hpp>

#include <gmock/gmock.h>

#include <brouwer/error.hpp>
#include <brouwer/store/whole_file.hpp>

#include "tests/store/sample_unit.hpp"

namespace brouwer {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

struct UnitsInAFolder : testing::Test {
  UnitsInAFolder() {
    create_result_folder(folder.path(), sample_unit().study_hash, "members = 12\n", "question = \"?\"\n", {},
                         {sample_cell(), other_cell()});
  }
  static CellLabels other_cell() {
    auto cell = sample_cell();
    cell.method = "dmv-2";
    return cell;
  }
  void put(UnitRecord const& unit, std::size_t cell = 0) const {
    write_unit(folder / unit_path(cell, unit.first_member), unit);
  }
  Results results() const { return Results(folder.path()); }

  Scratch folder;
};

TEST_F(UnitsInAFolder, WithoutUnitsHasCellsButNoMembers) {
  auto const results = this->results();
  ASSERT_EQ(results.cells(), 2U);
  EXPECT_EQ(results.labels(1), other_cell());
  EXPECT_EQ(results.finished_members(1), 0);
  EXPECT_TRUE(results.quantities(0).empty());
  EXPECT_EQ(results.study_text(), "question = \"?\"\n");
  EXPECT_EQ(results.study_hash(), sample_unit().study_hash);
  EXPECT_THROW(results.load(0, "energy"), InputError);
}

TEST_F(UnitsInAFolder, GivesAllMembersInOrder) {
  put(sample_unit(4, 2)), put(sample_unit(0, 4)), put(sample_unit(9, 3));
  auto const ensemble = results().load(0, "casimir");
  EXPECT_EQ(results().finished_members(0), 9);
  EXPECT_EQ(ensemble.cell, sample_cell());
  EXPECT_EQ(ensemble.family, "quantity of casimir");
  EXPECT_EQ(ensemble.unit, "kg m²/s²");
  EXPECT_THAT(ensemble.times, ElementsAre(1, 10, 100, 1000));
  std::vector<double> expected;
  for (auto const& unit : {sample_unit(0, 4), sample_unit(4, 2), sample_unit(9, 3)})
    expected.insert(expected.end(), unit.series[1].errors.begin(), unit.series[1].errors.end());
  ASSERT_EQ(ensemble.errors.rows(), 9);
  EXPECT_THAT(ensemble.names, ElementsAre("0", "1", "2", "3", "4", "5", "9", "10", "11"));
  EXPECT_TRUE(same_bits({ensemble.errors.data(), ensemble.errors.data() + ensemble.errors.size()}, expected));
  EXPECT_EQ(ensemble.failed, 0);
}

TEST_F(UnitsInAFolder, NamesOnlyWhatAMemberHas) {
  put(sample_unit());
  EXPECT_THAT(results().quantities(0), Contains("y1"));
  EXPECT_THAT(results().quantities(0), Not(Contains("y2")));
  EXPECT_EQ(results().quantities(0).front(), "energy");
  EXPECT_EQ(results().load(0, "y1").errors.rows(), 3);
  EXPECT_THAT([&] { results().load(0, "enrgy"); }, ThrowsMessage<InputError>(HasSubstr("did you mean 'energy'")));
}

TEST_F(UnitsInAFolder, LeavesOutMembersThatFailedInThatQuantityAlone) {
  auto unit = sample_unit(0, 5);
  auto& errors = unit.series[0].errors;
  for (auto const at : {3U, 8U}) errors[at] = at == 3 ? std::nan("") : std::numeric_limits<double>::infinity();
  put(unit);
  auto const ensemble = results().load(0, "energy");
  EXPECT_EQ(ensemble.failed, 2);
  ASSERT_EQ(ensemble.errors.rows(), 3);
  EXPECT_TRUE(ensemble.errors.allFinite());
  EXPECT_EQ(ensemble.errors(0, 0), errors[4]);
  EXPECT_EQ(ensemble.errors(1, 3), errors[15]);
  EXPECT_EQ(ensemble.errors(2, 0), errors[16]);
  EXPECT_THAT(ensemble.names, ElementsAre("1", "3", "4"));
  EXPECT_EQ(results().load(0, "casimir").failed, 0);
}

/// Member 3 and 5 did not converge, 4 and 12 collided, 7 is not finite for no recorded reason, 10 and 11 are of a unit
/// from before reasons were recorded.
TEST_F(UnitsInAFolder, TellsWhyMembersAreLeftOut) {
  auto const give_up = [](UnitRecord& unit, std::size_t member) {
    for (auto& series : unit.series)
      if (member < static_cast<std::size_t>(series.members)) series.errors[4 * member + 3] = std::nan("");
  };
  std::string const diverged = "the iteration did not converge";
  auto first = sample_unit(0, 8), second = sample_unit(8, 3), third = sample_unit(12, 1);
  first.failed_at = {-1, -1, -1, 1000, 17, 120, -1, -1};
  first.failure = {"", "", "", diverged, "collision", diverged, "", ""};
  third.failed_at = {5}, third.failure = {"collision"};
  for (auto const member : {3U, 4U, 5U, 7U}) give_up(first, member);
  give_up(second, 2), give_up(second, 1), give_up(third, 0);
  put(first), put(second), put(third);
  auto const ensemble = results().load(0, "energy");
  EXPECT_EQ(ensemble.failed, 7);
  EXPECT_EQ(ensemble.errors.rows(), 5);
  EXPECT_TRUE(ensemble.errors.allFinite());
  EXPECT_THAT(ensemble.failures,
              ElementsAre(Failures{"", 3, -1}, Failures{diverged, 2, 120}, Failures{"collision", 2, 5}));
  EXPECT_TRUE(results().load(0, "y1").failures == (std::vector<Failures>{{"", 2, -1}, {"collision", 1, 5}}))
      << "only three members of each unit are compared with a reference";
}

TEST_F(UnitsInAFolder, LeavesOutAMemberThatFailedWhateverItsNumbersAre) {
  auto unit = full_unit(0);
  put(unit);
  auto const ensemble = results().load(0, "iterations");
  EXPECT_TRUE(ensemble.count);
  EXPECT_FALSE(results().load(0, "energy").count);
  ASSERT_EQ(ensemble.errors.rows(), 3);
  EXPECT_EQ(ensemble.errors(1, 0), unit.series.back().errors[8]) << "member 2 follows member 0";
}

TEST_F(UnitsInAFolder, MayHaveNoMemberThatDidNotFail) {
  auto unit = sample_unit(0, 2);
  unit.series[0].errors.assign(8, std::nan(""));
  put(unit);
  EXPECT_EQ(results().load(0, "energy").failed, 2);
  EXPECT_EQ(results().load(0, "energy").errors.rows(), 0);
}

TEST_F(UnitsInAFolder, FromBeforeTheFactorCoefficientsAreTakenWithThoseFromAfterIt) {
  auto old = sample_unit(0, 4), now = sample_unit(4, 4);
  now.cell.coefficients = no_level;
  put(old), put(now);
  forget(folder / unit_path(0, 0), {"coefficients"});
  std::string const level = "coefficients = per-trajectory, ";
  auto plan = read_whole(folder / "plan.txt");
  write_whole(folder / "plan.txt", plan.erase(plan.find(level), level.size()));
  EXPECT_EQ(results().labels(0), now.cell);
  EXPECT_EQ(results().finished_members(0), 8);
}

struct Refusal : UnitsInAFolder {
  void expect(std::string const& reason) const {
    EXPECT_THAT([&] { results(); }, ThrowsMessage<RunError>(HasSubstr(reason)));
  }
};

TEST_F(Refusal, OfUnitsOfAnotherStudy) {
  auto unit = sample_unit();
  unit.study_hash = "another";
  put(unit);
  expect("belongs to another study");
}

TEST_F(Refusal, OfUnitsOfAnotherCell) {
  put(sample_unit(), 1);
  expect("is of another cell");
}

TEST_F(Refusal, OfMembersThatAreThereTwice) {
  put(sample_unit(0, 4)), put(sample_unit(3, 4));
  expect("members-000003.h5 has members that the unit before it has too");
}

TEST_F(Refusal, OfOtherSamples) {
  auto unit = sample_unit(0, 4);
  unit.sample_steps = {1, 10, 101, 1000};
  put(unit), put(sample_unit(4, 4));
  expect("has other samples");
}

TEST_F(Refusal, OfDamagedUnits) {
  put(sample_unit());
  auto const file = folder / unit_path(0, 64);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 100);
  expect("delete it and run the study again");
}

TEST_F(Refusal, OfADamagedPlan) {
  write_whole(folder / "plan.txt", "stu");
  expect("plan.txt is damaged");
}

TEST(Results, NeedAResultFolder) {
  Scratch const folder;
  EXPECT_THAT([&] { Results(folder / "none"); }, ThrowsMessage<InputError>(HasSubstr("there is no result folder")));
  EXPECT_THAT([&] { Results{folder.path()}; }, ThrowsMessage<InputError>(HasSubstr("is no result folder")));
}

}  // namespace
}  // namespace brouwer
