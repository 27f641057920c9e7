// Adjusted p values: a worked example of the literature, the definitions, and what they promise, simulated.
#include "analysis/multiplicity.hpp"

#include <gmock/gmock.h>
#include <gsl/gsl_cdf.h>

#include <brouwer/error.hpp>
#include <cmath>
#include <random>

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Fifteen hypotheses on a treatment of heart attacks, as Y. Benjamini & Y. Hochberg (1995), section 4, have them: at 0.05
/// their procedure rejects four, those that control the chance of any false alarm three.
std::vector<double> const fifteen = {0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344,
                                     0.0459, 0.3240, 0.4262, 0.5719, 0.6528, 0.7590, 1.0000};

long rejected(std::vector<double> const& p, double level) {
  return std::count_if(p.begin(), p.end(), [&](double x) { return x < level; });
}

TEST(Multiplicity, IsThatOfTheWorkedExample) {
  EXPECT_EQ(rejected(fifteen, 0.05), 9);
  EXPECT_EQ(rejected(adjusted(fifteen, Correction::fdr), 0.05), 4);
  EXPECT_EQ(rejected(adjusted(fifteen, Correction::holm), 0.05), 3);
}

TEST(Multiplicity, AdjustsEachByItsRank) {
  auto const holm = adjusted(fifteen, Correction::holm), fdr = adjusted(fifteen, Correction::fdr);
  EXPECT_NEAR(holm[0], 15 * 0.0001, 1e-15);
  EXPECT_NEAR(holm[2], 13 * 0.0019, 1e-15);
  EXPECT_NEAR(holm[4], 11 * 0.0201, 1e-15);
  EXPECT_NEAR(holm[6], 10 * 0.0278, 1e-15);  // 9 · 0.0298 is less than the one before
  EXPECT_EQ(holm[14], 1);
  EXPECT_NEAR(fdr[3], 0.0095 * 15 / 4, 1e-15);
  EXPECT_NEAR(fdr[5], 0.0298 * 15 / 7, 1e-15);  // 0.0278 · 15/6 is more than the one behind
  EXPECT_NEAR(fdr[8], 0.0459 * 15 / 9, 1e-15);
  EXPECT_EQ(fdr[14], 1);
  EXPECT_EQ(adjusted(fifteen, Correction::none), fifteen);
}

TEST(Multiplicity, KeepsTheOrderGivenAndLeavesOutWhatIsNoTest) {
  std::vector<double> const p = {0.04, std::nan(""), 0.01, 0.03};
  EXPECT_THAT(adjusted(p, Correction::holm),
              ElementsAre(testing::DoubleEq(0.06), testing::IsNan(), testing::DoubleEq(0.03), testing::DoubleEq(0.06)));
  EXPECT_THAT(adjusted(p, Correction::fdr),
              ElementsAre(testing::DoubleEq(0.04), testing::IsNan(), testing::DoubleEq(0.03), testing::DoubleEq(0.04)));
  EXPECT_TRUE(adjusted({}, Correction::holm).empty());
}

/// p of 20 tests that share a part of their noise; the first `effects` have something to see.
std::vector<double> simulated_tests(std::mt19937_64& generator, int effects) {
  std::normal_distribution<double> normal;
  double const shared = normal(generator);
  std::vector<double> p(20);
  for (int k = 0; k < 20; ++k) {
    double const z = std::sqrt(0.3) * shared + std::sqrt(0.7) * normal(generator) + (k < effects ? 3.5 : 0);
    p[static_cast<std::size_t>(k)] = gsl_cdf_ugaussian_Q(z);
  }
  return p;
}

TEST(Multiplicity, HolmKeepsTheChanceOfAnyFalseAlarm) {
  std::mt19937_64 generator(1979);
  int alarms = 0, without = 0;
  for (int k = 0; k < 4000; ++k) {
    auto const p = simulated_tests(generator, 5);
    auto const holm = adjusted(p, Correction::holm);
    alarms += rejected({holm.begin() + 5, holm.end()}, 0.05) > 0;
    without += rejected({p.begin() + 5, p.end()}, 0.05) > 0;
  }
  EXPECT_LE(alarms, 4000 * 0.05 + 4 * std::sqrt(4000 * 0.05 * 0.95));
  EXPECT_GT(without, 1200);
}

TEST(Multiplicity, BenjaminiAndHochbergKeepTheShareOfFalseAlarms) {
  std::mt19937_64 generator(1995);
  double share = 0;
  long found_fdr = 0, found_holm = 0;
  for (int k = 0; k < 4000; ++k) {
    auto const p = simulated_tests(generator, 10);
    auto const fdr = adjusted(p, Correction::fdr);
    auto const all = rejected(fdr, 0.1), wrong = rejected({fdr.begin() + 10, fdr.end()}, 0.1);
    share += all > 0 ? static_cast<double>(wrong) / static_cast<double>(all) / 4000 : 0;
    found_fdr += all - wrong;
    found_holm += rejected(adjusted(p, Correction::holm), 0.1);
  }
  EXPECT_LE(share, 0.1 * 10 / 20 + 0.01);  // q m₀/m
  EXPECT_GT(share, 0.02);
  EXPECT_GT(found_fdr, found_holm);
}

TEST(Correction, HasNames) {
  for (auto const correction : {Correction::none, Correction::holm, Correction::fdr})
    EXPECT_EQ(correction_of(to_string(correction)), correction);
  try {
    correction_of("hlom");
    FAIL();
  } catch (InputError const& error) {
    EXPECT_THAT(error.what(), HasSubstr("there is no correction 'hlom'; did you mean 'holm'?"));
  }
}

}  // namespace
}  // namespace brouwer
