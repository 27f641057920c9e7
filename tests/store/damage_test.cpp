// Whatever happens to a unit's file, reading it gives the same record or a sentence; never a crash or a wrong number.
#include <fstream>
#include <gmock/gmock.h>

#include <brouwer/error.hpp>
#include <brouwer/store/hdf5.hpp>
#include <brouwer/store/whole_file.hpp>

#include "tests/store/sample_unit.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

struct Damage : testing::Test {
  Damage() { write_unit(file, unit), whole = read_whole(file); }

  void put(std::string const& bytes) const { std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes; }

  enum class Reading { same, refused, wrong };
  Reading reading() const {
    try {
      return same(unit, read_unit(file)) ? Reading::same : Reading::wrong;
    } catch (RunError const&) {
      return Reading::refused;
    }
  }

  Scratch folder;
  std::filesystem::path file = folder / "unit.h5";
  UnitRecord unit = full_unit();
  std::string whole;
};

TEST_F(Damage, OfAnyByteIsSeenOrHarmless) {
  int refused = 0;
  for (char const flipped : {'\x01', '\x80', '\xff'})
    for (std::size_t at = 0; at < whole.size(); at += 97) {
      auto bytes = whole;
      bytes[at] = static_cast<char>(bytes[at] ^ flipped);
      put(bytes);
      auto const now = reading();
      EXPECT_NE(now, Reading::wrong) << "byte " << at << " of " << whole.size();
      refused += now == Reading::refused;
    }
  EXPECT_GT(refused, 300);  // of about 700; the rest is padding and what only other programs read
}

TEST_F(Damage, OfAnyNumberIsSeen) {
  for (auto const& series : unit.series)
    for (auto const& error : series.errors) {
      auto const at = whole.find(std::string(reinterpret_cast<char const*>(&error), sizeof error));
      ASSERT_NE(at, std::string::npos);
      auto bytes = whole;
      bytes[at] ^= 1;  // one unit in the last place
      put(bytes);
      EXPECT_EQ(reading(), Reading::refused) << series.name;
    }
}

TEST_F(Damage, OfAStateOfAReasonOrOfAStepIsSeen) {
  std::string const step(reinterpret_cast<char const*>(unit.failed_at.data()), 2 * sizeof(std::int64_t));
  std::string const state(reinterpret_cast<char const*>(&unit.states[31]), sizeof unit.states[31]);
  for (auto const& part : {std::string("did not converge"), step, state}) {
    auto bytes = whole;
    bytes[bytes.rfind(part)] ^= 2;
    put(bytes);
    EXPECT_EQ(reading(), Reading::refused);
  }
}

TEST_F(Damage, ByTheLossOfOneListOfFailuresIsSeen) {
  {
    hdf5::Session const session;
    hdf5::Handle const opened(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
    hdf5::checked(H5Ldelete(opened, "failure", H5P_DEFAULT));
  }
  EXPECT_THAT([&] { read_unit_header(file); }, ThrowsMessage<RunError>(HasSubstr("failure")));
}

TEST_F(Damage, ByTruncationIsSeen) {
  for (std::size_t length = 0; length < whole.size(); length += 131) {
    put(whole.substr(0, length));
    EXPECT_EQ(reading(), Reading::refused) << length << " of " << whole.size() << " bytes";
  }
}

TEST_F(Damage, IsNamedInOneSentence) {
  put(whole.substr(0, whole.size() / 2));
  EXPECT_THAT([&] { read_unit(file); }, ThrowsMessage<RunError>(HasSubstr(file.string())));
  EXPECT_THAT([&] { read_unit_header(file); }, ThrowsMessage<RunError>(HasSubstr("truncated")));
}

TEST_F(Damage, AFolderOrATextIsNoUnit) {
  EXPECT_THROW(read_unit(folder.path()), RunError);
  put("question = \"why?\"\n");
  EXPECT_THROW(read_unit(file), RunError);
}

/// A file that promises 2⁶⁰ members must not be believed.
TEST_F(Damage, AskingForMoreMemoryThanTheFileHasIsRefused) {
  {
    hdf5::Session const session;
    hdf5::Handle const opened(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
    hsize_t const extent = hsize_t{1} << 57;
    hdf5::Handle const space(H5Screate_simple(1, &extent, nullptr));
    H5Ldelete(opened, "member", H5P_DEFAULT);
    hdf5::Handle const member(
        H5Dcreate2(opened, "member", H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    hdf5::set(member, "crc32", std::int64_t{0});
  }
  EXPECT_THAT([&] { read_unit(file); }, ThrowsMessage<RunError>(HasSubstr("shorter than it says")));
}

}  // namespace
}  // namespace brouwer
