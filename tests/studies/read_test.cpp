// A study file becomes plain data; whatever is wrong in it is refused with its place and what was expected.
#include "studies/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <brouwer/error.hpp>
#include <filesystem>
#include <fstream>

#include "tests/studies/small_catalogue.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr char const* good = R"(question = "Does it drift?"
source = "someone"
[system.rigid_body]
momentum = [1.8, 0.4, -0.9]
[integrate]
methods = ["elliptic-naive", "dmv-2"]
arithmetic = "double"
step = [0.04, 0.02, 0.01]
steps = 100_000
[ensemble]
members = 1000
seed = 2008
perturb = { momentum = { uniform = 1e-2 } }
[observe]
quantities = ["energy", "state"]
reference = { arithmetic = "float128", members = 8 }
samples = { count = 32, spacing = "linear" }
[[expect]]
of = "energy"
where = { method = "dmv-2" }
drift = "none"
growth = { exponent = 0.5, within = 0.05 }
[[expect]]
of = "energy"
where = { method = "elliptic-naive", step = 0.01 }
drift = { per_step = [-3e-17, -1.5e-17] }
verdict = "drift"
level = 0.01
)";

StudyFile read(std::string const& text, std::vector<Override> const& overrides = {}) {
  return parse_study(text, "drift.toml", small_catalogue(), overrides);
}

/// The complaint about a text, or "".
std::string complaint(std::string const& text, std::vector<Override> const& overrides = {}) {
  try {
    read(text, overrides);
  } catch (InputError const& error) {
    return error.what();
  }
  return "";
}

/// `good` with the first occurrence of a text replaced.
std::string with(std::string const& before, std::string const& after) {
  std::string text = good;
  auto const at = text.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return text.replace(at, before.size(), after);
}

TEST(StudyFile, IsReadToPlainData) {
  auto const file = read(good);
  Study const& study = file.study;
  EXPECT_EQ(study.name, "drift");
  EXPECT_EQ(study.question, "Does it drift?");
  EXPECT_EQ(study.system, "rigid_body");
  EXPECT_THAT(study.values.at("momentum"), ElementsAre(1.8, 0.4, -0.9));
  EXPECT_THAT(study.methods, ElementsAre("elliptic-naive", "dmv-2"));
  EXPECT_THAT(study.step, ElementsAre(0.04, 0.02, 0.01));
  EXPECT_EQ(study.steps, 100'000);
  EXPECT_EQ(study.members, 1000);
  EXPECT_EQ(study.seed, 2008U);
  EXPECT_EQ(study.perturb.at("momentum"), (Perturbation{Perturbation::Law::uniform, 1e-2}));
  EXPECT_EQ(study.reference.kind, Reference::Kind::same_method);
  EXPECT_EQ(study.reference.arithmetic, "float128");
  EXPECT_EQ(study.reference.members, 8);
  EXPECT_EQ(study.samples.count, 32);
  EXPECT_EQ(study.samples.spacing, Samples::Spacing::linear);
}

TEST(StudyFile, TakesWhatIsLeftOutFromTheCatalogueAndTheDefaults) {
  auto const file = read(with("seed = 2008\n", ""));
  EXPECT_THAT(file.study.values.at("inertia"), ElementsAre(0.6, 0.8, 1.0));
  EXPECT_THAT(file.study.special_functions, ElementsAre("own"));
  EXPECT_THAT(file.study.coefficients, IsEmpty()) << "each method's first level";
  EXPECT_THAT(file.study.compensation, ElementsAre(false));
  EXPECT_EQ(file.study.seed, 0U);
}

TEST(StudyFile, ObservesEverythingThatItsReferenceAllowsUnlessToldOtherwise) {
  EXPECT_THAT(read(with("quantities = [\"energy\", \"state\"]", "")).study.quantities,
              ElementsAre("energy", "spatial-momentum", "state"));
}

TEST(StudyFile, ReadsExpectations) {
  auto const expectations = read(good).expectations;
  ASSERT_EQ(expectations.size(), 2U);
  EXPECT_EQ(expectations[0].drift, Expectation::DriftWanted::none);
  EXPECT_EQ(expectations[0].where.method, "dmv-2");
  EXPECT_EQ(expectations[0].growth->within, 0.05);
  EXPECT_EQ(expectations[0].line, 18);
  EXPECT_EQ(expectations[1].drift, Expectation::DriftWanted::band);
  EXPECT_EQ(expectations[1].drift_band.low, -3e-17);
  EXPECT_EQ(expectations[1].where.step, 0.01);
  EXPECT_THAT(expectations[1].verdict, ElementsAre("drift"));
  EXPECT_EQ(expectations[1].level, 0.01);
}

TEST(StudyFile, TakesShortFormsAndHyphens) {
  EXPECT_EQ(read(with(R"({ arithmetic = "float128", members = 8 })", "\"exact\"")).study.reference.kind,
            Reference::Kind::exact);
  EXPECT_EQ(read(with(R"({ arithmetic = "float128", members = 8 })", "\"float128\"")).study.reference.members, 16);
  EXPECT_THAT(read(with("step = [", "special-functions = \"gsl\"\nstep = [")).study.special_functions,
              ElementsAre("gsl"));
  EXPECT_EQ(read(with("steps = 100_000", "steps = 1e5")).study.steps, 100'000);
}

/// A study of methods one of which has coefficients.
std::string with_coefficients(std::string const& levels) {
  auto text = with("step = [", "coefficients = " + levels + "\nstep = [");
  return text.replace(text.find("\"dmv-2\"]"), 8, "\"dmv-2\", \"dmv-10\"]");
}

TEST(StudyFile, TakesOneOrAListOfCoefficientsAndExpectsOfThem) {
  auto const one = with_coefficients("\"per-trajectory\"");
  EXPECT_THAT(read(one).study.coefficients, ElementsAre("per-trajectory"));
  auto text = with_coefficients("[\"per-step\", \"per-trajectory\"]");
  std::string const selector = "where = { method = \"dmv-2\" }";
  text.replace(text.find(selector), selector.size(), "where = { coefficients = \"per-trajectory\" }");
  auto const file = read(text);
  EXPECT_THAT(file.study.coefficients, ElementsAre("per-step", "per-trajectory"));
  EXPECT_EQ(file.plan.cells.size(), 4 * 3);  // dmv-10 twice, the others once, with three steps each
  EXPECT_EQ(file.expectations[0].where.coefficients, "per-trajectory");
}

TEST(StudyFile, SurvivesAByteOrderMarkAndWindowsLines) {
  std::string text;
  for (char c : std::string(good)) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(canonical_text(read("\xEF\xBB\xBF" + text).study), canonical_text(read(good).study));
}

struct Bad {
  char const* name;
  char const* before;
  char const* after;
  char const* expected;  ///< a part of the complaint
};
std::ostream& operator<<(std::ostream& out, Bad const& bad) { return out << bad.name; }

struct BadStudy : testing::TestWithParam<Bad> {};

TEST_P(BadStudy, IsRefusedWithItsPlace) {
  auto const& [name, before, after, expected] = GetParam();
  EXPECT_THAT(complaint(with(before, after)), HasSubstr(expected));
}

Bad const bad_studies[] = {
    {"NoToml", "question =", "question", "drift.toml:1:"},
    {"KeyTwice", "seed = 2008", "seed = 1\nseed = 2", "drift.toml:13:"},
    {"UnknownTable", "[observe]", "[obsrve]", "drift.toml:14: unknown key 'obsrve'; did you mean 'observe'?"},
    {"UnknownKey", "seed = 2008", "sede = 2008", "drift.toml:12: unknown key 'ensemble.sede'; did you mean 'seed'?"},
    {"UnknownKeyAtTheTop", "source =", "sauce =", "drift.toml:2: unknown key 'sauce'; did you mean 'source'?"},
    {"UnknownKeyInATable", "count = 32", "count = 32, spaces = 1", "unknown key 'observe.samples.spaces'"},
    {"HyphenAndUnderscore", "step = [", "special-functions = \"own\"\nspecial_functions = \"own\"\nstep = [",
     "is given twice"},
    {"QuestionOfNumbers", "\"Does it drift?\"", "7", "drift.toml:1: question = 7, expected a text in quotes"},
    {"NoSystem", "[system.rigid_body]\nmomentum = [1.8, 0.4, -0.9]", "", "expected one table [system.NAME], found 0"},
    {"TwoSystems", "[integrate]", "[system.pendulum]\n[integrate]", "expected one table [system.NAME], found 2"},
    {"UnknownSystem", "rigid_body", "rigid_bodi", "drift.toml:3: system.rigid_bodi: there is no system 'rigid_bodi'"},
    {"SystemIsNoTable", "[system.rigid_body]\nmomentum = [1.8, 0.4, -0.9]", "system = 3", "expected a table"},
    {"UnknownField", "momentum = [1.8", "momentun = [1.8", "unknown key 'system.rigid_body.momentun'"},
    {"FieldMissing", "momentum = [1.8, 0.4, -0.9]", "",
     "'system.rigid_body.momentum' is missing, expected a list of 3 finite numbers"},
    {"FieldTooShort", "[1.8, 0.4, -0.9]", "[1.8, 0.4]",
     "drift.toml:4: system.rigid_body.momentum = [ 1.8, 0.4 ], expected"},
    {"FieldOfTexts", "[1.8, 0.4, -0.9]", "[1.8, 0.4, 'x']", "expected a list of 3 finite numbers"},
    {"FieldNotFinite", "[1.8, 0.4, -0.9]", "[1.8, nan, inf]", "expected a list of 3 finite numbers"},
    {"FieldIsScalar", "[1.8, 0.4, -0.9]", "1.8", "expected a list of 3 finite numbers"},
    {"InertiaUnsorted", "momentum = [1", "inertia = [1, 0.8, 0.6]\nmomentum = [1",
     "drift.toml:3: inertia must be positive"},
    {"InertiaNegative", "momentum = [1", "inertia = [-1, 0.8, 1]\nmomentum = [1",
     "inertia must be positive and sorted"},
    {"NoMethods", "methods = [\"elliptic-naive\", \"dmv-2\"]", "", "'integrate.methods' is missing"},
    {"UnknownMethod", "\"elliptic-naive\", \"dmv-2\"", "\"eliptic-naive\"",
     "drift.toml:6: integrate.methods: there is no method 'eliptic-naive'; did you mean 'elliptic-naive'?"},
    {"MethodOfAnotherSystem", "\"dmv-2\"]", "\"leapfrog\"]", "'leapfrog' is a method of pendulum, not of rigid_body"},
    {"MethodTwice", "\"dmv-2\"]", "\"dmv-2\", \"dmv-2\"]", "integrate.methods has 'dmv-2' twice"},
    {"MethodsEmpty", "[\"elliptic-naive\", \"dmv-2\"]", "[]", "integrate.methods is empty, expected at least one"},
    {"MethodIsNumber", "[\"elliptic-naive\", \"dmv-2\"]", "2", "integrate.methods = 2, expected a name in quotes"},
    {"UnknownArithmetic", "arithmetic = \"double\"", "arithmetic = \"duoble\"", "there is no arithmetic 'duoble'"},
    {"UnknownVariant", "step = [", "special_functions = \"nag\"\nstep = [", "there is no variant 'nag'; known are own"},
    {"UnknownCoefficients", "step = [", "coefficients = \"per-stpe\"\nstep = [",
     "drift.toml:8: integrate.coefficients: there is no level of coefficients 'per-stpe'; did you mean 'per-step'?"},
    {"CoefficientsAreNumber", "step = [", "coefficients = 1\nstep = [",
     "integrate.coefficients = 1, expected a name in quotes, one of per-step, per-trajectory"},
    {"CoefficientsTwice", "step = [", "coefficients = ['per-step', 'per-step']\nstep = [",
     "integrate.coefficients has 'per-step' twice"},
    {"CoefficientsMisspelt", "step = [", "coeficients = 'per-step'\nstep = [", "did you mean 'coefficients'?"},
    {"CompensationIsWord", "step = [", "compensation = \"on\"\nstep = [", "expected true or false"},
    {"NoStep", "step = [0.04, 0.02, 0.01]", "", "'integrate.step' is missing"},
    {"StepZero", "[0.04, 0.02, 0.01]", "0.0", "drift.toml:8: integrate.step = 0.0, expected a finite number greater"},
    {"StepNegative", "[0.04, 0.02, 0.01]", "[0.01, -0.01]", "integrate.step = -0.01, expected a finite number"},
    {"StepNaN", "[0.04, 0.02, 0.01]", "nan", "integrate.step = nan, expected a finite number"},
    {"StepInfinite", "[0.04, 0.02, 0.01]", "inf", "integrate.step = inf, expected a finite number"},
    {"StepIsDate", "[0.04, 0.02, 0.01]", "1979-05-27", "expected a finite number greater than 0"},
    {"StepTwice", "[0.04, 0.02, 0.01]", "[0.01, 0.01]", "integrate.step has 0.01 twice"},
    {"StepListsNested", "[0.04, 0.02, 0.01]", "[[0.01]]", "expected a finite number greater than 0"},
    {"BothLengths", "steps = 100_000", "steps = 100_000\nuntil = 10", "both integrate.steps and integrate.until"},
    {"NoLength", "steps = 100_000", "", "neither integrate.steps nor integrate.until"},
    {"StepsZero", "steps = 100_000", "steps = 0", "drift.toml:9: integrate.steps = 0, expected a whole number from 1"},
    {"StepsBroken", "steps = 100_000", "steps = 10.5", "integrate.steps = 10.5, expected a whole number"},
    {"StepsBeyondReason", "steps = 100_000", "steps = 1_000_000_000_000_001", "expected a whole number from 1"},
    {"FewerStepsThanSamples", "steps = 100_000", "steps = 31", "drift.toml:9: integrate.steps gives 31 steps"},
    {"UntilTooFar", "steps = 100_000", "until = 1e300", "drift.toml:9: integrate.until needs"},
    {"UntilNegative", "steps = 100_000", "until = -1", "expected a finite number greater than 0"},
    {"UntilTooShort", "steps = 100_000", "until = 0.1", "fewer than the 32 samples of observe.samples.count"},
    {"MembersZero", "members = 1000", "members = 0",
     "drift.toml:11: ensemble.members = 0, expected a whole number from 1 to"},
    {"MembersTooMany", "members = 1000", "members = 1_000_000_001", "expected a whole number from 1 to 1000000000"},
    {"MembersIsText", "members = 1000", "members = '1000'", "ensemble.members = '1000', expected a whole number"},
    {"SeedNegative", "seed = 2008", "seed = -1", "drift.toml:12: ensemble.seed = -1, expected a whole number from 0"},
    {"SeedBeyondInteger", "seed = 2008", "seed = 99999999999999999999", "drift.toml:12:"},
    {"PerturbUnknownField", "{ momentum = {", "{ momentu = {", "unknown key 'ensemble.perturb.momentu'; did you mean"},
    {"PerturbUnknownLaw", "uniform = 1e-2", "uniforn = 1e-2", "unknown key 'ensemble.perturb.momentum.uniforn'"},
    {"PerturbTwoLaws", "uniform = 1e-2", "uniform = 1e-2, ulps = 1", "expected one of uniform, normal, ulps"},
    {"PerturbNoLaw", "{ uniform = 1e-2 }", "{}", "expected one of uniform, normal, ulps"},
    {"PerturbNegative", "uniform = 1e-2", "uniform = -1", "expected a finite number greater than 0"},
    {"PerturbHalfAnUlp", "uniform = 1e-2", "ulps = 0.5", "expected a whole number from 1"},
    {"PerturbIsNumber", "{ uniform = 1e-2 }", "1", "ensemble.perturb.momentum = 1, expected a table"},
    {"NothingPerturbed", "perturb = { momentum = { uniform = 1e-2 } }", "", "all 1000 members would be the same"},
    {"UnknownQuantity", "\"energy\", \"state\"", "\"enrgy\"", "there is no quantity 'enrgy'; did you mean 'energy'?"},
    {"ReferenceMissing", "reference = {", "#", "'state' is an error against a reference"},
    {"UnknownReference", "reference = { arithmetic = \"float128\"", "reference = { arithmetic = \"quad\"",
     "there is no reference 'quad'"},
    {"ReferenceTooNarrow", "reference = { arithmetic = \"float128\"", "reference = { arithmetic = \"double\"",
     "'double' (53 bits) is not wider than 'double' (53 bits)"},
    {"ReferenceOfNobody", "members = 8", "members = 0",
     "observe.reference.members = 0, expected a whole number from 1"},
    {"SamplesZero", "count = 32", "count = 0",
     "drift.toml:17: observe.samples.count = 0, expected a whole number from 1"},
    {"UnknownSpacing", "\"linear\"", "\"lineal\"", "there is no spacing 'lineal'; did you mean 'linear'?"},
    {"ExpectIsOneTable",
     "[[expect]]\nof = \"energy\"\nwhere = { method = \"dmv-2\" }\ndrift = \"none\"\ngrowth = { "
     "exponent = 0.5, within = 0.05 }\n[[expect]]",
     "[expect]", "expected tables [[expect]]"},
    {"ExpectOfNothing", "[[expect]]\nof = \"energy\"", "[[expect]]", "'expect[1].of' is missing"},
    {"ExpectOfUnknown", "of = \"energy\"", "of = \"enrgy\"",
     "drift.toml:19: expect[1].of: there is no quantity 'enrgy'"},
    {"ExpectOfUnobserved", "of = \"energy\"", "of = \"spatial-momentum-1\"",
     "drift.toml:18: [[expect]] 'spatial-momentum-1' is not observed by this study"},
    {"ExpectUnknownKey", "drift = \"none\"", "drif = \"none\"", "unknown key 'expect[1].drif'; did you mean 'drift'?"},
    {"ExpectUnknownMethod", "{ method = \"dmv-2\" }", "{ method = \"dmv2\" }",
     "expect[1].where.method: there is no method"},
    {"ExpectLevelNotRun", "{ method = \"dmv-2\" }", "{ arithmetic = \"float\" }",
     "where.arithmetic = float is not run by this study, run are double"},
    {"ExpectUnknownCoefficients", "{ method = \"dmv-2\" }", "{ coefficients = \"per-member\" }",
     "expect[1].where.coefficients: there is no level of coefficients 'per-member'"},
    {"ExpectCoefficientsNotRun", "{ method = \"dmv-2\" }", "{ coefficients = \"per-trajectory\" }",
     "where.coefficients = per-trajectory is not run by this study, run are -"},
    {"ExpectStepNotRun", "step = 0.01 }", "step = 0.03 }", "where.step = 0.03 is not run by this study"},
    {"ExpectClaimsNothing", "drift = \"none\"\ngrowth = { exponent = 0.5, within = 0.05 }", "",
     "the expectation claims nothing"},
    {"ExpectDriftWord", "drift = \"none\"", "drift = \"little\"", "there is no drift 'little'; known are none"},
    {"ExpectBandReversed", "[-3e-17, -1.5e-17]", "[-1.5e-17, -3e-17]", "expected a list [low, high] with low < high"},
    {"ExpectBandOfOne", "[-3e-17, -1.5e-17]", "[-3e-17]", "expected a list [low, high] with low < high"},
    {"ExpectGrowthWithoutWidth", "exponent = 0.5, within = 0.05", "exponent = 0.5",
     "'expect[1].growth.within' is missing"},
    {"ExpectGrowthIsNumber", "{ exponent = 0.5, within = 0.05 }", "0.5", "expect[1].growth = 0.5, expected a table"},
    {"ExpectWidthNegative", "within = 0.05", "within = -1", "expected a finite number greater than 0"},
    {"ExpectUnknownVerdict", "verdict = \"drift\"", "verdict = \"draft\"",
     "there is no verdict 'draft'; did you mean 'drift'?"},
    {"ExpectLevelOne", "level = 0.01", "level = 1", "expected a number greater than 0 and at most 0.5"},
    {"ExpectSweepOfOne", "level = 0.01", "step_exponent = { exponent = 0.5, within = 0.1 }",
     "step_exponent needs at least three step sizes, this study runs 1 there"},
    {"ControlCharacters", "\"someone\"", "\"a\x01z\"", "drift.toml:2:"},
    {"NoUnicode", "\"someone\"", "\"\xff\xfe\"", "drift.toml:2:"},
};
INSTANTIATE_TEST_SUITE_P(Every, BadStudy, testing::ValuesIn(bad_studies),
                         [](auto const& bad) { return std::string(bad.param.name); });

TEST(StudyFile, NamesEveryMistakeAtOnce) {
  auto text = with("members = 1000", "members = 0");
  text.replace(text.find("count = 32"), 10, "count = 0 ");
  auto const found = complaint(text);
  EXPECT_THAT(found, HasSubstr("ensemble.members"));
  EXPECT_THAT(found, HasSubstr("observe.samples.count"));
}

TEST(StudyFile, NamesAtMostTenMistakes) {
  std::string many;
  for (int i = 0; i < 30; ++i) many += "x" + std::to_string(i) + " = 1\n";
  auto const found = complaint(many + good);
  EXPECT_EQ(std::count(found.begin(), found.end(), '\n'), 10);
  EXPECT_THAT(found, HasSubstr("and 20 more"));
}

TEST(StudyFile, IsRefusedWhereItIsTooLargeOrNestsTooDeeply) {
  EXPECT_THAT(complaint(good + std::string(300'000, '\n')), HasSubstr("larger than 256 KiB"));
  std::string nested = "x = ";
  for (int i = 0; i < 10'000; ++i) nested += "[";
  EXPECT_THAT(complaint(nested), StartsWith("drift.toml:1:"));
  std::string dotted = "a";
  while (dotted.size() < 8'000) dotted += ".a";
  EXPECT_THAT(complaint(dotted + " = 1\n"), HasSubstr("unknown key 'a'"));
  while (dotted.size() < 200'000) dotted += ".a";
  EXPECT_THAT(complaint(dotted + " = 1\n"), HasSubstr("more than 4096 dots"));
}

TEST(StudyFile, IsRefusedWhereTheParserItselfWouldFail) {
  EXPECT_THAT(complaint("a = { b = 1, # c }"), StartsWith("drift.toml"));
  EXPECT_THAT(complaint("a = { # }"), StartsWith("drift.toml"));
  EXPECT_THAT(complaint("[#]"), StartsWith("drift.toml"));
  EXPECT_THAT(complaint("a.# = 1"), StartsWith("drift.toml"));
}

TEST(StudyFile, IsRefusedWhereThereIsNone) {
  auto const complaint_of = [](std::filesystem::path const& file) -> std::string {
    try {
      read_study(file, small_catalogue());
    } catch (InputError const& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(complaint_of("nowhere.toml"), HasSubstr("nowhere.toml: cannot be read"));
  EXPECT_THAT(complaint_of(std::filesystem::temp_directory_path()), HasSubstr("is a folder, expected a study file"));
  EXPECT_THAT(complaint_of("/dev/zero"), HasSubstr("larger than 256 KiB"));
  EXPECT_THAT(complaint_of("/dev/null"), HasSubstr("expected one table [system.NAME]"));
}

TEST(Override, ReplacesAValueBeforeItIsChecked) {
  auto const file = read(with("members = 1000", "members = 0"), {{"ensemble.members", "8", "--members 8"}});
  EXPECT_EQ(file.study.members, 8);
  EXPECT_THAT(file.text, HasSubstr("members = 8"));
  EXPECT_EQ(canonical_text(read(file.text).study), canonical_text(file.study));
}

TEST(Override, OfTheMembersLimitsThoseThatAreCompared) {
  EXPECT_EQ(read(good, {{"ensemble.members", "4", "--members 4"}}).study.reference.members, 4);
}

TEST(Override, IsNamedInComplaints) {
  EXPECT_THAT(complaint(good, {{"ensemble.members", "0", "--members 0"}}),
              StartsWith("--members 0: ensemble.members = 0"));
  EXPECT_THAT(complaint(good, {parse_override("ensemble.membrs=1")}),
              StartsWith("--set ensemble.membrs=1: unknown key 'ensemble.membrs'; did you mean 'members'?"));
}

TEST(Override, TakesTomlAndBareWords) {
  EXPECT_THAT(read(good, {parse_override("integrate.special-functions=gsl")}).study.special_functions,
              ElementsAre("gsl"));
  EXPECT_EQ(read(good, {parse_override("ensemble.perturb.momentum={ulps=4}")}).study.perturb.at("momentum").size, 4);
  EXPECT_THAT(complaint(good, {parse_override("integrate.step=[1")}), HasSubstr("the value is not TOML"));
  EXPECT_THAT(complaint(good, {parse_override("question.part=1")}),
              HasSubstr("'question' is a value there, not a table"));
  for (auto const* malformed : {"", "=", "a", "a=", "=1", "a..b=1", ".=1", "a.b.c.d.e.f.g.h.i=1"})
    EXPECT_THROW(parse_override(malformed), InputError) << malformed;
}

TEST(Override, OfCoefficientsReplacesThoseOfTheFile) {
  auto const text = with_coefficients("\"per-step\"");
  EXPECT_THAT(read(text, {parse_override("integrate.coefficients=per-trajectory")}).study.coefficients,
              ElementsAre("per-trajectory"));
}

TEST(Override, OfALengthReplacesTheOtherLength) {
  auto const study = read(good, {parse_override("integrate.until=10")}).study;
  EXPECT_EQ(study.until, 10);
  EXPECT_FALSE(study.steps);
}

TEST(Override, LeavesOutExpectationsThatItPutsOutOfReach) {
  auto const file =
      parse_study(good, "drift.toml", small_catalogue(), {parse_override("integrate.methods=dmv-2")}, Reach::lenient);
  EXPECT_EQ(file.expectations.size(), 1U);
  ASSERT_EQ(file.unjudged.size(), 1U);
  EXPECT_THAT(file.unjudged.front(), HasSubstr("where.method = elliptic-naive is not run by this study"));
}

}  // namespace
}  // namespace brouwer
