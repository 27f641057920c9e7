#include <brouwer/store/provenance.hpp>

#include <gmock/gmock.h>

namespace brouwer {
namespace {

using testing::MatchesRegex;

std::string value(std::string const& key) {
  for (auto const& [name, value] : provenance(3).entries)
    if (name == key) return value;
  return "";
}

TEST(Provenance, SaysWithWhatTheProgramWasMade) {
  EXPECT_THAT(value("brouwer"), MatchesRegex("[0-9]+[.][0-9]+[.][0-9]+"));
  EXPECT_THAT(value("flags"), testing::HasSubstr("-ffp-contract=off"));
  for (auto const* key : {"boost", "eigen", "gsl", "hdf5", "mpfr", "glibc"})
    EXPECT_THAT(value(key), MatchesRegex("[0-9]+[.][0-9]+.*")) << key;
}

TEST(Provenance, SaysOnWhatAndWhen) {
  for (auto const* key : {"compiler", "cpu", "instruction sets", "kernel"}) EXPECT_FALSE(value(key).empty()) << key;
  EXPECT_EQ(value("threads"), "3");
  EXPECT_THAT(value("date"), MatchesRegex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z"));
}

TEST(Provenance, IsOneLineAKey) {
  EXPECT_EQ(to_text({{{"cpu", "fast"}, {"threads", "3"}}}), "cpu = fast\nthreads = 3\n");
}

}  // namespace
}  // namespace brouwer
