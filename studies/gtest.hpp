#pragma once
/// Drift-slope regression tests for users of GoogleTest: run a study, then assert on what was found.
///
///     TEST(ThreeConstants, DoNotDrift) {
///       brouwer::StudyRun const study("studies/elliptic-drift.toml", {"ensemble.members=64"});
///       auto const& energy = study.row("energy", {.method = "elliptic-three-constants"});
///       EXPECT_THAT(energy, brouwer::HasNoDrift());
///       EXPECT_THAT(energy, brouwer::DriftIsSmallerThan(1e-18));
///       EXPECT_THAT(energy, brouwer::GrowsAs(0.5, 0.05));
///     }
///
/// And against what `brouwer baseline` has recorded, all of it or single rows:
///
///       auto const before = brouwer::read_baseline("data/baselines/elliptic-drift.json").entry();
///       EXPECT_THAT(study.recorded(), brouwer::IsNotWorseThan(before));
///       EXPECT_THAT(study.recorded().only("energy"), brouwer::IsNotWorseThan(before.only("energy")));
///
/// Link with brouwer::program and GTest::gmock. A study's result depends on the study alone (seeds are in it), so such a test
/// passes always or never, on any number of threads.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <stdlib.h>  // mkdtemp

#include <brouwer/ensemble/run.hpp>
#include <brouwer/error.hpp>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "analysis/baseline/compare_baseline.hpp"
#include "studies/commands/findings.hpp"
#include "studies/commands/recording.hpp"
#include "studies/read.hpp"

namespace brouwer {

/// A study, run and analysed in a folder of its own that is removed afterwards.
class StudyRun {
 public:
  /// @param settings  "KEY=VALUE" each, as for --set: "ensemble.members=64"
  /// @throws InputError, RunError as the program does
  explicit StudyRun(std::filesystem::path const& study, std::vector<std::string> const& settings = {},
                    Catalogue const& catalogue = builtin_catalogue(), Levels const& levels = {})
      : file_(read_study(study, catalogue, overrides(settings))),
        findings_({compute(file_, catalogue, folder_.path)}, levels) {}

  /// What was found of a component ("energy", "spatial-momentum-1") in the one cell that is selected.
  /// @throws InputError if none or several are
  Estimates const& row(std::string const& quantity, Selector const& where = {}) const {
    std::vector<Estimates const*> found;
    for (auto const& row : findings_.rows())
      if (row.quantity == quantity && where.matches(row.cell)) found.push_back(&row);
    if (found.size() == 1) return *found.front();
    throw InputError(
        fmt::format("{}: expected one cell with '{}', found {}", file_.study.name, quantity, found.size()));
  }

  std::vector<Estimates> const& rows() const { return findings_.rows(); }

  /// What a baseline records of this run.
  BaselineEntry recorded() const { return brouwer::recorded(findings_, folder_.path); }

  /// What became of the study's own [[expect]], and of guards that failed.
  std::vector<Outcome> outcomes() const { return findings_.check(file_.expectations); }

 private:
  struct TemporaryFolder {
    TemporaryFolder() : path((std::filesystem::temp_directory_path() / "brouwer-XXXXXX").string()) {
      if (!mkdtemp(path.data())) throw RunError(fmt::format("{}: cannot be made", path));
    }
    ~TemporaryFolder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
    TemporaryFolder(TemporaryFolder const&) = delete;
    TemporaryFolder& operator=(TemporaryFolder const&) = delete;
    std::string path;
  };

  static std::vector<Override> overrides(std::vector<std::string> const& settings) {
    std::vector<Override> given;
    for (auto const& setting : settings) given.push_back(parse_override(setting));
    return given;
  }

  static std::string const& compute(StudyFile const& file, Catalogue const& catalogue, std::string const& folder) {
    Progress progress;
    run(file.study, file.text, catalogue, file.plan, folder, {}, progress);
    return folder;
  }

  StudyFile file_;
  TemporaryFolder folder_;
  Findings findings_;
};

/// One row against one claim, by the same code that judges [[expect]].
class MeetsClaim {
 public:
  using is_gtest_matcher = void;
  explicit MeetsClaim(Expectation claim) : claim_(std::move(claim)) {}

  bool MatchAndExplain(Estimates const& row, std::ostream* explanation) const {
    Expectation claim = claim_;
    claim.of = row.quantity;
    auto const outcomes = check({claim}, {row}, {});
    if (explanation) *explanation << "found " << outcomes.front().found;
    return outcomes.front().passed;
  }
  void DescribeTo(std::ostream* out) const { *out << described("meets"); }
  void DescribeNegationTo(std::ostream* out) const { *out << described("does not meet"); }

 private:
  std::string described(char const* verb) const {
    if (claim_.growth)
      return fmt::format("{} growth as t^{} ± {}", verb, claim_.growth->exponent, claim_.growth->within);
    if (claim_.failed) return fmt::format("{} 'at most {} members failed'", verb, *claim_.failed);
    if (claim_.drift == Expectation::DriftWanted::smaller_than)
      return fmt::format("{} '|drift| < {} per step'", verb, claim_.drift_bound);
    if (claim_.drift == Expectation::DriftWanted::none) return fmt::format("{} 'no drift'", verb);
    return fmt::format("{} a drift in [{}, {}] per step", verb, claim_.drift_band.low, claim_.drift_band.high);
  }
  Expectation claim_;
};

/// No drift at the level of the test; that of the study's levels unless given.
inline MeetsClaim HasNoDrift(std::optional<double> level = {}) {
  Expectation claim;
  claim.drift = Expectation::DriftWanted::none;
  claim.level = level;
  return MeetsClaim(claim);
}

/// A drift per step inside [low, high], and significant unless 0 lies inside, too.
inline MeetsClaim DriftsBetween(double low, double high) {
  Expectation claim;
  claim.drift = Expectation::DriftWanted::band;
  claim.drift_band = {low, high};
  return MeetsClaim(claim);
}

/// |β| < bound per step, proven at the level of the test; that of the study's levels unless given. Where members are too
/// few to prove it, this fails: the message says the smallest bound that they prove.
inline MeetsClaim DriftIsSmallerThan(double bound, std::optional<double> level = {}) {
  Expectation claim;
  claim.drift = Expectation::DriftWanted::smaller_than;
  claim.drift_bound = bound;
  claim.level = level;
  return MeetsClaim(claim);
}

/// At most so many members have failed.
inline MeetsClaim HasFailedAtMost(std::int64_t members) {
  Expectation claim;
  claim.failed = members;
  return MeetsClaim(claim);
}

/// RMS ∝ t^q with q = exponent ± within.
inline MeetsClaim GrowsAs(double exponent, double within) {
  Expectation claim;
  claim.growth = Around{exponent, within};
  return MeetsClaim(claim);
}

/// What a study records now against what was recorded, by the same code as `check --baseline`; all
/// questions together keep the level.
class IsNotWorseThan {
 public:
  using is_gtest_matcher = void;
  explicit IsNotWorseThan(BaselineEntry recorded, Levels const& levels = {})
      : recorded_(std::move(recorded)), levels_(levels) {}

  bool MatchAndExplain(BaselineEntry const& now, std::ostream* explanation) const {
    bool passed = true;
    for (auto const& outcome : compare(recorded_, now, levels_)) {
      passed = passed && outcome.passed;
      if (explanation) *explanation << "\n" << outcome.claim << ": " << outcome.found;
    }
    return passed;
  }
  void DescribeTo(std::ostream* out) const { *out << "is not worse than '" << recorded_.label << "'"; }
  void DescribeNegationTo(std::ostream* out) const { *out << "is worse than '" << recorded_.label << "'"; }

 private:
  BaselineEntry recorded_;
  Levels levels_;
};

/// For messages of failed tests.
inline void PrintTo(BaselineEntry const& entry, std::ostream* out) { *out << entry.rows.size() << " recorded rows"; }
inline void PrintTo(Estimates const& row, std::ostream* out) { *out << row.quantity << ": " << row.sentence; }
inline void PrintTo(Outcome const& outcome, std::ostream* out) {
  *out << (outcome.passed ? "passed: " : "failed: ") << outcome.claim << "; found " << outcome.found;
}

/// EXPECT_THAT(study.outcomes(), Each(Passed()))
MATCHER(Passed, "is met") { return arg.passed; }

}  // namespace brouwer
