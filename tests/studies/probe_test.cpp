// The long run is what the local errors predict: drift and diffusion beside those of an ensemble, within their errors.
#include <brouwer/ensemble/probe.hpp>
#include <brouwer/store/results.hpp>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "analysis/growth/inference.hpp"
#include "analysis/probe/probe_table.hpp"
#include "studies/read.hpp"
#include "tests/scratch.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;

Catalogue const& catalogue() {
  static auto const built = builtin_catalogue();
  return built;
}

/// A study with one cell.
struct Case {
  char const* name;
  char const* system;
  char const* integrate;
  char const* perturb;
  char const* observe;
};
void PrintTo(Case const& c, std::ostream* out) { *out << c.name; }

StudyFile study_of(Case const& c) {
  auto const text = fmt::format(
      "[system.{}]\n[integrate]\n{}\n[ensemble]\nmembers = 64\nseed = 5\nperturb = {{ {} }}\n[observe]\n{}\n"
      "samples = {{ count = 32 }}\n",
      c.system, c.integrate, c.perturb, c.observe);
  return parse_study(text, "probed.toml", catalogue());
}

/// Probed, and run into a folder of its own.
struct Probed {
  explicit Probed(Case const& c) {
    auto const file = study_of(c);
    auto const& cell = file.plan.cells.front();
    Scratch const folder;
    Progress progress;
    run(file.study, file.text, catalogue(), file.plan, folder.path(), {}, progress);
    Results const results(folder.path());
    for (auto const& errors : probe(file.study, catalogue(), cell, {}, {}).errors) {
      ProbedRow row{estimate(errors, Levels()), {}, estimate(results.load(0, errors.quantity), Levels())};
      row.prediction = predict(row.local, cell.steps);
      rows.push_back(row);
    }
  }
  std::vector<ProbedRow> rows;
};

Case const naive = {"elliptic_naive", "rigid_body", "methods = \"elliptic-naive\"\nstep = 0.01\nsteps = 20000",
                    "momentum = { uniform = 1e-2 }", "quantities = \"energy\""};
Case const pendulum = {"kutta_4", "pendulum", "methods = \"kutta-4\"\nstep = 0.1\nsteps = 3000",
                       "position = { uniform = 1e-2 }",
                       "quantities = [\"energy\", \"rounding-of-energy\"]\n"
                       "reference = { arithmetic = \"double-double\", members = 64 }"};

class LongRun : public testing::TestWithParam<Case> {};

TEST_P(LongRun, IsWhatTheLongRunShows) {
  auto const row = Probed(GetParam()).rows.back();
  EXPECT_TRUE(drift_agreement(row).agrees) << probe_text({row});
  EXPECT_TRUE(diffusion_agreement(row).agrees) << probe_text({row});
  EXPECT_NEAR(diffusion_agreement(row).ratio, 1, 0.25) << "an agreement that says something";
  EXPECT_THAT(comparison_in_words(row), HasSubstr("agrees within sampling error"));
}
INSTANTIATE_TEST_SUITE_P(
    Methods, LongRun,
    testing::Values(naive,
                    Case{"three_constants", "rigid_body",
                         "methods = \"elliptic-three-constants\"\nstep = 0.01\nsteps = 20000",
                         "momentum = { uniform = 1e-2 }", "quantities = \"energy\""},
                    Case{"compensated_dmv_2", "rigid_body",
                         "methods = \"dmv-2\"\ncompensation = true\nstep = 0.04\nsteps = 20000",
                         "momentum = { uniform = 1e-2 }", "quantities = \"energy\""},
                    Case{"gauss_16", "henon_heiles",
                         "methods = \"gauss-16\"\ncoefficients = \"standard\"\nstep = 0.3\nsteps = 10000",
                         "position = { uniform = 1e-2 }", "quantities = \"energy\""},
                    Case{"naive_by_stochastic_rounding", "rigid_body",
                         "methods = \"elliptic-naive\"\nrounding = \"stochastic\"\nstep = 0.01\nsteps = 5000",
                         "momentum = { uniform = 1e-2 }", "quantities = \"energy\""},
                    pendulum),
    [](auto const& test) { return test.param.name; });

TEST(Probed, FindsTheDriftOfTheTextbooksConstantsInRounding) {
  auto const row = Probed(naive).rows.front();
  EXPECT_LT(row.local.rounding.bias.p, 1e-6);
  EXPECT_NEAR(row.prediction->drift.per_step, -2.2e-17, 6e-18);
  EXPECT_NEAR(row.prediction->diffusion.per_sqrt_step, 2.4e-16, 5e-17);
  EXPECT_THAT(cause_in_words(row.local), HasSubstr("Rounding is biased by"));
  EXPECT_THAT(cause_in_words(row.local), HasSubstr("the method conserves it"));
}

TEST(Probed, TellsTheDriftOfTheMethodFromRounding) {
  auto const rows = Probed(pendulum).rows;
  auto const& energy = rows.front();
  ASSERT_TRUE(energy.local.truncation && energy.local.both);
  EXPECT_LT(energy.local.truncation->bias.p, 1e-6);
  EXPECT_GT(std::abs(energy.local.truncation->bias.per_step), 1e3 * std::abs(energy.local.rounding.bias.per_step));
  EXPECT_NEAR(energy.prediction->drift.per_step / energy.observed->drift.per_step, 1, 0.2);
  EXPECT_THAT(cause_in_words(energy.local), HasSubstr("the method itself changes it by"));
  EXPECT_THAT(cause_in_words(rows.back().local), HasSubstr("No bias of rounding is seen"));
}

TEST(Probed, IsWrittenAsJson) {
  auto const json = probe_json(Probed(naive).rows);
  for (auto const* key : {"\"rounding\"", "\"truncation\"", "\"predicted\"", "\"observed\"", "\"sigma_by_scale\"",
                          "\"agrees\": true", "\"cause\": \"Rounding is biased"})
    EXPECT_THAT(json, HasSubstr(key));
}

}  // namespace
}  // namespace brouwer
