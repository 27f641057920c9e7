// The program as a user meets it: exit status and messages of the built binary.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/studies/program.hpp"

namespace brouwer {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr char const* small_study = R"(question = "A toy?"
[system.rigid_body]
[integrate]
methods = ["elliptic-three-constants", "dmv-2"]
step = 0.01
steps = 200
[ensemble]
members = 12
seed = 1
perturb = { momentum = { uniform = 1e-2 } }
[observe]
quantities = ["energy", "state"]
reference = { arithmetic = "float128", members = 2 }
samples = { count = 8 }
[[expect]]
of = "energy"
where = { method = "dmv-2" }
drift = { per_step = [-1e-14, 1e-14] }
)";

/// With a small study in its folder.
struct Program : ProgramTest {
  Program() { write("toy.toml", small_study); }
};

TEST_F(Program, TeachesItself) {
  auto const said = brouwer("--help");
  EXPECT_EQ(said.status, 0);
  for (auto const* word : {"run", "plan", "probe", "check", "baseline", "table", "plot", "report", "fit", "integrate",
                           "list", "Examples", "75"})
    EXPECT_THAT(said.text, HasSubstr(word));
  EXPECT_THAT(brouwer("run --help").text, HasSubstr("--members"));
  EXPECT_THAT(brouwer("--version").text, StartsWith("brouwer "));
}

/// A walk, noise and a wave that all share, of which the likelihood has two minima in the ratio of noise to walk: the
/// search for an interval once began in the wrong one, and did not end.
TEST_F(Program, FitsWhereTheLikelihoodHasTwoMinima) {
  auto const said =
      shell("timeout 60 " + std::string(BROUWER_PROGRAM) + " fit " BROUWER_SOURCE "/tests/studies/two_minima.csv");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("noise ν"));
}

struct Wrong {
  char const* arguments;
  char const* expected;
};

TEST_F(Program, RefusesWrongUsageWithOneSentenceAndStatusTwo) {
  Wrong const usages[] = {
      {"", "expected a subcommand"},
      {"rum toy.toml", "there is no subcommand 'rum'; did you mean 'run'?"},
      {"run", "study is required"},
      {"--bogus", "there is no option '--bogus'"},
      {"run toy.toml --membrs 3", "there is no option '--membrs' of 'brouwer run'; did you mean '--members'?"},
      {"run toy.toml other.toml", "unexpected argument 'other.toml'"},
      {"run nowhere.toml", "nowhere.toml: cannot be read"},
      {"run .", "is a folder"},
      {"run toy.toml --members 0", "--members 0: ensemble.members = 0, expected a whole number"},
      {"run toy.toml --members many", "--members many: ensemble.members = 'many'"},
      {"run toy.toml --steps 3", "--steps 3: integrate.steps gives 3 steps"},
      {"run toy.toml --threads 0", "--threads"},
      {"run toy.toml --threads x", "--threads"},
      {"run toy.toml --level 2", "--level 2: expected a number between 0 and 1"},
      {"run toy.toml --confidence nan", "expected a number between 0 and 1"},
      {"run toy.toml --set nonsense", "--set nonsense: expected KEY=VALUE"},
      {"run toy.toml --set integrate.step=-1", "--set integrate.step=-1: integrate.step = -1, expected"},
      {"run toy.toml -o toy.toml", "toy.toml"},
      {"plan toy.toml --set observe.quantities=enrgy", "there is no quantity 'enrgy'"},
      {"probe toy.toml --members 1", "--members"},
      {"probe toy.toml --windows 1", "--windows"},
      {"probe toy.toml --length 2", "--length"},
      {"probe toy.toml --format jsn", "a probe has no format 'jsn'; did you mean 'json'?"},
      {"probe toy.toml -o nowhere", "nowhere: no results of toy there"},
      {"probe toy.toml --set integrate.arithmetic=float128 --set observe.reference.arithmetic=mpfr-256",
       "float128 is not probed"},
      {"table nowhere", "nowhere"},
      {"table . --format txet", "text"},
      {"check nowhere", "nowhere: cannot be read"},
      {"check .", "study.toml: cannot be read"},
      {"fit nowhere.csv", "nowhere.csv"},
      {"fit toy.toml", "toy.toml"},
      {"integrate toy.toml --member 12", "--member 12: the study has members 0 to 11"},
      {"integrate toy.toml --member -1", "--member"},
      {"integrate toy.toml --every 0", "--every"},
      {"integrate toy.toml --method dmv2", "--method dmv2: integrate.methods: there is no method 'dmv2'"},
      {"integrate toy.toml --step nan", "--step nan: integrate.step = nan, expected a finite number"},
      {"integrate toy.toml --coefficients per-stpe",
       "--coefficients per-stpe: integrate.coefficients: there is no level of coefficients 'per-stpe'"},
      {"integrate toy.toml --coefficient per-step", "did you mean '--coefficients'?"},
      {"list system", "there is no list of 'system'; did you mean 'systems'?"},
      {"completion fish", "there is no completion for 'fish'"},
  };
  for (auto const& [arguments, expected] : usages) {
    auto const said = brouwer(arguments);
    EXPECT_EQ(said.status, 2) << arguments << "\n" << said.text;
    EXPECT_THAT(said.text, HasSubstr(expected)) << arguments;
    EXPECT_THAT(said.text, HasSubstr("brouwer: ")) << arguments;
  }
  EXPECT_FALSE(fs::exists(folder / "results"));
}

TEST_F(Program, RunsAStudyAndDoesNotRunItTwice) {
  auto const first = brouwer("run toy.toml --no-figures");
  EXPECT_EQ(first.status, 0) << first.text;
  for (auto const* word : {"A toy?", "elliptic-three-constants", "float128, for 2 members", "PASS", "results/toy"})
    EXPECT_THAT(first.text, HasSubstr(word));
  auto const unit = folder / "results/toy/units";
  auto const written = fs::last_write_time(unit);
  EXPECT_EQ(brouwer("run toy.toml --no-figures").text, first.text);
  EXPECT_EQ(fs::last_write_time(unit), written);
}

TEST_F(Program, KeepsAChangedStudyApart) {
  EXPECT_EQ(brouwer("run toy.toml --no-figures --members 4").status, 0);
  EXPECT_EQ(brouwer("run toy.toml --no-figures --members 5").status, 0);
  auto const folders = std::distance(fs::directory_iterator(folder / "results"), fs::directory_iterator());
  EXPECT_EQ(folders, 2);
  auto const mixed = brouwer("run toy.toml --no-figures --members 4 -o results/toy && " BROUWER_PROGRAM
                             " run toy.toml --no-figures -o results/toy");
  EXPECT_EQ(mixed.status, 2) << mixed.text;
  EXPECT_THAT(mixed.text, HasSubstr("members"));
}

TEST_F(Program, ChecksExpectations) {
  EXPECT_EQ(brouwer("check toy.toml --junit outcome.xml").status, 0);
  EXPECT_TRUE(fs::exists(folder / "outcome.xml"));
  EXPECT_EQ(brouwer("check results/toy").status, 0);
  std::string failing = small_study;
  failing.replace(failing.find("[-1e-14, 1e-14]"), 15, "[1e-3, 2e-3]");
  write("failing.toml", failing);
  auto const said = brouwer("check failing.toml");
  EXPECT_EQ(said.status, 1);
  EXPECT_THAT(said.text, HasSubstr("FAIL"));
}

TEST_F(Program, ChecksWhatTheExpectationsRestOn) {
  std::string alike = small_study;
  alike.replace(alike.find("uniform = 1e-2"), 14, "uniform = 1e-30");
  write("alike.toml", alike);
  auto const said = brouwer("check alike.toml --junit outcome.xml");
  EXPECT_EQ(said.status, 1);
  EXPECT_THAT(said.text, HasSubstr("FAIL  dmv-2, double, h = 0.01: the members differ"));
  EXPECT_THAT(said.text, HasSubstr("PASS  the state has moved"));
  EXPECT_THAT(said.text, Not(HasSubstr("elliptic-three-constants, double, h = 0.01: the members differ")))
      << "nothing is expected of it";
  EXPECT_THAT(shell("cat outcome.xml").text, HasSubstr("<failure message=\"11 of 12 members are copies of others"));
  EXPECT_THAT(brouwer("run alike.toml --no-figures").text,
              HasSubstr("FAIL  dmv-2, double, h = 0.01: the members differ"));
  EXPECT_EQ(brouwer("report results/alike -o page.md").status, 0);
  EXPECT_THAT(shell("cat page.md").text, HasSubstr("the members differ"));
}

TEST_F(Program, RecordsABaselineAndComparesWithIt) {
  auto const said = brouwer("baseline toy.toml -o new/toy.json --label first");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("Recorded 'first' in new/toy.json: "));
  auto const same = brouwer("check toy.toml --baseline new/toy.json --junit outcome.xml");
  EXPECT_EQ(same.status, 0) << same.text;
  EXPECT_THAT(same.text,
              HasSubstr("PASS  energy, dmv-2, double, h = 0.01: not worse than 'first'\n        found the same bits"));
  EXPECT_THAT(shell("cat outcome.xml").text, HasSubstr("not worse than &#39;first&#39;\"><system-out>the same bits"));
  auto const again = brouwer("baseline results/toy -o new/toy.json --label first");
  EXPECT_THAT(again.text, HasSubstr("Already recorded, bit for bit, as 'first'"));
  EXPECT_EQ(brouwer("baseline toy.toml --set ensemble.seed=2 -o new/toy.json --label second --date 1997-05-27").status,
            0);
  auto const list = brouwer("baseline --list new/toy.json");
  EXPECT_THAT(list.text, StartsWith("toy: 2 entries"));
  EXPECT_THAT(list.text, HasSubstr("second, 1997-05-27"));
  auto const first = brouwer("check toy.toml --baseline new/toy.json --entry first");
  EXPECT_THAT(first.text, HasSubstr("the same bits"));
  auto const other = brouwer("check toy.toml --baseline new/toy.json");
  EXPECT_THAT(other.text, HasSubstr("the baseline's study is not quite this one: seed was 2 there and is 1 here"));
  EXPECT_THAT(other.text, HasSubstr("equal within sampling error: "));
}

TEST_F(Program, FailsAgainstABaselineThatWasBetter) {
  ASSERT_EQ(brouwer("baseline toy.toml -o toy.json --label before").status, 0);
  auto const said = brouwer("check toy.toml --baseline toy.json --set integrate.methods=dmv-2");
  EXPECT_EQ(said.status, 1) << said.text;
  EXPECT_THAT(said.text,
              HasSubstr("FAIL  energy, elliptic-three-constants, double, h = 0.01: not worse than 'before'"));
  EXPECT_THAT(said.text, HasSubstr("it was recorded, and is not there any more"));
}

TEST_F(Program, RefusesBaselinesThatCannotBe) {
  ASSERT_EQ(brouwer("baseline toy.toml -o toy.json --label before").status, 0);
  auto const recorded = shell("cat toy.json").text;
  Wrong const usages[] = {
      {"baseline", "expected a study or a folder of results to record, or --list FILE"},
      {"baseline toy.toml", "expected -o FILE.json"},
      {"baseline toy.toml --list toy.json", "--list shows a file, and records nothing"},
      {"baseline --list nowhere.json", "there is no baseline nowhere.json"},
      {"baseline --list toy.toml", "toy.toml:1: is no JSON"},
      {"baseline toy.toml -o toy.toml", "toy.toml:1: is no JSON"},
      {"baseline toy.toml -o toy.json --label before --set ensemble.seed=3",
       "there is an entry 'before' already, of other"},
      {"baseline toy.toml -o toy.json --label x --set observe.samples.count=7",
       "recorded of another study: samples was 8, log"},
      {"baseline results/toy -o toy.json --members 3", "belong to a study file"},
      {"baseline toy.toml -o /proc/new/toy.json", "/proc/new"},
      {"check toy.toml --baseline nowhere.json", "there is no baseline nowhere.json"},
      {"check toy.toml --baseline toy.json --entry befor", "no entry 'befor'; did you mean 'before'?"},
      {"check toy.toml --entry before", "--entry names an entry of a baseline"},
      {"check toy.toml --baseline toy.json --set 'ensemble.perturb={momentum={uniform=0.5}}'",
       "perturb.momentum was uniform 0.01 there and is uniform 0.5 here"},
  };
  for (auto const& [arguments, expected] : usages) {
    auto const said = brouwer(arguments);
    EXPECT_EQ(said.status, 2) << arguments << "\n" << said.text;
    EXPECT_THAT(said.text, HasSubstr(expected)) << arguments;
  }
  EXPECT_EQ(shell("cat toy.json").text, recorded);
}

TEST_F(Program, NamesABaselinesEntryAfterTheCommit) {
  shell("git init -q . && git -c user.name=n -c user.email=e commit -q --allow-empty -m first");
  EXPECT_THAT(brouwer("baseline toy.toml -o toy.json").text,
              testing::ContainsRegex("Recorded '0\\.1\\.0 at [0-9a-f]{12}' in"));
}

TEST_F(Program, FitsHdf5FilesAndSaysWhatIsDoubtful) {
  ASSERT_EQ(brouwer("run toy.toml --no-figures").status, 0);
  auto const unit =
      brouwer("fit results/toy/units/cell-000/members-000000.h5 --dataset errors/energy --format csv 2>&1");
  EXPECT_EQ(unit.status, 0) << unit.text;
  EXPECT_THAT(unit.text, HasSubstr("rigid_body,elliptic-three-constants,double"));
  write("sizes.csv", "t,a,b,c,d\n1,0.1,0.9,0.3,2\n2,2,0.3,1,0.1\n4,0.1,3,2,0.3\n");
  EXPECT_THAT(brouwer("fit sizes.csv").text, HasSubstr("brouwer: error: no error is negative"));
  EXPECT_EQ(brouwer("fit sizes.csv --dataset x").status, 2);
  EXPECT_EQ(brouwer("fit sizes.csv --relative-to-start").status, 0);
  EXPECT_EQ(brouwer("fit sizes.csv --relative-to-start --subtract-start").status, 2);
}

TEST_F(Program, PrintsTablesForProgramsOnly) {
  ASSERT_EQ(brouwer("run toy.toml --no-figures").status, 0);
  EXPECT_THAT(brouwer("table results/toy --format json").text, StartsWith("["));
  EXPECT_THAT(brouwer("table results/toy --format latex").text, HasSubstr("tabular"));
  EXPECT_EQ(brouwer("table results/toy > /dev/full").status, 3);
}

TEST_F(Program, NamesADamagedUnit) {
  ASSERT_EQ(brouwer("run toy.toml --no-figures").status, 0);
  for (auto const& entry : fs::recursive_directory_iterator(folder / "results/toy/units"))
    if (entry.path().extension() == ".h5") fs::resize_file(entry.path(), 100);
  auto const said = brouwer("table results/toy");
  EXPECT_EQ(said.status, 3) << said.text;
  EXPECT_THAT(said.text, HasSubstr(".h5"));
}

TEST_F(Program, SaysWhereItCannotWrite) {
  auto const said = brouwer("run toy.toml -o /proc/brouwer");
  EXPECT_EQ(said.status, 2) << said.text;
  EXPECT_THAT(said.text, HasSubstr("/proc/brouwer"));
}

TEST_F(Program, StopsWhenAskedToAndResumes) {
  auto const said = shell(BROUWER_PROGRAM
                          " run toy.toml --no-figures --steps 100000000 --members 4000 -o long >/dev/null & "
                          "until [ -e long/plan.txt ]; do sleep 0.05; done; kill -INT $!; wait $!; echo status $?");
  EXPECT_THAT(said.text, HasSubstr("status 75"));
  EXPECT_THAT(said.text, HasSubstr("interrupted: 0 of"));
  EXPECT_THAT(said.text, HasSubstr("the same command resumes"));
  EXPECT_TRUE(fs::exists(folder / "long/study.toml"));
}

TEST_F(Program, IntegratesOneTrajectory) {
  auto const said = brouwer("integrate toy.toml --method dmv-2 --steps 20 --every 10 2>/dev/null");
  EXPECT_THAT(said.text, StartsWith("t,y1,y2,y3,q0,q1,q2,q3,energy"));
  EXPECT_EQ(std::count(said.text.begin(), said.text.end(), '\n'), 4);
  EXPECT_THAT(brouwer("integrate toy.toml --steps 1 --hex").text,
              HasSubstr("\n0x0p+0,0x1.ccccccccccccdp+0,0x1.999999999999ap-2,-0x1.ccccccccccccdp-1,0x1p+0,"));
  EXPECT_THAT(brouwer("integrate toy.toml --steps 1 --coefficients per-trajectory").text,
              HasSubstr("is a level of none of the methods elliptic-three-constants, dmv-2"));
  EXPECT_NE(brouwer("integrate toy.toml --steps 1").text, brouwer("integrate toy.toml --steps 1 --member 0").text);
}

TEST_F(Program, EndsQuietlyWhereNobodyReadsOn) {
  auto const said = shell(BROUWER_PROGRAM " integrate toy.toml --steps 1000000 | head -n 1");
  EXPECT_EQ(std::count(said.text.begin(), said.text.end(), '\n'), 1) << said.text;
}

TEST_F(Program, PlansWithoutWriting) {
  auto const said = brouwer("plan toy.toml");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("smallest visible drift"));
  EXPECT_FALSE(fs::exists(folder / "results"));
}

TEST_F(Program, SaysWhatItTakesToSeeADrift) {
  auto const said = brouwer("plan toy.toml --drift 1e-19");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("to see 1.0e-19 per step: "));
  EXPECT_THAT(said.text, HasSubstr("to exclude ±1.0e-19: 12 members over "));
  EXPECT_EQ(brouwer("plan toy.toml --drift 0").status, 2);
}

TEST_F(Program, SetsObservationBesidePrediction) {
  auto const alone = brouwer("probe toy.toml");
  EXPECT_EQ(alone.status, 0) << alone.text;
  EXPECT_THAT(alone.text, AllOf(HasSubstr("drift β"), Not(HasSubstr("observed"))));
  EXPECT_FALSE(fs::exists(folder / "results"));
  auto const beside = brouwer("probe toy.toml --run");
  EXPECT_EQ(beside.status, 0) << beside.text;
  EXPECT_THAT(beside.text, AllOf(HasSubstr("observed"), HasSubstr("The run")));
  EXPECT_THAT(brouwer("probe toy.toml --format json").text, HasSubstr("\"diffusion_agreement\""));
  EXPECT_THAT(brouwer("probe toy.toml -o results/toy --set ensemble.seed=3").text, HasSubstr("results/toy: "));
}

TEST_F(Program, GivesTheSameUnitsInAnyLanes) {
  ASSERT_EQ(brouwer("run toy.toml --no-figures --lanes none -o one").status, 0);
  ASSERT_EQ(brouwer("run toy.toml --no-figures -o widest").status, 0);
  EXPECT_EQ(shell("cd " + folder.string() + " && diff -r one/units widest/units").status, 0);
  EXPECT_THAT(brouwer("run toy.toml --lanes avx9").text, HasSubstr("no instruction set 'avx9'; did you mean 'avx2'?"));
}

TEST_F(Program, CompletesInShells) {
  EXPECT_EQ(shell("bash -c 'source <(" BROUWER_PROGRAM " completion bash) && complete -p brouwer'").status, 0);
  EXPECT_THAT(brouwer("completion zsh").text, StartsWith("#compdef brouwer"));
  EXPECT_THAT(brouwer("completion bash").text, HasSubstr(" --coefficients "));
}

}  // namespace
}  // namespace brouwer
