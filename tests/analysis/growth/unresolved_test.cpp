// Ensembles that no law of growth can be read from say so, and do not take others with them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/growth/inference.hpp"
#include "analysis/pages/tables.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Members that share an oscillation and differ by a hundredth of it: a truncation error.
Ensemble shared_oscillation() {
  Ensemble ensemble;
  ensemble.quantity = "energy";
  ensemble.errors.resize(16, 64);
  for (int j = 0; j < 64; ++j) {
    ensemble.times.push_back(10.0 * (j + 1));
    for (int i = 0; i < 16; ++i)
      ensemble.errors(i, j) = std::sin(3.7 * (j + 1) + 1) - std::sin(1.0) + 0.01 * std::sin(7.0 * i + 2.3 * j);
  }
  return ensemble;
}

TEST(SharedOscillation, IsNoDriftHoweverSignificantTheSlopeOfItsMean) {
  auto const e = estimate(shared_oscillation(), {});
  ASSERT_TRUE(e.course.has_value());
  EXPECT_LT(e.course->whole.p, 1e-6) << "the t test alone would call it a drift";
  EXPECT_GT(e.drift.p, 0.05);
  EXPECT_EQ(e.verdict, Verdict::not_resolved);
  EXPECT_THAT(e.sentence, HasSubstr("oscillation"));
}

TEST(FailedEnsemble, IsARowThatSaysSo) {
  Ensemble ensemble;
  ensemble.quantity = "energy";
  ensemble.times = {1, 10, 100};
  ensemble.errors.resize(0, 3);
  ensemble.failed = 5;
  auto const e = estimate(ensemble, {});
  EXPECT_EQ(e.verdict, Verdict::not_resolved);
  EXPECT_THAT(e.sentence, HasSubstr("all 5 members failed"));
  for (auto format :
       {TableFormat::text, TableFormat::csv, TableFormat::markdown, TableFormat::latex, TableFormat::json})
    EXPECT_THAT(render_table({e}, format), Not(HasSubstr("nan")));
}

TEST(FailedEnsemble, SaysWhyItsMembersFailed) {
  Ensemble ensemble;
  ensemble.quantity = "energy";
  ensemble.times = {1, 10, 100};
  ensemble.errors.resize(0, 3);
  ensemble.failed = 5;
  ensemble.failures = {{"the iteration did not converge", 5, 3}};
  auto const e = estimate(ensemble, {});
  EXPECT_EQ(e.verdict, Verdict::not_resolved);
  EXPECT_EQ(e.sentence,
            "Not resolved: all 5 members failed because the iteration did not converge (the first at step 3); is "
            "the step too large for this method?");
}

}  // namespace
}  // namespace brouwer
