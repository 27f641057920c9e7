// A unit comes back from its file bit for bit, and the same unit is the same file.
#include <cstdlib>
#include <gmock/gmock.h>
#include <thread>

#include <brouwer/error.hpp>
#include <brouwer/store/whole_file.hpp>

#include "tests/store/sample_unit.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

void expect_return(UnitRecord const& unit) {
  Scratch const folder;
  write_unit(folder / "unit.h5", unit);
  EXPECT_TRUE(same(unit, read_unit(folder / "unit.h5")));
}

TEST(UnitFile, ReturnsWhatWasWrittenBitForBit) {
  UnitRecord unit = sample_unit();
  unit.series[0].errors = {std::nan("17"), -0.0, std::numeric_limits<double>::denorm_min(),
                           -std::numeric_limits<double>::infinity()};
  unit.series[0].errors.resize(20, 1.0 / 3.0);
  expect_return(unit);
}

TEST(UnitFile, ReturnsWhoFailedWhatCountsAndTheStates) { expect_return(full_unit()); }

TEST(UnitFile, GivesItsStatesAlone) {
  Scratch const folder;
  write_unit(folder / "unit.h5", full_unit());
  write_unit(folder / "old.h5", sample_unit());
  EXPECT_TRUE(same_bits(read_states(folder / "unit.h5"), full_unit().states));
  EXPECT_TRUE(read_states(folder / "old.h5").empty());
}

TEST(UnitFile, OfWhichNothingMoreIsToBeSaidIsAsItWasBeforeThereWasMore) {
  Scratch const folder;
  write_unit(folder / "unit.h5", sample_unit());
  write_unit(folder / "full.h5", full_unit());
  auto const bytes = read_whole(folder / "unit.h5"), full = read_whole(folder / "full.h5");
  for (auto const* name : {"failed_at", "failure", "states", "count"}) {
    EXPECT_THAT(bytes, testing::Not(HasSubstr(name)));
    EXPECT_THAT(full, HasSubstr(name));
  }
  write_unit(folder / "again.h5", read_unit(folder / "unit.h5"));
  EXPECT_EQ(read_whole(folder / "again.h5"), bytes);
  EXPECT_TRUE(read_unit(folder / "unit.h5").failed_at.empty());
}

TEST(UnitFile, KeepsTheOrderOfItsSeries) {
  Scratch const folder;
  write_unit(folder / "unit.h5", sample_unit());
  std::vector<std::string> names;
  for (auto const& series : read_unit_header(folder / "unit.h5").series) names.push_back(series.name);
  EXPECT_THAT(names, ElementsAre("energy", "casimir", "attitude-norm", "spatial-momentum-1", "z", "a", "b", "c", "d",
                                 "y1", "y2"));
}

TEST(UnitFile, FromBeforeTheFactorCoefficientsHasNone) {
  Scratch const folder;
  UnitRecord unit = sample_unit();
  write_unit(folder / "unit.h5", unit);
  forget(folder / "unit.h5", {"coefficients"});
  unit.cell.coefficients = no_level;
  EXPECT_TRUE(same(unit, read_unit(folder / "unit.h5")));
}

TEST(UnitFile, FromBeforeTheFactorsOfOperationsHasTheProcessors) {
  Scratch const folder;
  UnitRecord unit = sample_unit();
  write_unit(folder / "unit.h5", unit);
  forget(folder / "unit.h5", {"rounding", "constants", "contraction"});
  CellLabels const standard;
  unit.cell.rounding = standard.rounding;
  unit.cell.constants = standard.constants;
  unit.cell.contraction = standard.contraction;
  EXPECT_TRUE(same(unit, read_unit(folder / "unit.h5")));
}

TEST(UnitFile, HeaderHasEverythingButTheNumbers) {
  Scratch const folder;
  UnitRecord unit = full_unit();
  write_unit(folder / "unit.h5", unit);
  for (auto& series : unit.series) series.errors.clear();
  unit.start.clear();
  unit.final_state.clear();
  unit.states.clear();
  EXPECT_TRUE(same(unit, read_unit_header(folder / "unit.h5")));
}

TEST(UnitFile, EndsAreAllButErrorsAndStates) {
  Scratch const folder;
  UnitRecord unit = full_unit();
  write_unit(folder / "unit.h5", unit);
  for (auto& series : unit.series) series.errors.clear();
  unit.states.clear();
  EXPECT_TRUE(same(unit, read_unit_ends(folder / "unit.h5")));
}

TEST(UnitFile, OneSeriesCanBeReadIntoItsPlace) {
  Scratch const folder;
  UnitRecord const unit = sample_unit();
  write_unit(folder / "unit.h5", unit);
  std::vector<double> numbers(20);
  read_series(folder / "unit.h5", "casimir", numbers);
  EXPECT_TRUE(same_bits(numbers, unit.series[1].errors));
  EXPECT_THROW(read_series(folder / "unit.h5", "casimir", std::span(numbers).first(19)), RunError);
  EXPECT_THROW(read_series(folder / "unit.h5", "no-such-series", numbers), RunError);
}

TEST(UnitFile, IsTheSameBytesWhenWrittenAgain) {
  Scratch const folder;
  write_unit(folder / "first.h5", full_unit());
  ::sleep(1);  // long enough for a time stamp to differ
  std::thread([&] { write_unit(folder / "second.h5", full_unit()); }).join();
  EXPECT_EQ(read_whole(folder / "first.h5"), read_whole(folder / "second.h5"));
}

TEST(UnitFile, MayBeWrittenAndReadByManyThreadsAtOnce) {
  Scratch const folder;
  std::vector<std::thread> threads;
  std::vector<int> right(8);
  for (std::size_t i = 0; i < right.size(); ++i)
    threads.emplace_back([&, i] {
      auto const unit = sample_unit(static_cast<std::int64_t>(i), 20);
      auto const file = folder / std::to_string(i);
      for (int again = 0; again < 5; ++again) write_unit(file, unit), right[i] += same(unit, read_unit(file));
    });
  for (auto& thread : threads) thread.join();
  EXPECT_THAT(right, testing::Each(5));
}

TEST(UnitFile, MayHaveNoMembers) { expect_return(sample_unit(0, 0)); }

TEST(UnitFile, MayHaveNoSamples) {
  UnitRecord unit = sample_unit();
  unit.sample_steps.clear();
  for (auto& series : unit.series) series.errors.clear();
  expect_return(unit);
}

TEST(UnitFile, MayHaveNoSeries) {
  UnitRecord unit = sample_unit();
  unit.series.clear();
  expect_return(unit);
}

TEST(UnitFile, MayHaveNoStateComponents) {
  UnitRecord unit = sample_unit();
  unit.start_names.clear(), unit.start.clear(), unit.state_names.clear(), unit.final_state.clear();
  expect_return(unit);
}

TEST(UnitFile, MayBeEmpty) { expect_return(UnitRecord{}); }

TEST(UnitFile, RefusesARecordWhoseArraysDoNotFit) {
  Scratch const folder;
  std::vector<UnitRecord> units(5, full_unit());
  units[0].series[2].errors.pop_back();
  units[1].failed_at.pop_back();
  units[2].failure.clear();
  units[3].failed_at.clear();
  units[4].states.pop_back();
  for (auto const& unit : units) EXPECT_THROW(write_unit(folder / "unit.h5", unit), std::logic_error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(UnitFile, SaysWhyItCannotBeWritten) {
  Scratch const folder;
  EXPECT_THAT([&] { write_unit(folder / "missing/unit.h5", sample_unit()); },
              ThrowsMessage<RunError>(HasSubstr("missing/unit.h5: No such file or directory")));
}

TEST(UnitFile, SaysThatItIsNotThere) {
  Scratch const folder;
  EXPECT_THAT([&] { read_unit(folder / "none.h5"); }, ThrowsMessage<RunError>(HasSubstr("none.h5")));
}

TEST(UnitFile, IsUnderstoodByNetcdf) {
  if (std::system("command -v ncdump > /dev/null") != 0) GTEST_SKIP() << "ncdump (netcdf-bin) is not installed";
  Scratch const folder;
  write_unit(folder / "unit.h5", full_unit());
  auto const dump = folder / "dump.txt";
  ASSERT_EQ(std::system(("ncdump -v step '" + (folder / "unit.h5").string() + "' > " + dump.string()).c_str()), 0);
  auto const text = read_whole(dump);
  EXPECT_THAT(text, HasSubstr("double energy(member, step)"));
  EXPECT_THAT(text, HasSubstr("double y1(member_3, step)"));
  EXPECT_THAT(text, HasSubstr("int64 failed_at(member)"));
  EXPECT_THAT(text, HasSubstr("double states(member, step, state_component)"));
  EXPECT_THAT(text, HasSubstr("step = 1, 10, 100, 1000"));
}

}  // namespace
}  // namespace brouwer
