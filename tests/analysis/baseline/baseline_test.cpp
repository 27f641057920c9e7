// A baseline as a file: what is written returns to the same bits, what is damaged is refused with its place.
#include "analysis/baseline/baseline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <brouwer/error.hpp>
#include <cmath>

#include "analysis/baseline/baseline_table.hpp"
#include "analysis/baseline/study_change.hpp"
#include "analysis/growth/inference.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string const study =
    "format = brouwer study 1\nsystem = rigid_body\nsystem.inertia = 0x1p+0\nmethods = dmv-2, dmv-4\nsteps = 1000\n"
    "members = 16\nseed = 1\nperturb.momentum = uniform 0x1p-7\nreference = float128, 4 members\nsamples = 8, log\n";

Ensemble ensemble(unsigned long seed, std::string const& method = "dmv-2") {
  auto e = simulated({.drift = 1e-18, .diffusion = 1e-16}, 16, log_spaced(8, 1000), seed);
  e.cell = {"rigid_body", method, "double", "own", "per-step", true, 0.1, 1000};
  e.errors *= 1.0;
  return e;
}

BaselineRow row(unsigned long seed, std::string const& method = "dmv-2") {
  auto const e = ensemble(seed, method);
  return baseline_row(e, estimate(e, {}));
}

BaselineEntry entry(std::string const& label, unsigned long seed) {
  return {label, "", "hash", study, {{"compiler", "g++ \"12\""}}, {row(seed), row(seed + 1, "dmv-4")}};
}

Baseline history() {
  Baseline baseline{"toy", {}};
  append(baseline, entry("first", 1));
  append(baseline, entry("second", 7));
  return baseline;
}

std::string complaint_of(std::string const& text) {
  try {
    baseline_of_json(text, "b.json");
  } catch (InputError const& error) {
    return error.what();
  }
  return "nothing";
}

std::string replaced(std::string text, std::string const& what, std::string const& by) {
  auto const at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

// --- the row --------------------------------------------------------------------------------------

TEST(BaselineRow, HoldsTheEstimatesAndTheirStandardErrors) {
  auto const e = ensemble(3);
  auto const estimates = estimate(e, {});
  auto const r = baseline_row(e, estimates);
  EXPECT_EQ(r.drift, estimates.drift.per_step);
  EXPECT_NEAR(r.drift / r.slope_error, estimates.drift.t, 1e-9 * std::abs(estimates.drift.t));
  EXPECT_EQ(r.diffusion, estimates.diffusion.per_sqrt_step);
  EXPECT_NEAR(r.increment_size, r.diffusion, 1e-12 * r.diffusion);
  EXPECT_NEAR(r.slope_mean, r.drift, 1e-12 * r.slope_error);
  EXPECT_EQ(r.slopes.size(), 16U);
  EXPECT_NEAR(r.F, r.duration * r.slope_variance / (r.diffusion * r.diffusion), 1e-9 * r.F);
  EXPECT_EQ(r.duration, 1000);
}

TEST(BaselineRow, ItsErrorOfTheDiffusionIsHowEnsemblesDiffer) {
  double sum = 0, squares = 0, said = 0;
  constexpr int ensembles = 400;
  for (unsigned long seed = 1; seed <= ensembles; ++seed) {
    auto const r = row(seed);
    sum += std::log(r.diffusion);
    squares += std::pow(std::log(r.diffusion), 2);
    said += r.increment_log_error / ensembles;
  }
  double const spread = std::sqrt(squares / ensembles - std::pow(sum / ensembles, 2));
  EXPECT_NEAR(said / spread, 1, 0.12);  // three standard errors of a standard deviation of 400
}

TEST(BaselineRow, IsTheSameWhateverTheUnit) {
  auto small = ensemble(3);
  small.errors *= 0x1p-900;
  auto const r = baseline_row(small, estimate(small, {})), usual = row(3);
  EXPECT_EQ(r.slope_error, usual.slope_error * 0x1p-900);
  EXPECT_EQ(r.increment_log_error, usual.increment_log_error);
  EXPECT_EQ(r.slope_spread_error, usual.slope_spread_error * 0x1p-900);
}

TEST(BaselineRow, DigestsDifferInOneBit) {
  auto e = ensemble(3);
  auto const before = digest_of(e);
  EXPECT_EQ(digest_of(ensemble(3)), before);
  e.errors(5, 5) = std::nextafter(e.errors(5, 5), 1);
  EXPECT_NE(digest_of(e), before);
}

// --- the file -------------------------------------------------------------------------------------

TEST(BaselineFile, ReturnsTheSameBits) {
  auto const before = history();
  auto const text = to_json(before);
  auto const after = baseline_of_json(text, "b.json");
  EXPECT_EQ(to_json(after), text);
  auto const& a = before.entry().rows[1];
  auto const& b = after.entry().rows[1];
  EXPECT_EQ(a.cell, b.cell);
  EXPECT_EQ(a.slopes, b.slopes);
  EXPECT_EQ(a.slope_error, b.slope_error);
  EXPECT_TRUE(std::isnan(b.count_mean)) << "null";
  EXPECT_EQ(after.entry().study, study);
  EXPECT_EQ(after.entry().provenance, before.entry().provenance);
}

TEST(BaselineFile, KeepsTheMembersOfItsLastEntryAlone) {
  auto const baseline = history();
  EXPECT_TRUE(baseline.entries[0].rows[0].slopes.empty());
  EXPECT_EQ(baseline.entries[1].rows[0].slopes.size(), 16U);
}

TEST(BaselineFile, FindsEntriesByLabel) {
  auto const baseline = history();
  EXPECT_EQ(baseline.entry().label, "second");
  EXPECT_EQ(baseline.entry("first").label, "first");
  try {
    static_cast<void>(baseline.entry("frist"));
    FAIL();
  } catch (InputError const& error) {
    EXPECT_STREQ(error.what(), "the baseline has no entry 'frist'; did you mean 'first'?");
  }
}

TEST(BaselineFile, TakesAnEntryOnce) {
  auto baseline = history();
  EXPECT_FALSE(append(baseline, entry("second", 7))) << "the same bits";
  EXPECT_THROW(append(baseline, entry("second", 8)), InputError);
  EXPECT_EQ(baseline.entries.size(), 2U);
}

TEST(BaselineFile, TakesNoOtherStudy) {
  auto baseline = history();
  auto other = entry("third", 9);
  other.study = replaced(study, "0x1p-7", "0x1p-3");
  try {
    append(baseline, other);
    FAIL();
  } catch (InputError const& error) {
    EXPECT_THAT(error.what(), HasSubstr("perturb.momentum was uniform 0.0078125 there and is uniform 0.125 here"));
  }
}

struct Damage {
  char const* name;
  char const* what;
  char const* by;
  char const* complaint;
};
void PrintTo(Damage const& damage, std::ostream* out) { *out << damage.name; }
struct DamagedBaseline : testing::TestWithParam<Damage> {};
TEST_P(DamagedBaseline, IsRefusedWithItsPlace) {
  auto const& [name, what, by, complaint] = GetParam();
  EXPECT_THAT(complaint_of(replaced(to_json(history()), what, by)), StartsWith(complaint));
}
INSTANTIATE_TEST_SUITE_P(
    Damages, DamagedBaseline,
    testing::Values(
        Damage{"syntax", "\"entries\": [", "\"entries\": ", "b.json:"},
        Damage{"format", "baseline 1", "baseline 9",
               "b.json: expected the format 'brouwer baseline 1', found 'brouwer baseline 9'"},
        Damage{"no_key", "\"slope_error\"", "\"slope_eror\"", "b.json: entry 1: row 1: 'slope_error' is missing"},
        Damage{"no_number", "\"samples\": 8", "\"samples\": \"many\"",
               "b.json: entry 1: row 1: samples: expected a number, found 'many'"},
        Damage{"half_a_number", "\"duration\": 1000", "\"duration\": \"1000 steps\"",
               "b.json: entry 1: row 1: duration: expected a number, found '1000 steps'"},
        Damage{"no_truth", "\"compensation\": true", "\"compensation\": 3",
               "b.json: entry 1: row 1: compensation: expected true or false, found '3'"},
        Damage{"no_entries_key", "\"entries\"", "\"entires\"", "b.json: 'entries' is missing; is this a baseline?"}),
    [](auto const& one) { return one.param.name; });

TEST(BaselineFile, OfSomethingElseIsRefused) {
  EXPECT_THAT(complaint_of(""), StartsWith("b.json:1: is no JSON"));
  EXPECT_THAT(complaint_of("{}"), StartsWith("b.json: 'format' is missing"));
  EXPECT_THAT(complaint_of("[1, 2]"), StartsWith("b.json: 'format' is missing"));
  EXPECT_THAT(complaint_of(std::string(1'000'000, '[')), StartsWith("b.json: is no baseline: it is nested too deeply"));
  EXPECT_THAT(complaint_of(R"({"format": "brouwer baseline 1", "study": "x", "entries": []})"),
              StartsWith("b.json: nothing is recorded in it"));
  EXPECT_THROW(read_baseline("/nowhere/b.json"), InputError);
}

TEST(BaselineFile, CutOffAnywhereIsRefused) {
  auto const text = to_json(history());
  for (std::size_t left = 0; left + 3 < text.size(); left += 501)
    EXPECT_THAT(complaint_of(text.substr(0, left)), StartsWith("b.json")) << left;
}

TEST(BaselineFile, ShowsItsHistory) {
  auto baseline = history();
  append(baseline, entry("third", 7));
  auto const text = history_table(baseline);
  EXPECT_THAT(text, StartsWith("toy: 3 entries\n"));
  EXPECT_THAT(text, HasSubstr("energy, dmv-4, double"));
  EXPECT_THAT(text, HasSubstr("  third   the same bits\n"));
  EXPECT_THAT(text, Not(HasSubstr("second  the same bits")));
}

// --- studies that changed -------------------------------------------------------------------------

TEST(StudyChange, OfMembersMethodsAndLengthIsHarmless) {
  for (auto const& [what, by] : {std::pair{"members = 16", "members = 32"},
                                 {"seed = 1", "seed = 2"},
                                 {"dmv-2, dmv-4", "dmv-2"},
                                 {"steps = 1000", "steps = 9"},
                                 {"4 members", "2 members"}}) {
    EXPECT_NO_THROW(require_same_question(study, replaced(study, what, by))) << what;
  }
  EXPECT_EQ(harmless_changes(study, study), "");
  EXPECT_THAT(harmless_changes(study, replaced(study, "seed = 1", "seed = 2")), HasSubstr("seed was 1 there and is 2"));
}

TEST(StudyChange, OfWhatIsEstimatedIsNot) {
  for (auto const& [what, by] : {std::pair{"0x1p+0", "0x1p+1"},
                                 {"momentum = uniform", "momentum = normal"},
                                 {"samples = 8", "samples = 9"},
                                 {"float128", "mpfr-256"}}) {
    EXPECT_THROW(require_same_question(study, replaced(study, what, by)), InputError) << what;
  }
}

TEST(StudyChange, OfSeedOrMembersMakesOtherMembers) {
  EXPECT_TRUE(same_members(study, replaced(study, "dmv-2, dmv-4", "dmv-2")));
  EXPECT_FALSE(same_members(study, replaced(study, "seed = 1", "seed = 2")));
  EXPECT_FALSE(same_members(study, replaced(study, "members = 16", "members = 32")));
}

}  // namespace
}  // namespace brouwer
