// Planted causes in real runs: rounded coefficients that make a bias of some 10⁻¹⁹ a step, a directed rounding, a
// truncation error, and none; each is named by the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/studies/program.hpp"

namespace brouwer {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

struct Explain : ProgramTest {
  void study(std::string const& system, std::string const& integrate, int members) const {
    write("toy.toml", "[system." + system + "]\n[integrate]\n" + integrate +
                          "\n[ensemble]\nmembers = " + std::to_string(members) +
                          "\nseed = 7\nperturb = { momentum = { uniform = 1e-2 } }\n[observe]\n"
                          "quantities = [\"energy\"]\nsamples = { count = 16, spacing = \"linear\" }\n");
  }
};

/// Fehlberg's 13 stages, compensated: the coefficients as doubles have them make a bias of −7e-20 a step.
TEST_F(Explain, FindsABiasOfRoundedCoefficients) {
  write("toy.toml",
        "[system.kepler]\n[integrate]\nmethods = \"fehlberg-8\"\ncompensation = true\nstep = 0.01\nsteps = 4000\n"
        "[ensemble]\nmembers = 256\nseed = 7\n"
        "perturb = { position = { uniform = 1e-2 }, momentum = { uniform = 1e-2 } }\n"
        "[observe]\nquantities = [\"rounding-of-energy\"]\n"
        "reference = { arithmetic = \"double-double\", members = 256 }\n"
        "samples = { count = 16, spacing = \"linear\" }\n");
  auto const said = brouwer("explain toy.toml --factors constants");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_THAT(said.text, AllOf(HasSubstr("The drift needs the rounded constants: it vanishes ("),
                               HasSubstr("with exact constants")));
}

TEST_F(Explain, FindsADirectedRounding) {
  study("rigid_body", "methods = \"elliptic-three-constants\"\nrounding = \"up\"\nstep = 0.01\nsteps = 2000", 32);
  auto const said = brouwer("explain toy.toml --factors rounding,precision --no-figures");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_THAT(said.text,
              AllOf(HasSubstr("The drift comes from the directed rounding"), HasSubstr("with rounding to nearest")));
}

TEST_F(Explain, FindsATruncationError) {
  study("henon_heiles", "methods = \"kutta-4\"\nstep = 0.2\nsteps = 2000", 16);
  auto const said = brouwer("explain toy.toml --no-figures");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("a truncation error: it persists"));
}

/// Around a cell that no higher precision has.
TEST_F(Explain, FindsATruncationErrorOfExactConstants) {
  study("henon_heiles", "methods = \"kutta-4\"\nconstants = \"exact\"\nstep = 0.2\nsteps = 1000", 16);
  auto const said = brouwer("explain toy.toml --factors precision --no-figures");
  EXPECT_THAT(said.text, HasSubstr("a truncation error: it persists"));
}

TEST_F(Explain, ReportsOutputThatIsLost) {
  study("henon_heiles", "methods = \"kutta-4\"\nstep = 0.2\nsteps = 200", 16);
  EXPECT_EQ(brouwer("explain toy.toml --factors precision --no-figures > /dev/full").status, 3);
}

TEST_F(Explain, FindsNothingWhereThereIsNothing) {
  study("rigid_body", "methods = \"elliptic-three-constants\"\nstep = 0.01\nsteps = 2000", 32);
  auto const said = brouwer("explain toy.toml --factors constants,precision --no-figures");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("There is no drift to explain"));
}

/// Results lie in a folder of their own, and are taken up again; only what is asked for goes to standard output.
TEST_F(Explain, ResumesItsDesign) {
  study("henon_heiles", "methods = \"kutta-4\"\nstep = 0.2\nsteps = 200", 16);
  auto const json = shell(std::string(BROUWER_PROGRAM) + " explain toy.toml --format json -o design 2>/dev/null");
  EXPECT_EQ(json.status, 0);
  EXPECT_THAT(json.text, testing::StartsWith("[\n  {"));
  for (auto const* part : {"operations", "rounding", "contraction", "lower-precision", "higher-precision", "figures"})
    EXPECT_TRUE(fs::exists(folder / "design" / part)) << part;
  fs::remove(folder / "design/operations/units/cell-003/members-000000.h5");
  auto const again = shell(std::string(BROUWER_PROGRAM) + " explain toy.toml --format json -o design 2>/dev/null");
  EXPECT_EQ(again.text, json.text);
}

TEST_F(Explain, SaysWhatItWouldRun) {
  study("henon_heiles", "methods = \"kutta-4\"\nstep = 0.2\nsteps = 200", 16);
  auto const said = brouwer("explain toy.toml --plan");
  EXPECT_EQ(said.status, 0);
  EXPECT_THAT(said.text,
              AllOf(HasSubstr("operations: 8 cells × 16 members"), HasSubstr("about"), HasSubstr("toy-explain")));
  EXPECT_FALSE(fs::exists(folder / "results"));
}

TEST_F(Explain, RefusesWhatItDoesNotKnow) {
  study("henon_heiles", "methods = \"kutta-4\"\nstep = 0.2\nsteps = 200", 16);
  for (auto const& [arguments, words] :
       {std::pair{"explain toy.toml --factors compensate", "did you mean 'compensation'?"},
        std::pair{"explain toy.toml --format latex", "an explanation has no format 'latex'"},
        std::pair{"explain tow.toml", "tow.toml"}, std::pair{"explain", "study is required"}}) {
    auto const said = brouwer(arguments);
    EXPECT_EQ(said.status, 2) << said.text;
    EXPECT_THAT(said.text, HasSubstr(words));
    EXPECT_FALSE(fs::exists(folder / "results"));
  }
}

}  // namespace
}  // namespace brouwer
