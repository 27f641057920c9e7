// What the calibration rests on: its random numbers, its bounds, the page that it writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <brouwer/error.hpp>
#include <brouwer/store/whole_file.hpp>
#include <cmath>
#include <functional>
#include <memory>

#include "tests/calibration/document.hpp"
#include "tests/calibration/experiment.hpp"
#include "tests/calibration/philox.hpp"

namespace brouwer::calibration {

void PrintTo(Design const& design, std::ostream* out) { *out << design.name(); }

namespace {

TEST(Philox, IsThePublishedGenerator) {
  // the first block of counter 0 and key 0 in Random123's kat_vectors, low halves first
  std::unique_ptr<gsl_rng, void (*)(gsl_rng*)> const rng(gsl_rng_alloc(philox()), gsl_rng_free);
  gsl_rng_set(rng.get(), 0);
  for (unsigned long const half : {0xca36314cUL, 0x16554d9eUL, 0x672d0fdcUL, 0xdb20fe9dUL})
    EXPECT_EQ(gsl_rng_get(rng.get()), half) << std::hex << half;
}

TEST(Bounds, AreQuantilesOfTheBinomialLaw) {
  Nominal const nominal{0.05, 0, Nominal::Side::false_alarm};
  auto const [low, high] = bounds(nominal, 100);
  double below = 0, term = std::pow(0.95, 100);  // P(X = k), k = 0, 1, …
  int k = 0;
  for (; 1 - (below + term) > out_of_bounds; ++k) {
    below += term;
    term *= (100.0 - k) / (k + 1) * 0.05 / 0.95;
  }
  EXPECT_EQ(low, 0);  // P(X = 0) = 0.0059 is more than the level
  EXPECT_DOUBLE_EQ(high, k / 100.0);
}

TEST(Bounds, TellWhichSideIsHarmful) {
  Nominal const interval{0.95, 0, Nominal::Side::coverage}, alarm{0.05, 0, Nominal::Side::false_alarm};
  EXPECT_EQ(standing({950, 1000}, interval), Standing::holds);
  EXPECT_EQ(standing({900, 1000}, interval), Standing::fails);
  EXPECT_EQ(standing({1000, 1000}, interval), Standing::safe);
  EXPECT_EQ(standing({100, 1000}, alarm), Standing::fails);
  EXPECT_EQ(standing({0, 1000}, alarm), Standing::safe);
}

TEST(Bounds, AreWiderByWhatAnApproximationIsAllowed) {
  Nominal const exact{0.95, 0, Nominal::Side::coverage}, nearly{0.95, 0.02, Nominal::Side::coverage};
  EXPECT_EQ(standing({920, 1000}, exact), Standing::fails);
  EXPECT_EQ(standing({920, 1000}, nearly), Standing::holds);
}

TEST(Experiment, DoesNotDependOnThreads) {
  Design const design{8, 8, Spacing::irregular, 50};
  int const threads = omp_get_max_threads();
  omp_set_num_threads(1);
  auto const one = tally(model("all"), design);
  omp_set_num_threads(3);
  auto const three = tally(model("all"), design);
  omp_set_num_threads(threads);
  EXPECT_EQ(one.verdicts, three.verdicts);
  ASSERT_EQ(one.rates.size(), claims().size());
  for (std::size_t k = 0; k < one.rates.size(); ++k) EXPECT_EQ(one.rates[k].hits, three.rates[k].hits);
}

TEST(Experiment, GivesEveryTrialItsOwnNumbers) {
  Design const design{2, 4, Spacing::linear, 2};
  auto const first = ensemble_of(model("walk"), design, 0).errors;
  EXPECT_EQ(first, ensemble_of(model("walk"), design, 0).errors);
  EXPECT_NE(first, ensemble_of(model("walk"), design, 1).errors);
  EXPECT_NE(first, ensemble_of(model("drift"), design, 0).errors);
}

class EveryDesign : public testing::TestWithParam<Design> {};

TEST_P(EveryDesign, HasIncreasingTimesToTheEnd) {
  auto const times = GetParam().times();
  EXPECT_EQ(std::ssize(times), GetParam().samples);
  EXPECT_GT(times.front(), 0);
  EXPECT_EQ(std::adjacent_find(times.begin(), times.end(), std::greater_equal()), times.end());
  EXPECT_EQ(times.back(), duration);
}
INSTANTIATE_TEST_SUITE_P(OfThePage, EveryDesign, testing::ValuesIn(designs().begin(), designs().end()));

TEST(Document, ReplacesItsPartAndLeavesTheRest) {
  auto const file = std::filesystem::path(testing::TempDir()) / "calibration_page.md";
  write_whole(file, "before\n<!-- rates: by a program -->\nold\n<!-- end of rates -->\nafter\n");
  replace_part(file, "rates", "new\n");
  EXPECT_EQ(read_whole(file), "before\n<!-- rates: by a program -->\n\nnew\n\n<!-- end of rates -->\nafter\n");
  EXPECT_THROW(replace_part(file, "speed", ""), InputError);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace brouwer::calibration
