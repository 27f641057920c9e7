// Simulated ensembles with known β, τ, σ: intervals cover as often as they say, tests cry wolf as rarely as they say,
// and the verdict finds the right word. Seeds are fixed; bounds are those of the binomial law.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <cmath>

#include "analysis/growth/inference.hpp"
#include "tests/analysis/simulated.hpp"
#include "tests/calibration/tables.hpp"

namespace brouwer {

namespace calibration {
void PrintTo(Model const& model, std::ostream* out) { *out << model.name; }
}  // namespace calibration

namespace {

constexpr double sigma = 2e-16;

bool covers(Interval interval, double truth) { return interval.low <= truth && truth <= interval.high; }

/// Small relatives of the designs of docs/statistics.md: the same promises in a few seconds.
constexpr std::array<calibration::Design, 3> designs = {{
    {4, 8, calibration::Spacing::linear, 400},
    {16, 16, calibration::Spacing::logarithmic, 200},
    {64, 32, calibration::Spacing::irregular, 60},
}};

class Promises : public testing::TestWithParam<calibration::Model> {};

TEST_P(Promises, AreKeptWithinBinomialBounds) {
  std::vector<calibration::Tally> tallies;
  for (auto const& design : designs) tallies.push_back(calibration::tally(GetParam(), design));
  EXPECT_THAT(calibration::broken_promises(tallies), testing::IsEmpty());
}
INSTANTIATE_TEST_SUITE_P(Models, Promises,
                         testing::ValuesIn(calibration::models().begin(), calibration::models().end()),
                         [](auto const& test) {
                           std::string name = test.param.name;
                           std::replace_if(
                               name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

TEST(Calibration, IntervalsOfAnotherConfidenceCover) {
  Law const law{.drift = 1e-17, .persistence = 5e-18, .diffusion = sigma};
  constexpr int trials = 1000;
  calibration::Rate beta, diffusion;
  Normal normal(16);
  for (int k = 0; k < trials; ++k) {
    auto const e = estimate(simulated(law, 16, log_spaced(16, 1e4), normal), {.confidence = 0.9});
    beta.add(covers(e.drift.interval, law.drift));
    diffusion.add(covers(e.diffusion.interval, law.diffusion));
  }
  calibration::Nominal const nominal{0.9, 0, calibration::Nominal::Side::coverage};
  EXPECT_EQ(standing(beta, nominal), calibration::Standing::holds) << beta.value();
  EXPECT_EQ(standing(diffusion, nominal), calibration::Standing::holds) << diffusion.value();
}

TEST(Calibration, EffectSizesAreRecovered) {
  Law const law{.drift = 2e-17, .persistence = 5e-18, .diffusion = sigma};
  auto const e = estimate(simulated(law, 4000, log_spaced(16, 1e4), 21ul), {});
  EXPECT_NEAR(e.drift.per_step / law.drift, 1, 0.02);
  EXPECT_NEAR(e.persistence.per_step / law.persistence, 1, 0.05);
  EXPECT_NEAR(e.diffusion.per_sqrt_step / law.diffusion, 1, 0.02);
  double const T = 1e4;
  double const rms = std::hypot(law.drift * T, law.persistence * T, sigma * std::sqrt(T));
  EXPECT_NEAR(e.drift.share, law.drift * T / rms, 0.02);
}

TEST(Calibration, IsItselfAbleToFail) {
  calibration::Tally broken{&calibration::model("walk"), {8, 8, calibration::Spacing::linear, 1000}, {}, {}};
  broken.rates.resize(calibration::claims().size());
  broken.rates[0] = {700, 1000};  // the interval of β
  EXPECT_THAT(calibration::broken_promises({broken}),
              testing::ElementsAre(testing::StartsWith("95 % interval of β: 70.0 % instead of 95.0 %")));
}

struct Case {
  char const* name;
  Law law;
  Verdict verdict;
};
void PrintTo(Case const& c, std::ostream* out) { *out << c.name; }

class ConfusionTable : public testing::TestWithParam<Case> {};

TEST_P(ConfusionTable, TheRightWordIsFoundNineteenTimesInTwenty) {
  constexpr int trials = 60;
  int right = 0;
  Normal normal(2008);
  for (int k = 0; k < trials; ++k)
    right += estimate(simulated(GetParam().law, 64, log_spaced(32, 1e5), normal), {}).verdict == GetParam().verdict;
  EXPECT_GE(right, 57);
}
// At t = 10⁵ the walk alone has spread to 6.3e-14.
INSTANTIATE_TEST_SUITE_P(
    Laws, ConfusionTable,
    testing::Values(
        Case{"walk", {.diffusion = sigma}, Verdict::random_walk},
        Case{"slopes", {.persistence = 2e-18, .diffusion = sigma}, Verdict::persistent_slopes},
        Case{"drift", {.drift = 6e-19, .diffusion = sigma}, Verdict::drift},
        Case{"strong_drift", {.drift = 2e-17, .diffusion = sigma}, Verdict::drift},
        Case{"bounded", {.noise = 1e-16}, Verdict::bounded},
        Case{"phase_of_a_walk", {.diffusion = sigma, .phase = true}, Verdict::faster_than_drift},
        Case{"phase_of_a_drift", {.drift = 2e-17, .diffusion = sigma, .phase = true}, Verdict::faster_than_drift},
        Case{"walk_out_of_noise", {.diffusion = sigma, .noise = 3e-14}, Verdict::random_walk}),
    [](auto const& test) { return test.param.name; });

}  // namespace
}  // namespace brouwer
