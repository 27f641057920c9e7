// The factors rounding, constants and contraction as a user meets them: from the study file to tables and baselines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/store/results.hpp>

#include "studies/read.hpp"
#include "tests/store/sample_unit.hpp"
#include "tests/studies/in_process.hpp"

namespace brouwer {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Catalogue const& catalogue() {
  static auto const built = builtin_catalogue();
  return built;
}

/// A toy study with such lines in [integrate], and such text behind it.
std::string toy(std::string const& integrate, std::string const& behind = "") {
  return "[system.rigid_body]\n[integrate]\nmethods = 'elliptic-naive'\nstep = 0.01\nsteps = 200\n" + integrate +
         "\n[ensemble]\nmembers = 12\nseed = 5\nperturb = { momentum = { uniform = 1e-2 } }\n"
         "[observe]\nquantities = 'energy'\nsamples = { count = 8 }\n" +
         behind;
}

std::string expecting(std::string const& where) {
  return "[[expect]]\nof = 'energy'\nwhere = { " + where + " }\ndrift = { per_step = [-1e-14, 1e-14] }\n";
}

StudyFile read(std::string const& text, std::vector<Override> const& overrides = {}) {
  return parse_study(text, "toy.toml", catalogue(), overrides);
}

std::string complaint(std::string const& text) {
  try {
    read(text);
  } catch (InputError const& error) {
    return error.what();
  }
  return "";
}

TEST(Operations, AreReadAsOneLevelOrAsAList) {
  auto const one = read(toy("rounding = 'stochastic'\nconstants = 'exact'\ncontraction = true")).study;
  EXPECT_THAT(one.rounding, ElementsAre("stochastic"));
  EXPECT_THAT(one.constants, ElementsAre("exact"));
  EXPECT_THAT(one.contraction, ElementsAre(true));
  auto const file =
      read(toy("rounding = ['nearest', 'up', 'down', 'toward-zero', 'stochastic']\n"
               "constants = ['rounded', 'exact']\ncontraction = [false, true]"));
  EXPECT_EQ(file.plan.cells.size(), 5U * 2U * 2U);
  EXPECT_TRUE(file.plan.skipped.empty());
}

/// … and a study that says so is the one that it was before there were these factors.
TEST(Operations, AreTheProcessorsWhereNothingIsSaid) {
  auto const silent = read(toy("")).study;
  EXPECT_THAT(silent.rounding, ElementsAre("nearest"));
  EXPECT_THAT(silent.constants, ElementsAre("rounded"));
  EXPECT_THAT(silent.contraction, ElementsAre(false));
  auto const said = read(toy("rounding = 'nearest'\nconstants = 'rounded'\ncontraction = false")).study;
  EXPECT_EQ(study_hash(silent), study_hash(said));
  for (auto const* other : {"rounding = 'up'", "constants = 'exact'", "contraction = true"})
    EXPECT_NE(study_hash(read(toy(other)).study), study_hash(silent)) << other;
  auto const shipped = read_study(BROUWER_SOURCE "/studies/elliptic-drift.toml", catalogue(), {}).study;
  EXPECT_EQ(study_hash(shipped), "076918cd-8514-50fc-84e0-0eba5086a874") << "of results from before";
}

TEST(Operations, AreRefusedByNameAndPlace) {
  std::pair<std::string, char const*> const wrong[] = {
      {toy("rounding = 'nearst'"),
       "toy.toml:6: integrate.rounding: there is no rounding 'nearst'; did you mean 'nearest'?"},
      {toy("rounding = 'toward_zero'"), "did you mean 'toward-zero'?"},
      {toy("rounding = true"), "integrate.rounding = true, expected a name in quotes, one of nearest, up, down"},
      {toy("rounding = []"), "integrate.rounding is empty, expected at least one level"},
      {toy("rounding = ['up', 'up']"), "integrate.rounding has 'up' twice"},
      {toy("roundin = 'up'"), "unknown key 'integrate.roundin'; did you mean 'rounding'?"},
      {toy("constants = 'exakt'"), "there is no kind of constants 'exakt'; did you mean 'exact'?"},
      {toy("contraction = 'yes'"), "integrate.contraction = 'yes', expected true or false"},
      {toy("contraction = [true, 'fused']"), "expected true or false"},
      {toy("", expecting("rounding = 'upp'")),
       "expect[1].where.rounding: there is no rounding 'upp'; did you mean 'up'?"},
      {toy("", expecting("constants = 'ronded'")), "did you mean 'rounded'?"},
      {toy("", expecting("contraction = 'yes'")), "expect[1].where.contraction = 'yes', expected true or false"},
      {toy("rounding = ['nearest', 'up']", expecting("rounding = 'down'")),
       "where.rounding = down is not run by this study, run are nearest, up"},
      {toy("", expecting("constants = 'exact'")), "where.constants = exact is not run by this study, run are rounded"},
      {toy("", expecting("contraction = true")), "where.contraction = true is not run by this study, run are false"},
      {toy("arithmetic = ['double', 'float128']\nrounding = ['nearest', 'up']",
           expecting("arithmetic = 'float128', rounding = 'up'")),
       "'where' matches no combination of levels that this study runs"},
  };
  for (auto const& [text, expected] : wrong) EXPECT_THAT(complaint(text), HasSubstr(expected));
}

TEST(Operations, AreLeftOutWhereTheyDoNotReachAndRefusedWhereNothingIsLeft) {
  auto const skipped = read(toy("arithmetic = ['double', 'float128']\nrounding = ['nearest', 'up']")).plan.skipped;
  ASSERT_EQ(skipped.size(), 1U);
  EXPECT_EQ(skipped[0].cell.arithmetic, "float128");
  EXPECT_EQ(skipped[0].cell.rounding, "up");
  std::pair<char const*, char const*> const impossible[] = {
      {"arithmetic = 'float128'\nrounding = 'up'",
       "nothing is left to run: a step with rounding up exists "
       "in float and double only, not in float128"},
      {"arithmetic = 'long-double'\ncontraction = true", "a step with contraction exists in float and double only"},
      {"special_functions = 'gsl'\nrounding = 'stochastic'", "does not reach into the 'gsl' elliptic functions"},
      {"special_functions = 'boost'\nconstants = 'exact'",
       "a step with exact constants does not reach into the 'boost'"},
  };
  for (auto const& [integrate, expected] : impossible) EXPECT_THAT(complaint(toy(integrate)), HasSubstr(expected));
}

TEST(Operations, AreSetFromTheCommandLine) {
  auto const study = read(toy("rounding = 'down'"),
                          {parse_override("integrate.rounding=['up','stochastic']"),
                           parse_override("integrate.constants=exact"), parse_override("integrate.contraction=true")})
                         .study;
  EXPECT_THAT(study.rounding, ElementsAre("up", "stochastic"));
  EXPECT_THAT(study.constants, ElementsAre("exact"));
  EXPECT_THAT(study.contraction, ElementsAre(true));
}

std::string crossed() {
  return toy(
      "rounding = ['nearest', 'up', 'stochastic']\nconstants = ['rounded', 'exact']\ncontraction = [false, true]",
      expecting("rounding = 'up', constants = 'exact', contraction = true"));
}

struct StudyOfOperations : InProcess {
  StudyOfOperations() : InProcess(crossed().c_str(), catalogue()) {}
  void run() const { said({"run", study(), "-o", results(), "--no-figures"}); }
};

TEST_F(StudyOfOperations, IsRunTabulatedAndJudged) {
  auto const run = said({"run", study(), "-o", results(), "--no-figures"});
  EXPECT_THAT(run, HasSubstr("rounding    constants  products"));
  EXPECT_THAT(run, HasSubstr("\nstochastic  exact      fused"));
  EXPECT_THAT(run, HasSubstr("\nenergy, stochastic rounding, exact constants, fused products: "));
  EXPECT_THAT(run, HasSubstr("PASS  energy, elliptic-naive, double, rounding up, exact constants, fused products"));
  EXPECT_THAT(said({"table", results(), "--format", "markdown"}),
              AllOf(HasSubstr("| rounding | constants | products |"), HasSubstr("| up | rounded | fused |")));
  EXPECT_THAT(said({"table", results(), "--format", "csv"}), HasSubstr(",200,up,exact,true,energy,"));
  EXPECT_THAT(said({"table", results(), "--format", "json"}),
              HasSubstr("\"rounding\": \"stochastic\",\n    \"constants\": \"exact\",\n    \"contraction\": false,\n"));
  EXPECT_THAT(said({"check", results()}), HasSubstr("PASS  energy"));
}

TEST_F(StudyOfOperations, SaysNothingOfThemWhereTheyAreTheProcessors) {
  auto const table = said({"run", study(), "-o", results(), "--no-figures", "--set", "integrate.rounding=nearest",
                           "--set", "integrate.constants=rounded", "--set", "integrate.contraction=false"});
  for (auto const* word : {"to nearest", "constants  ", "products  ", "exact constants", "fused", "separate"})
    EXPECT_THAT(table, Not(HasSubstr(word)));
}

TEST_F(StudyOfOperations, IsPlanned) {
  auto const plan = said({"plan", study(), "--set", "integrate.special_functions=['own','gsl']"});
  EXPECT_THAT(plan, HasSubstr("           own functions, rounding up, exact constants, fused products\n"));
  EXPECT_THAT(plan,
              HasSubstr("Left out   rigid_body, elliptic-naive, double, gsl functions, not compensated, stochastic "
                        "rounding, h = 0.01, 200 steps: a step with rounding stochastic does not"));
  auto const impossible =
      brouwer({"plan", study(), "--set", "integrate.arithmetic=mpfr-256", "--set", "integrate.rounding=up"});
  EXPECT_EQ(impossible.status, 2);
  EXPECT_THAT(impossible.err, HasSubstr("nothing is left to run"));
}

TEST_F(StudyOfOperations, IsListedHelpedAndCompleted) {
  EXPECT_THAT(said({"list", "operations"}),
              AllOf(HasSubstr("nearest, up, down, toward-zero, stochastic:"), HasSubstr("rounded, exact:"),
                    HasSubstr("false, true:"), HasSubstr("for methods that run in lanes")));
  EXPECT_THAT(said({"integrate", "--help"}),
              AllOf(HasSubstr("--rounding"), HasSubstr("--constants"), HasSubstr("--contraction")));
  for (auto const* shell : {"bash", "zsh"})
    EXPECT_THAT(said({"completion", shell}),
                AllOf(HasSubstr(" --rounding --constants --contraction "), HasSubstr(" arithmetics operations ")));
}

/// The last line of a trajectory of member 3, in hexadecimal.
struct TrajectoryOfOperations : StudyOfOperations {
  std::string last_line(std::vector<std::string> options) const {
    options.insert(options.begin(), {"integrate", study(), "--member", "3", "--steps", "40", "--every", "40", "--hex"});
    auto const text = said(options);
    return text.substr(text.rfind('\n', text.size() - 2) + 1);
  }
};

TEST_F(TrajectoryOfOperations, HasOptionsForThem) {
  std::vector<std::string> lines = {last_line({})};
  for (auto const* rounding : {"up", "down", "toward-zero", "stochastic"})
    lines.push_back(last_line({"--rounding", rounding}));
  lines.push_back(last_line({"--constants", "exact"}));
  lines.push_back(last_line({"--contraction", "true"}));
  EXPECT_EQ(lines[0], last_line({"--rounding", "nearest", "--constants", "rounded", "--contraction", "false"}));
  EXPECT_EQ(lines[4], last_line({"--rounding", "stochastic"})) << "the same random numbers";
  EXPECT_NE(lines[4], last_line({"--rounding", "stochastic", "--set", "ensemble.seed=6"}));
  std::sort(lines.begin(), lines.end());
  EXPECT_EQ(std::adjacent_find(lines.begin(), lines.end()), lines.end())
      << "two kinds of operations gave the same bits";
}

TEST_F(TrajectoryOfOperations, RefusesWhatDoesNotExist) {
  std::pair<std::vector<std::string>, char const*> const wrong[] = {
      {{"--rounding", "upp"}, "--rounding upp: integrate.rounding: there is no rounding 'upp'; did you mean 'up'?"},
      {{"--contraction", "yes"}, "--contraction yes: integrate.contraction = 'yes', expected true or false"},
      {{"--roundin", "up"}, "did you mean '--rounding'?"},
      {{"--arithmetic", "float128", "--rounding", "up"}, "nothing is left to run: a step with rounding up"},
      {{"--method", "dmv-matrix", "--rounding", "up"}, "dmv-matrix computes in part by libraries"},
  };
  for (auto const& [options, expected] : wrong) {
    std::vector<std::string> arguments = {"integrate", study()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    auto const said = brouwer(arguments);
    EXPECT_EQ(said.status, 2) << expected;
    EXPECT_THAT(said.err, HasSubstr(expected));
  }
}

TEST_F(StudyOfOperations, IsProbedCellByCell) {
  auto const json = said({"probe", study(), "--format", "json"});
  for (auto const* operations :
       {R"("operations": {"rounding": "nearest", "constants": "rounded", "contraction": false})",
        R"("operations": {"rounding": "up", "constants": "exact", "contraction": true})",
        R"("operations": {"rounding": "stochastic", "constants": "exact", "contraction": false})"})
    EXPECT_THAT(json, HasSubstr(operations));
  EXPECT_THAT(json, HasSubstr(R"("special_functions": "own", "coefficients": "-")"));
}

TEST_F(StudyOfOperations, HasABaselineWithARowForEach) {
  run();
  auto const file = (folder / "before.json").string();
  EXPECT_THAT(said({"baseline", results(), "-o", file, "--label", "before"}), HasSubstr("Recorded 'before'"));
  auto const same = said({"check", results(), "--baseline", file});
  EXPECT_THAT(same, HasSubstr("PASS  energy, elliptic-naive, double, stochastic rounding, exact constants, fused "
                              "products, h = 0.01: not worse than 'before'\n        found the same bits"));
  auto const gone = brouwer({"check", study(), "--baseline", file, "-o", (folder / "fewer").string(), "--set",
                             "integrate.rounding=['nearest','stochastic']"});
  EXPECT_EQ(gone.status, 1);
  EXPECT_THAT(gone.out, HasSubstr("FAIL  energy, elliptic-naive, double, rounding up, exact constants, h = 0.01: not "
                                  "worse than 'before'\n        found it was recorded, and is not there any more"));
}

/// A folder from before there were these factors: its plan does not name them, its units have no such labels.
TEST_F(StudyOfOperations, IsNotAskedOfOldResults) {
  std::vector<std::string> const standard = {"--set", "integrate.rounding=nearest",
                                             "--set", "integrate.constants=rounded",
                                             "--set", "integrate.contraction=false"};
  auto again = std::vector<std::string>{"run", study(), "-o", results(), "--no-figures"};
  again.insert(again.end(), standard.begin(), standard.end());
  auto const first = said(again), table = said({"table", results(), "--format", "json"});
  for (auto const& entry : std::filesystem::recursive_directory_iterator(results()))
    if (entry.path().extension() == ".h5") forget(entry.path(), {"rounding", "constants", "contraction"});
  EXPECT_EQ(said({"table", results(), "--format", "json"}), table);
  EXPECT_EQ(said(again), first);
}

/// Iterations that cannot settle end, and it is said what became of the members.
TEST_F(StudyOfOperations, NamesMembersThatFail) {
  auto const run = said({"run", study(), "-o", results(), "--no-figures", "--set", "integrate.methods=dmv-2", "--set",
                         "integrate.step=0.5", "--set", "ensemble.perturb={momentum={uniform=1.0}}", "--set",
                         "integrate.contraction=false"});
  for (auto const* operations : {"rounding up", "stochastic rounding, exact constants"})
    EXPECT_THAT(run, HasSubstr(std::string(operations) + ", energy: 9 of 12 members are left out because the iteration "
                                                         "did not converge (the first at step 0)"));
}

}  // namespace
}  // namespace brouwer
