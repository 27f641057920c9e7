// Numbers of something, iterations per step say: a mean and a range, and nothing of a law of growth.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/growth/inference.hpp"
#include "analysis/verdict/verdict.hpp"

namespace brouwer {
namespace {

/// Of 3 members at 2 samples; their mean is 12.5.
Ensemble iterations() {
  Ensemble ensemble;
  ensemble.quantity = ensemble.family = "iterations";
  ensemble.unit = "iterations per step";
  ensemble.count = true;
  ensemble.times = {10, 100};
  ensemble.errors.resize(3, 2);
  ensemble.errors << 11, 12, 13, 14, 12, 13;
  return ensemble;
}

TEST(Count, HasAMeanAndARangeOverMembersAndSamples) {
  auto const e = estimate(iterations(), {});
  ASSERT_TRUE(e.count.has_value());
  EXPECT_EQ(e.count->mean, 12.5);
  EXPECT_EQ(e.count->range.low, 11);
  EXPECT_EQ(e.count->range.high, 14);
  EXPECT_EQ(e.mean.back(), 13);
  EXPECT_EQ(e.sentence, "Count: 12.5 iterations per step in the mean (11.0 … 14.0 over members and samples).");
}

TEST(Count, SaysWhatItIsOfWhateverItsUnitLeavesOut) {
  auto e = estimate(iterations(), {});
  for (auto const* unit : {"per step", "iterations per step"}) {
    e.unit = unit;
    EXPECT_EQ(counted_things(e), "iterations per step");
  }
  e.unit = "";
  EXPECT_EQ(counted_things(e), "iterations");
}

TEST(Count, HasNoLawOfGrowth) {
  auto const e = estimate(iterations(), {});
  EXPECT_EQ(e.verdict, Verdict::count);
  for (double const x : {e.drift.per_step, e.drift.t, e.drift.p, e.persistence.F, e.persistence.p,
                         e.diffusion.per_sqrt_step, e.growth.exponent, e.smallest_visible_drift})
    EXPECT_TRUE(std::isnan(x)) << x;
}

TEST(Count, OfZerosIsACountAndNotExact) {
  auto ensemble = iterations();
  ensemble.errors.setZero();
  EXPECT_EQ(estimate(ensemble, {}).verdict, Verdict::count);
}

TEST(Count, SaysWhichMembersItLeavesOut) {
  auto ensemble = iterations();
  ensemble.failed = 1;
  ensemble.failures = {{"the iteration did not converge", 1, 7}};
  EXPECT_THAT(estimate(ensemble, {}).sentence,
              testing::EndsWith("; 1 of 4 members is left out because the iteration did not converge (at step 7)."));
}

TEST(Count, OfMembersThatAllFailedIsNotResolved) {
  auto ensemble = iterations();
  ensemble.errors.resize(0, 2);
  ensemble.failed = 3;
  auto const e = estimate(ensemble, {});
  EXPECT_EQ(e.verdict, Verdict::not_resolved);
  EXPECT_TRUE(e.count.has_value()) << "what it is of does not depend on what became of it";
}

}  // namespace
}  // namespace brouwer
