#include <gmock/gmock.h>

#include <brouwer/store/provenance.hpp>
#include <regex>

namespace brouwer {
namespace {

std::string value(std::string const& key) {
  for (auto const& [name, value] : provenance(3).entries)
    if (name == key) return value;
  return "";
}

TEST(Provenance, SaysWithWhatTheProgramWasMade) {
  EXPECT_TRUE(std::regex_match(value("brouwer"), std::regex(R"(\d+\.\d+\.\d+)")));
  EXPECT_THAT(value("flags"), testing::HasSubstr("-ffp-contract=off"));
  for (auto const* key : {"boost", "eigen", "gsl", "hdf5", "mpfr", "glibc"})
    EXPECT_TRUE(std::regex_search(value(key), std::regex(R"(^\d+\.\d+)"))) << key << ": " << value(key);
}

TEST(Provenance, SaysOnWhatAndWhen) {
  for (auto const* key : {"compiler", "cpu", "instruction sets", "kernel"}) EXPECT_FALSE(value(key).empty()) << key;
  EXPECT_EQ(value("threads"), "3");
  EXPECT_TRUE(std::regex_match(value("date"), std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)")));
}

TEST(Provenance, IsOneLineAKey) {
  EXPECT_EQ(to_text({{{"cpu", "fast"}, {"threads", "3"}}}), "cpu = fast\nthreads = 3\n");
}

}  // namespace
}  // namespace brouwer
