// What is said where increments contradict the model, and where nothing is.
#include "analysis/increments/increments_objection.hpp"

#include <gmock/gmock.h>

#include "analysis/growth/inference.hpp"
#include "tests/analysis/simulated.hpp"
#include "tests/analysis/simulated_increments.hpp"

namespace brouwer {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

std::string objection(std::function<double(double)> const& next, int members = 64) {
  return increments_objection(estimate(ensemble_of(next, members, linearly_spaced(64, 6400)), {}));
}

TEST(Objection, ToCorrelatedIncrementsSaysWhereSigmaHolds) {
  Increments next(1);
  // an autoregression of ρ = 0.3 is at long scales a walk of √(1.3/0.7) = 1.36 times the size; at 4 increments 1.25, at
  // 8 increments 1.30 times
  auto const said = objection([&](double x) { return next.autoregressive(0.3, x); }, 512);
  EXPECT_THAT(said, AllOf(HasSubstr("Its increments are correlated (ρ₁ = 0.2"),
                          testing::ContainsRegex("from scales of (400|800|1600) steps on σ is 2.[67]e-16 per √step, "
                                                 "1.[34] times what is said")));
}

TEST(Objection, ToHeavyTailsSaysWhatSigmaIsWorth) {
  Increments next(2);
  auto const said = objection([&](double) { return next.heavy_tailed(); });
  EXPECT_THAT(said, AllOf(HasSubstr("Its increments are not normal"), HasSubstr("times fewer normal ones")));
}

TEST(Objection, IsNotMadeToAWalk) {
  Increments next(3);
  int made = 0;
  for (int k = 0; k < 200; ++k) made += !objection([&](double) { return next.normal(); }, 16).empty();
  EXPECT_LE(made, 3);  // three tests at 0.001, most of which also ask for an effect
}

TEST(Objection, IsNotMadeToASmallEffectInALargeEnsemble) {
  Increments next(4);
  auto const ensemble =
      ensemble_of([&](double x) { return next.autoregressive(0.02, x); }, 2000, linearly_spaced(64, 6400));
  auto const e = estimate(ensemble, {});
  EXPECT_LT(e.increments->autocorrelations[0].p, 1e-6);
  EXPECT_THAT(increments_objection(e), IsEmpty());
}

TEST(Objection, IsNotMadeToWhatTheVerdictSaysItself) {
  auto const bounded = estimate(simulated({.noise = 1e-16}, 64, log_spaced(32, 1e5), 5ul), {});
  EXPECT_EQ(bounded.verdict, Verdict::bounded);
  EXPECT_LT(bounded.increments->autocorrelations[0].rho, -0.3);
  EXPECT_THAT(increments_objection(bounded), IsEmpty());
}

}  // namespace
}  // namespace brouwer
