// The studies that are shipped: each runs at toy size, and the claims of the field hold at a size that shows them.
#include <gtest/gtest.h>

#include <filesystem>

#include "studies/gtest.hpp"

namespace brouwer {
namespace {

namespace fs = std::filesystem;
using testing::Each;

fs::path const studies = fs::path(BROUWER_SOURCE) / "studies";

std::vector<std::string> shipped() {
  std::vector<std::string> names;
  for (auto const& entry : fs::directory_iterator(studies))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

struct ShippedStudy : testing::TestWithParam<std::string> {
  fs::path const file = studies / (GetParam() + ".toml");
};
INSTANTIATE_TEST_SUITE_P(Each, ShippedStudy, testing::ValuesIn(shipped()), [](auto const& one) {
  std::string name = one.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

/// Do the errors of this method hold its truncation?
bool truncates(MethodEntry const& method, Reference::Kind reference) {
  if (method.order == 0) return false;
  if (reference == Reference::Kind::exact) return true;
  return !method.name.starts_with("dmv-") && !method.name.starts_with("gauss-");  // they conserve what is observed
}

TEST_P(ShippedStudy, RunsAtToySize) {
  StudyRun const study(file, {"ensemble.members=4", "integrate.steps=64", "observe.samples.count=8"});
  EXPECT_FALSE(study.rows().empty());
  auto const catalogue = builtin_catalogue();
  auto const reference = read_study(file, catalogue, {}).study.reference.kind;
  for (auto const& row : study.rows()) {
    EXPECT_EQ(row.failed, 0) << row.quantity;
    EXPECT_GT(row.rms_final, 0) << row.quantity << ": the state must have moved, and its arithmetic rounded";
    bool const rounding = !row.count && !truncates(catalogue.method(row.cell.system, row.cell.method), reference);
    EXPECT_LT(row.rms_final, rounding ? 1e-11 : 1e3) << row.quantity;
  }
}

TEST_P(ShippedStudy, WritesDownItsQuestionItsSourceAndWhatItExpects) {
  auto const read = read_study(file, builtin_catalogue(), {});
  EXPECT_EQ(read.study.question.back(), '?');
  EXPECT_FALSE(read.study.source.empty());
  EXPECT_FALSE(read.expectations.empty());
}

TEST(EllipticDrift, IsSeenInTheNaiveConstantsAndNotInThreeConsistentOnes) {
  StudyRun const study(studies / "elliptic-drift.toml", {"ensemble.members=64", "integrate.steps=20_000"});
  EXPECT_THAT(study.outcomes(), Each(Passed()));
  EXPECT_GT(std::abs(study.row("energy", {.method = "elliptic-naive"}).drift.t), 30);
  auto const& consistent = study.row("energy", {.method = "elliptic-three-constants"});
  EXPECT_EQ(consistent.verdict, Verdict::random_walk);
  EXPECT_THAT(consistent, GrowsAs(0.5, 0.05));
}

TEST(EllipticDrift, IsNotWorseThanItsBaseline) {
  StudyRun const study(studies / "elliptic-drift.toml");
  auto const baseline = read_baseline(fs::path(BROUWER_SOURCE) / "data/baselines/elliptic-drift.json");
  EXPECT_THAT(study.recorded(), IsNotWorseThan(baseline.entry()));
}

TEST(EllipticDrift, IsThereWithOwnAndGslFunctions) {
  StudyRun const study(studies / "elliptic-drift.toml",
                       {"ensemble.members=64", "integrate.steps=20_000", "integrate.special_functions=['own','gsl']",
                        "observe.quantities=['energy']"});
  for (char const* variant : {"own", "gsl"}) {
    EXPECT_THAT(study.row("energy", {.method = "elliptic-naive", .special_functions = variant}),
                DriftsBetween(-3e-17, -1.5e-17));
    EXPECT_THAT(study.row("energy", {.method = "elliptic-three-constants", .special_functions = variant}),
                HasNoDrift());
  }
}

TEST(EllipticForms, GrowAsTheirStudyExpects) {
  StudyRun const study(studies / "elliptic-forms.toml",
                       {"integrate.until=400.0", "observe.quantities=['energy']", "observe.reference='none'"});
  for (auto const& outcome : study.outcomes()) {
    if (!outcome.claim.starts_with("energy")) continue;
    EXPECT_THAT(outcome, Passed());
  }
}

TEST(EllipticOperations, ShowWhatTheirStudyExpects) {
  StudyRun const study(studies / "elliptic-operations.toml",
                       {"ensemble.members=16", "integrate.steps=2000", "integrate.contraction=false"});
  EXPECT_THAT(study.outcomes(), Each(Passed()));
  auto const t = [&](char const* rounding, char const* constants) {
    return study.row("energy", {.rounding = rounding, .constants = constants}).drift.t;
  };
  EXPECT_LT(t("nearest", "exact"), -10) << "exact constants alone do not remove the drift";
  EXPECT_LT(t("stochastic", "rounded"), -10) << "nor does rounding without bias";
  EXPECT_GT(t("stochastic", "exact"), -4);
}

/// A bias of 7e-20 a step, in a relative error of the energy.
TEST(FehlbergCoefficients, DriftWhereTheyAreRounded) {
  StudyRun const study(studies / "fehlberg-coefficients.toml");
  EXPECT_THAT(study.outcomes(), Each(Passed()));
}

TEST(Bodies, DriftAsTheirStudyExpects) {
  StudyRun const study(studies / "bodies.toml", {"ensemble.members=128"});
  EXPECT_THAT(study.outcomes(), Each(Passed()));
}

TEST(BrouwersLaw, IsFollowedByTheDiscreteMoserVeselovAlgorithmsOverAFactor16InH) {
  StudyRun const study(studies / "dmv-brouwer-law.toml",
                       {"ensemble.members=64", "integrate.step=[0.08,0.02,0.005]", "integrate.until=240.0"});
  for (std::string const method : {"dmv-2", "dmv-10", "dmv-exact"}) {
    auto const row = [&](bool compensation, double h) {
      return study.row("energy", {.method = method, .compensation = compensation, .step = h});
    };
    // RMS/√(ht) is one number; 64 members tell it to 9 %
    for (double h : {0.08, 0.02, 0.005})
      EXPECT_NEAR(row(true, h).rms_final / std::sqrt(h * 240.0) / 3.0e-17, 1, 0.3) << method << ' ' << h;
    // without compensation the error of a step does not shrink with it: RMS ∝ √(t/h)
    EXPECT_NEAR(row(false, 0.08).diffusion.per_sqrt_step / row(false, 0.005).diffusion.per_sqrt_step, 1, 0.1);
  }
}

TEST(WorkAndPrecision, ShowTheOrderOfEveryMethod) {
  StudyRun const study(studies / "work-precision.toml", {"ensemble.members=8"});
  EXPECT_THAT(study.outcomes(), Each(Passed()));
}

TEST(DoubleWell, KeepsItsModifiedEnergiesToTheirOrders) {
  StudyRun const study(studies / "double-well.toml", {"ensemble.members=16", "integrate.until=50.0"});
  for (auto const& outcome : study.outcomes()) {
    if (outcome.claim.find("h^p") == std::string::npos) continue;
    EXPECT_THAT(outcome, Passed());
  }
}

TEST(GaussMethods, DriftWithRoundedCoefficientsAndNotOtherwise) {
  StudyRun const study(studies / "gauss-henon-heiles.toml",
                       {"ensemble.members=128", "integrate.steps=20_000", "integrate.compensation=true"});
  EXPECT_THAT(study.outcomes(), Each(Passed()));
}

TEST(TruncationOfRungeKutta, IsToldApartFromItsRoundOff) {
  StudyRun const study(studies / "runge-kutta-truncation.toml",
                       {"ensemble.members=32", "integrate.steps=10_000", "integrate.methods=['kutta-4']"});
  EXPECT_THAT(study.outcomes(), Each(Passed()));
}

}  // namespace
}  // namespace brouwer
