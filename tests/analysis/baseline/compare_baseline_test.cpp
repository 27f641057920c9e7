// Two ensembles against one another. Statistics are tested as statistics: simulated pairs with fixed seeds, and counts
// of alarms within the bounds of the binomial law.
#include "analysis/baseline/compare_baseline.hpp"

#include <gmock/gmock.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <brouwer/error.hpp>
#include <cmath>
#include <map>

#include "analysis/growth/inference.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Of = Effect::Of;

BaselineRow row_of(Ensemble const& ensemble) { return baseline_row(ensemble, estimate(ensemble, {})); }

BaselineRow row(Law const& law, int members, unsigned long seed) {
  return row_of(simulated(law, members, log_spaced(32, 10'000), seed));
}

std::string const study = "system = toy\nmembers = 16\nseed = 1\n";
BaselineEntry entry(std::vector<BaselineRow> rows) { return {"before", "", "", study, {}, std::move(rows)}; }

double p_of(std::vector<Effect> const& effects, Of of) {
  for (auto const& effect : effects)
    if (effect.of == of) return effect.p;
  return std::nan("");
}

/// Neither tail of the binomial law holds less than 10⁻⁴.
void expect_binomial(int count, int trials, double chance, std::string const& what) {
  auto const k = static_cast<unsigned>(count), n = static_cast<unsigned>(trials);
  EXPECT_GT(gsl_cdf_binomial_P(k, chance, n), 1e-4) << what << ": " << count << " of " << trials;
  EXPECT_GT(k == 0 ? 1 : gsl_cdf_binomial_Q(k - 1, chance, n), 1e-4) << what << ": " << count << " of " << trials;
}

// --- false alarms ---------------------------------------------------------------------------------

/// Increments of Student's law with 3 degrees of freedom, of variance 1: the fourth moment is infinite.
Ensemble heavy_tailed(int members, unsigned long seed) {
  Normal normal(seed);
  auto const times = log_spaced(32, 10'000);
  Ensemble ensemble = simulated({}, members, times, seed);
  for (auto errors : ensemble.errors.rowwise()) {
    double walk = 0, last = 0;
    for (Eigen::Index j = 0; j < errors.size(); ++j) {
      double const a = normal(), b = normal(), c = normal();
      double const student = normal() / std::sqrt((a * a + b * b + c * c) / 3) / std::sqrt(3.0);
      double const time = times[static_cast<std::size_t>(j)];
      walk += std::sqrt(time - last) * student;
      last = time;
      errors[j] = walk;
    }
  }
  return ensemble;
}

struct Population {
  char const* name;
  int members;
  std::function<BaselineRow(int members, unsigned long seed)> row;
};
void PrintTo(Population const& population, std::ostream* out) { *out << population.name; }

struct FalseAlarms : testing::TestWithParam<Population> {};
TEST_P(FalseAlarms, AreAsManyAsTheLevelAllows) {
  constexpr int pairs = 1000;
  constexpr double level = 0.05;
  std::map<Of, int> alarms;
  for (unsigned long seed = 1; seed <= pairs; ++seed)
    for (auto const& effect :
         effects(GetParam().row(GetParam().members, 2 * seed), GetParam().row(GetParam().members, 2 * seed + 1), false))
      alarms[effect.of] += effect.p < level;
  for (auto const of : {Of::drift, Of::diffusion, Of::slopes, Of::exponent}) {
    EXPECT_GT(gsl_cdf_binomial_Q(static_cast<unsigned>(std::max(alarms[of] - 1, 0)), 1.2 * level, pairs), 1e-4)
        << "effect " << static_cast<int>(of) << ": " << alarms[of];
    RecordProperty("effect-" + std::to_string(static_cast<int>(of)), alarms[of]);
  }
}
INSTANTIATE_TEST_SUITE_P(
    Populations, FalseAlarms,
    testing::Values(Population{"walk_16", 16, [](int m, unsigned long s) { return row({.diffusion = 1}, m, s); }},
                    Population{"walk_64", 64, [](int m, unsigned long s) { return row({.diffusion = 1}, m, s); }},
                    Population{"drift_16", 16,
                               [](int m, unsigned long s) { return row({.drift = 1, .diffusion = 1}, m, s); }},
                    Population{"slopes_16", 16,
                               [](int m, unsigned long s) { return row({.persistence = 1, .diffusion = 1}, m, s); }},
                    Population{"noise_16", 16, [](int m, unsigned long s) { return row({.noise = 1}, m, s); }},
                    Population{"student_64", 64, [](int m, unsigned long s) { return row_of(heavy_tailed(m, s)); }}),
    [](auto const& one) { return one.param.name; });

TEST(Comparison, OfAllQuestionsTogetherKeepsItsLevel) {
  Levels levels;
  levels.test = 0.05;
  constexpr int pairs = 400;
  int alarms = 0;
  for (unsigned long seed = 1; seed <= pairs; ++seed) {
    BaselineEntry before = entry({}), now = entry({});
    now.study = "system = toy\nmembers = 16\nseed = 2\n";
    for (unsigned long k = 0; k < 3; ++k)
      for (auto* one : {&before, &now}) {
        auto r = row({.diffusion = 1}, 16, 10 * seed + 2 * k + (one == &now));
        r.quantity = "quantity " + std::to_string(k);
        one->rows.push_back(r);
      }
    for (auto const& outcome : compare(before, now, levels))
      if (outcome.found.find(" is ") != std::string::npos) {
        ++alarms;
        break;
      }
  }
  EXPECT_GT(gsl_cdf_binomial_Q(static_cast<unsigned>(std::max(alarms - 1, 0)), levels.test, pairs), 1e-4) << alarms;
}

// --- what there is, is seen -----------------------------------------------------------------------

/// What is said to be the smallest visible change is seen with the chance that is said: 0.9.
TEST(Comparison, SeesWhatItSaysItWouldSee) {
  constexpr int pairs = 300, members = 32;
  Levels const levels;
  int drifts = 0, diffusions = 0;
  for (unsigned long seed = 1; seed <= pairs; ++seed) {
    // population values: sd(s) = σ/√t_J, and ln σ̂ of M(J−1) degrees of freedom
    double const drift = visible_noncentrality(2 * members - 2, levels) * std::sqrt(2.0 / members / 10'000);
    double const ratio = std::exp(visible_noncentrality(2 * members - 2, levels) * std::sqrt(1.0 / members / 31));
    auto const before = row({.diffusion = 1}, members, 2 * seed);
    drifts += p_of(effects(before, row({.drift = drift, .diffusion = 1}, members, 2 * seed + 1), false), Of::drift) <
              levels.test;
    diffusions +=
        p_of(effects(before, row({.diffusion = ratio}, members, 2 * seed + 1), false), Of::diffusion) < levels.test;
  }
  expect_binomial(drifts, pairs, 0.9, "drift");
  EXPECT_NEAR(diffusions, 0.9 * pairs, 0.06 * pairs) << "its standard error is itself estimated";
}

TEST(Comparison, PairsMembersWithTheSameStarts) {
  auto before = simulated({.persistence = 1, .diffusion = 1e-3}, 16, log_spaced(32, 10'000), 1), now = before;
  for (Eigen::Index j = 0; j < now.errors.cols(); ++j)
    now.errors.col(j).array() +=
        1e-3 * now.times[static_cast<std::size_t>(j)];  // a thousandth of what members differ by
  Normal normal(3);
  for (auto& e : now.errors.reshaped()) e += 1e-2 * normal();
  EXPECT_GT(p_of(effects(row_of(before), row_of(now), false), Of::drift), 0.5);
  EXPECT_LT(p_of(effects(row_of(before), row_of(now), true), Of::drift), 1e-6);
}

TEST(Comparison, OfMembersThatFailedIsNotPaired) {
  auto before = row({.persistence = 1}, 16, 1), now = row({.persistence = 1}, 16, 2);
  double const welch = p_of(effects(before, now, false), Of::drift);
  before.failed = 1;
  EXPECT_EQ(p_of(effects(before, now, true), Of::drift), welch);
}

// --- what is said ---------------------------------------------------------------------------------

Outcome outcome(Law const& before, Law const& now, int members = 64) {
  return compare(entry({row(before, members, 1)}), entry({row(now, members, 2)}), {}).front();
}

TEST(Comparison, FailsWhereDriftDiffusionOrSlopesHaveGrown) {
  auto const drift = outcome({.drift = 1, .diffusion = 1}, {.drift = -2, .diffusion = 1});
  EXPECT_FALSE(drift.passed);
  EXPECT_THAT(drift.found, HasSubstr("drift β is larger: 1.00 then, −2.00 now, by "));
  EXPECT_THAT(drift.found, HasSubstr("equal within sampling error: diffusion σ × "));
  EXPECT_EQ(drift.claim, "energy: not worse than 'before'");
  auto const diffusion = outcome({.diffusion = 1}, {.diffusion = 1.5});
  EXPECT_FALSE(diffusion.passed);
  EXPECT_THAT(diffusion.found, HasSubstr("diffusion σ is larger: "));
  auto const slopes = outcome({.diffusion = 1}, {.persistence = 1, .diffusion = 1});
  EXPECT_FALSE(slopes.passed);
  EXPECT_THAT(slopes.found, HasSubstr("spread of the slopes is larger: "));
}

TEST(Comparison, SaysWhatHasShrunkAndPasses) {
  auto const drift = outcome({.drift = -2, .diffusion = 1}, {.drift = 1, .diffusion = 1});
  EXPECT_TRUE(drift.passed);
  EXPECT_THAT(drift.found, HasSubstr("drift β is smaller: −2.00 then, 1.00 now, by 3.000 ± 0.003 per step (p = "));
  auto const diffusion = outcome({.diffusion = 1.5}, {.diffusion = 1});
  EXPECT_TRUE(diffusion.passed);
  EXPECT_THAT(diffusion.found, HasSubstr("diffusion σ is smaller: "));
}

TEST(Comparison, SaysTheSmallestChangeThatWouldBeSeen) {
  auto const equal = outcome({.diffusion = 1}, {.diffusion = 1});
  EXPECT_TRUE(equal.passed);
  EXPECT_THAT(equal.found, testing::StartsWith("equal within sampling error: drift β by "));
  EXPECT_THAT(equal.found, testing::ContainsRegex("diffusion σ × [0-9.]+ .* seen from × 1\\.[0-9]+ on"));
}

TEST(Comparison, KnowsTheSameBits) {
  auto const same = compare(entry({row({.drift = 1}, 8, 1)}), entry({row({.drift = 1}, 8, 1)}), {});
  ASSERT_EQ(same.size(), 1U);
  EXPECT_TRUE(same[0].passed);
  EXPECT_EQ(same[0].found, "the same bits");
}

TEST(Comparison, MissesRowsAndWelcomesNewOnes) {
  auto other = row({.diffusion = 1}, 8, 1);
  other.quantity = "casimir";
  auto const outcomes = compare(entry({row({.diffusion = 1}, 8, 1)}), entry({other}), {});
  ASSERT_EQ(outcomes.size(), 2U);
  EXPECT_FALSE(outcomes[0].passed);
  EXPECT_EQ(outcomes[0].found, "it was recorded, and is not there any more");
  EXPECT_TRUE(outcomes[1].passed);
  EXPECT_EQ(outcomes[1].claim, "casimir: is new");
}

TEST(Comparison, FailsWhereAllMembersFailed) {
  auto now = row({.diffusion = 1}, 8, 1);
  now.members = 0;
  now.failed = 8;
  now.digest = "other";
  auto const outcomes = compare(entry({row({.diffusion = 1}, 8, 1)}), entry({now}), {});
  EXPECT_FALSE(outcomes[0].passed);
  EXPECT_EQ(outcomes[0].found, "all 8 members failed");
}

TEST(Comparison, OfOneMemberAndOfCountsClaimsNothing) {
  auto const single = outcome({.diffusion = 1}, {.diffusion = 9}, 1);
  EXPECT_TRUE(single.passed);
  EXPECT_THAT(single.found, HasSubstr("two members at two times would be needed"));
  auto counted = simulated({.diffusion = 1}, 8, log_spaced(8, 1000), 1);
  counted.count = true;
  counted.errors.setConstant(7);
  auto more = counted;
  more.errors.setConstant(9);
  auto const counts = compare(entry({row_of(counted)}), entry({row_of(more)}), {});
  EXPECT_TRUE(counts[0].passed);
  EXPECT_EQ(counts[0].found, "7.000 in the mean then, 9.000 now");
}

TEST(Comparison, OfExactErrorsSeesThatTheyAreExactNoMore) {
  auto exact = simulated({.diffusion = 1}, 8, log_spaced(8, 1000), 1);
  exact.errors.setZero();
  auto const now = row_of(simulated({.drift = 1, .diffusion = 1e-3}, 8, log_spaced(8, 1000), 1));
  auto const outcomes = compare(entry({row_of(exact)}), entry({now}), {});
  EXPECT_FALSE(outcomes[0].passed);
  EXPECT_THAT(outcomes[0].found, HasSubstr("drift β is larger: 0 then"));
}

TEST(Comparison, RefusesAnotherStudy) {
  auto now = entry({row({.diffusion = 1}, 8, 1)});
  now.study = "system = other\nmembers = 16\nseed = 1\n";
  EXPECT_THROW(compare(entry({row({.diffusion = 1}, 8, 1)}), now, {}), InputError);
}

TEST(Holm, MultipliesTheSmallestByAllAndNeverDecreases) {
  EXPECT_THAT(adjusted({0.01, 0.5, 0.02}, Correction::holm), ElementsAre(0.03, 0.5, 0.04));
  EXPECT_THAT(adjusted({0.02, 0.011}, Correction::holm), ElementsAre(0.022, 0.022));
  EXPECT_THAT(adjusted({}, Correction::holm), ElementsAre());
}

}  // namespace
}  // namespace brouwer
