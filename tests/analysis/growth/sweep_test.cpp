// The law of h and t over the cells of a sweep.
#include "analysis/growth/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <brouwer/error.hpp>
#include <cmath>

#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

/// Random walks with σ per √step ∝ h^exponent, members sharing part of their path across the cells.
std::vector<Ensemble> sweep(double exponent, std::vector<double> const& steps, int members, unsigned long seed) {
  Normal normal(seed);
  return swept({.diffusion = 1}, exponent, steps, members, log_spaced(12, 1e4), normal);
}

std::string complaint(std::vector<Ensemble> const& cells) {
  try {
    fit_sweep(cells, {});
  } catch (InputError const& error) {
    return error.what();
  }
  return "";
}

std::vector<double> const four_steps = {0.01, 0.02, 0.04, 0.16};

TEST(Sweep, RecoversAnExactLaw) {
  std::vector<Ensemble> cells;
  for (double const h : four_steps) {
    auto cell = simulated({}, 3, log_spaced(8, 1e4), 1ul);
    cell.cell.step = h;
    for (auto row : cell.errors.rowwise())
      for (Eigen::Index j = 0; j < row.size(); ++j)
        row[j] = 3e-17 * std::pow(h, 0.25) * std::pow(cell.times[static_cast<std::size_t>(j)] * h, 0.75);
    cells.push_back(cell);
  }
  auto const law = fit_sweep(cells, {});
  EXPECT_NEAR(law.step_exponent, 0.25, 1e-12);
  EXPECT_NEAR(law.time_exponent, 0.75, 1e-12);
  EXPECT_NEAR(law.amplitude / 3e-17, 1, 1e-12);
  EXPECT_NEAR(law.step_interval.low, 0.25, 1e-11);
  EXPECT_EQ(law.cells, 4u);
}

TEST(Sweep, FindsBrouwersLawInTheTimeOfTheSystem) {
  // σ ∝ h per √step is σ ∝ √h per √time: RMS ∝ √(h t)
  auto const law = fit_sweep(sweep(1, four_steps, 200, 2), {});
  EXPECT_LT(law.step_interval.low, 0.5);
  EXPECT_GT(law.step_interval.high, 0.5);
  EXPECT_LT(law.time_interval.low, 0.5);
  EXPECT_GT(law.time_interval.high, 0.5);
  EXPECT_LT(law.step_interval.high - law.step_interval.low, 0.1);
}

TEST(Sweep, IntervalsCoverAsOftenAsTheySay) {
  constexpr int ensembles = 300;
  int step_covered = 0, time_covered = 0;
  for (unsigned long k = 0; k < ensembles; ++k) {
    auto const law = fit_sweep(sweep(0, {0.01, 0.03, 0.1}, 20, 100 * k), {});  // σ per √step the same: RMS ∝ h^−½ t^½
    step_covered += law.step_interval.low <= -0.5 && -0.5 <= law.step_interval.high;
    time_covered += law.time_interval.low <= 0.5 && 0.5 <= law.time_interval.high;
  }
  EXPECT_NEAR(step_covered, 0.95 * ensembles, 4 * std::sqrt(0.95 * 0.05 * ensembles));
  EXPECT_NEAR(time_covered, 0.95 * ensembles, 4 * std::sqrt(0.95 * 0.05 * ensembles));
}

TEST(Sweep, UsesTheMembersThatAllCellsHave) {
  auto cells = sweep(1, four_steps, 50, 3);
  auto fewer = cells;
  for (auto& cell : fewer) cell.errors.conservativeResize(40, Eigen::NoChange);
  cells[2].errors.conservativeResize(40, Eigen::NoChange);
  EXPECT_EQ(fit_sweep(cells, {}).step_exponent, fit_sweep(fewer, {}).step_exponent);
}

TEST(Sweep, DoesNotDependOnTheUnitOfErrors) {
  auto cells = sweep(1, four_steps, 50, 4);
  auto const law = fit_sweep(cells, {});
  for (auto& cell : cells) cell.errors *= std::ldexp(1, -900);
  auto const tiny = fit_sweep(cells, {});
  EXPECT_EQ(tiny.step_exponent, law.step_exponent);
  EXPECT_EQ(tiny.amplitude, std::ldexp(law.amplitude, -900));
}

TEST(Sweep, NeedsThreeSteps) {
  EXPECT_THAT(complaint(sweep(1, {0.01, 0.02, 0.02}, 5, 5)), testing::HasSubstr("at least 3 different steps"));
  EXPECT_THAT(complaint({}), testing::HasSubstr("at least 3 different steps"));
}

TEST(Sweep, RefusesCellsThatDifferInMoreThanTheStep) {
  auto cells = sweep(1, four_steps, 5, 6);
  cells[1].cell.compensation = true;
  EXPECT_THAT(complaint(cells), testing::HasSubstr("differ in their step alone"));
  cells[1].cell.compensation = false;
  cells[3].quantity = "casimir";
  EXPECT_THAT(complaint(cells), testing::HasSubstr("differ in their step alone"));
}

TEST(Sweep, RefusesErrorsThatDetermineNoLaw) {
  auto cells = sweep(1, four_steps, 5, 7);
  for (auto& cell : cells) cell.errors.setZero();
  EXPECT_THAT(complaint(cells), testing::HasSubstr("too few non-zero errors"));
  EXPECT_THAT(complaint(sweep(1, four_steps, 1, 7)), testing::HasSubstr("at least 2 members"));
}

}  // namespace
}  // namespace brouwer
