// A file is there whole or as it was, and killed writers leave nothing for long.
#include <brouwer/store/whole_file.hpp>

#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <brouwer/error.hpp>

#include "tests/store/sample_unit.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::size_t entries(std::filesystem::path const& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

/// While it lives, no file of this process can grow beyond `bytes`: a disk that becomes full in the middle.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit const tight = {bytes, before_.rlim_max};
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &tight);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(FullDisk const&) = delete;
  FullDisk& operator=(FullDisk const&) = delete;

 private:
  rlimit before_ = {};
  void (*handler_)(int) = nullptr;
};

TEST(WholeFile, HoldsWhatWasWritten) {
  Scratch const folder;
  std::string const bytes("a\0b\n", 4);
  write_whole(folder / "file", bytes);
  EXPECT_EQ(read_whole(folder / "file"), bytes);
  write_whole(folder / "file", "");
  EXPECT_EQ(read_whole(folder / "file"), "");
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(WholeFile, StaysAsItWasWhenTheDiskIsFull) {
  Scratch const folder;
  write_whole(folder / "file", "before");
  {
    FullDisk const full(1000);
    EXPECT_THAT([&] { write_whole(folder / "file", std::string(5000, 'x')); },
                ThrowsMessage<RunError>(HasSubstr((folder / "file").string() + ": File too large")));
  }
  EXPECT_EQ(read_whole(folder / "file"), "before");
  EXPECT_EQ(entries(folder.path()), 1U) << "the temporary is still there";
}

TEST(WholeFile, SaysWhyItCannotBeWritten) {
  Scratch const folder;
  write_whole(folder / "file", "no folder");
  EXPECT_THAT([&] { write_whole(folder / "none/file", ""); },
              ThrowsMessage<RunError>(HasSubstr("No such file or directory")));
  EXPECT_THAT([&] { write_whole(folder / "file/file", ""); }, ThrowsMessage<RunError>(HasSubstr("Not a directory")));
  EXPECT_THROW(write_whole(folder.path(), ""), RunError);
  EXPECT_THAT([&] { read_whole(folder / "none"); }, ThrowsMessage<RunError>(HasSubstr("No such file or directory")));
}

/// A process is killed (kill -9) while it writes again and again.
TEST(WholeFile, SurvivesTheDeathOfItsWriter) {
  Scratch const folder;
  std::string const one(300'000, '1'), two(300'000, '2');
  write_whole(folder / "file", one);
  for (int trial = 0; trial < 10; ++trial) {
    pid_t const writer = ::fork();
    if (writer == 0)
      for (;;) write_whole(folder / "file", one), write_whole(folder / "file", two);
    ::usleep(static_cast<useconds_t>(3000 + 1700 * trial));
    ::kill(writer, SIGKILL);
    ::waitpid(writer, nullptr, 0);
    auto const found = read_whole(folder / "file");
    EXPECT_TRUE(found == one || found == two);
  }
  remove_leftovers(folder.path());
  EXPECT_EQ(entries(folder.path()), 1U);
}

/// In a container every run may have the same process number, and find the temporaries of the last one.
TEST(Leftovers, OfTheSameNumberAreNoHindrance) {
  Scratch const folder;
  for (int i = 0; i < 200; ++i)
    std::ofstream(folder / (".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(i) + "-file")) << "half";
  write_whole(folder / "file", "whole");
  EXPECT_EQ(read_whole(folder / "file"), "whole");
}

TEST(Leftovers, AreRemovedInAllFoldersBelow) {
  Scratch const folder;
  std::filesystem::create_directories(folder / "units/cell-000");
  std::ofstream(folder / "units/cell-000/.tmp-17-0-members-000000.h5") << "half";
  std::ofstream(folder / "units/cell-000/members-000064.h5") << "whole";
  remove_leftovers(folder.path());
  EXPECT_FALSE(std::filesystem::exists(folder / "units/cell-000/.tmp-17-0-members-000000.h5"));
  EXPECT_TRUE(std::filesystem::exists(folder / "units/cell-000/members-000064.h5"));
  EXPECT_NO_THROW(remove_leftovers(folder / "none"));
}

TEST(Leftovers, OfALivingWriterStay) {
  Scratch const folder;
  auto const temporary = folder / ".tmp-17-0-file";
  int const writer = ::open(temporary.c_str(), O_WRONLY | O_CREAT, 0666);
  ASSERT_EQ(::flock(writer, LOCK_EX), 0);
  remove_leftovers(folder.path());
  EXPECT_TRUE(std::filesystem::exists(temporary));
  ::close(writer);
  remove_leftovers(folder.path());
  EXPECT_FALSE(std::filesystem::exists(temporary));
}

}  // namespace
}  // namespace brouwer
