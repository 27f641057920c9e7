// What units cost: a line a unit, whoever writes it, and half a line spoils nothing.
#include <brouwer/store/timings.hpp>

#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <thread>

#include <brouwer/error.hpp>
#include <brouwer/store/results.hpp>
#include <brouwer/store/whole_file.hpp>

#include "tests/store/sample_unit.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Timings, AreATableWithAHeading) {
  Scratch const folder;
  append_timing(folder.path(), unit_path(0, 0), 16, 0.75);
  append_timing(folder.path(), unit_path(1, 16), 8, 1e-4);
  EXPECT_EQ(read_whole(folder / "timings.csv"),
            "unit,members,seconds\nunits/cell-000/members-000000.h5,16,0.75\n"
            "units/cell-001/members-000016.h5,8,0.0001\n");
  EXPECT_EQ(read_timings(folder.path()).at("units/cell-001/members-000016.h5").members, 8);
}

TEST(Timings, AreNoneWhereThereIsNoFile) {
  Scratch const folder;
  EXPECT_TRUE(read_timings(folder.path()).empty());
}

TEST(Timings, OfAUnitThatWasComputedAgainAreThoseOfTheLastTime) {
  Scratch const folder;
  append_timing(folder.path(), unit_path(0, 0), 16, 3);
  append_timing(folder.path(), unit_path(0, 16), 16, 5);
  append_timing(folder.path(), unit_path(0, 0), 16, 4);
  auto const timings = read_timings(folder.path());
  EXPECT_EQ(timings.size(), 2U);
  EXPECT_EQ(timings.at(unit_path(0, 0).string()).seconds, 4);
}

TEST(Timings, PassOverWhatIsNoLine) {
  Scratch const folder;
  append_timing(folder.path(), unit_path(0, 0), 16, 3);
  std::ofstream(folder / "timings.csv", std::ios::app)
      << "unit,members,seconds\nunits/cell-000/mem\n\na,b,c\na,0,1\na,4,-1\na,4,nan\na,4,1x\nb,2,1,\nc,2,1.5";
  EXPECT_EQ(read_timings(folder.path()).size(), 1U);
}

TEST(Timings, OfManyThreadsAndProcessesAreAllThere) {
  Scratch const folder;
  auto const append_some = [&](std::size_t cell) {
    std::vector<std::thread> threads;
    for (std::int64_t thread = 0; thread < 4; ++thread)
      threads.emplace_back([&, thread] {
        for (std::int64_t i = 0; i < 25; ++i) append_timing(folder.path(), unit_path(cell, 100 * thread + i), 1, 0.5);
      });
    for (auto& thread : threads) thread.join();
  };
  pid_t const other = ::fork();
  append_some(other == 0 ? 1 : 0);
  if (other == 0) ::_exit(0);
  ::waitpid(other, nullptr, 0);
  EXPECT_EQ(read_timings(folder.path()).size(), 200U);
  auto const text = read_whole(folder / "timings.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 201) << "one heading";
}

TEST(Timings, ThatCannotBeWrittenAreTold) {
  Scratch const folder;
  EXPECT_THAT([&] { append_timing(folder / "none", unit_path(0, 0), 1, 1); },
              ThrowsMessage<RunError>(HasSubstr("none/timings.csv: No such file or directory")));
}

TEST(Timings, GiveResultsTheSecondsOfAMember) {
  Scratch const folder;
  create_result_folder(folder.path(), sample_unit().study_hash, "members = 8\n", "", {}, {sample_cell()});
  for (auto const first : {0, 4}) write_unit(folder / unit_path(0, first), sample_unit(first, 4));
  EXPECT_TRUE(std::isnan(Results(folder.path()).seconds_per_member(0)));
  append_timing(folder.path(), unit_path(0, 0), 4, 1);
  append_timing(folder.path(), unit_path(0, 4), 4, 3);
  append_timing(folder.path(), unit_path(0, 8), 4, 100);  // of a unit that is gone
  EXPECT_EQ(Results(folder.path()).seconds_per_member(0), 0.5);
}

}  // namespace
}  // namespace brouwer
