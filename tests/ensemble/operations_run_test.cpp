// Runs with chosen operations: a member's bits depend on (study, member) alone also where its operations are random, and
// implicit methods come to rest by every rule.
#include <brouwer/ensemble/operations.hpp>
#include <brouwer/ensemble/run.hpp>
#include <brouwer/store/file.hpp>
#include <brouwer/store/whole_file.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "tests/ensemble/small_study.hpp"
#include "tests/store/sample_unit.hpp"

namespace brouwer {
namespace {

using testing_support::small_study;
using testing_support::standard_study;

Catalogue const& catalogue() {
  static Catalogue const all = builtin_catalogue();
  return all;
}

Study stochastic_study() {
  auto study = small_study();
  study.methods = {"elliptic-naive", "dmv-8", "gauss-4"};
  study.arithmetics = {"float", "double"};
  study.rounding = {"nearest", "stochastic"};
  study.constants = {"rounded", "exact"};
  study.contraction = {false, true};
  study.quantities = {"energy"};
  study.reference = {};
  study.steps = 16;
  study.samples = {4, Samples::Spacing::linear};
  study.members = 40;
  return study;
}

bool run_into(std::filesystem::path const& folder, Study const& study, Plan const& plan, int threads,
              std::atomic<bool> const* stop = nullptr) {
  Progress progress;
  return run(study, "question = \"?\"\n", catalogue(), plan, folder, {threads, stop}, progress);
}

TEST(StochasticRounding, GivesTheSameBytesForOneAndTwoThreadsAndTakesUpWhatIsMissing) {
  Scratch const folder;
  auto const study = stochastic_study();
  auto const plan = make_plan(study, catalogue());
  ASSERT_TRUE(run_into(folder / "one", study, plan, 1));
  std::atomic<bool> const stop = true;
  ASSERT_FALSE(run_into(folder / "two", study, plan, 2, &stop));
  ASSERT_TRUE(run_into(folder / "two", study, plan, 2));
  for (std::size_t u = 0; u < plan.units.size(); u += 3) std::filesystem::remove(folder / "two" / plan.units[u].file);
  ASSERT_TRUE(run_into(folder / "two", study, plan, 2));
  for (auto const& unit : plan.units)
    EXPECT_EQ(read_whole(folder / "one" / unit.file), read_whole(folder / "two" / unit.file)) << unit.file;
}

/// All members of a cell, whatever the units.
std::vector<double> errors_of(Study const& study, Plan const& plan, std::size_t cell) {
  std::vector<double> errors;
  for (auto const& unit : plan.units) {
    if (unit.cell != cell) continue;
    Progress progress;
    auto const record = compute_unit(study, catalogue(), plan, unit, "hash", progress, nullptr).record;
    errors.insert(errors.end(), record.series[0].errors.begin(), record.series[0].errors.end());
  }
  return errors;
}

/// The plan with each cell's members in units of so many.
Plan cut(Plan plan, std::int64_t members, std::int64_t size) {
  plan.units.clear();
  for (std::size_t cell = 0; cell < plan.cells.size(); ++cell)
    for (std::int64_t first = 0; first < members; first += size)
      plan.units.push_back({cell, first, std::min(size, members - first), ""});
  return plan;
}

TEST(StochasticRounding, GivesTheSameBitsInUnitsOfAnySize) {
  auto const study = stochastic_study();
  auto const plan = make_plan(study, catalogue());
  for (std::size_t cell = 0; cell < plan.cells.size(); ++cell) {
    auto const whole = errors_of(study, cut(plan, study.members, study.members), cell);
    for (std::int64_t const size : {1, 7, 16})
      EXPECT_TRUE(same_bits(errors_of(study, cut(plan, study.members, size), cell), whole))
          << plan.cells[cell].method << ' ' << plan.cells[cell].rounding << ", units of " << size;
  }
}

TEST(StochasticRounding, OfMoreMembersLeavesTheFirstAsTheyWere) {
  auto study = stochastic_study();
  study.methods = {"elliptic-naive"};
  auto const few = make_plan(study, catalogue());
  auto more = study;
  more.members = 150;
  auto const many = make_plan(more, catalogue());
  ASSERT_NE(few.units[0].members, many.units[0].members) << "otherwise this says nothing of units";
  for (std::size_t cell = 0; cell < few.cells.size(); ++cell) {
    auto const first = errors_of(study, few, cell);
    auto all = errors_of(more, many, cell);
    all.resize(first.size());
    EXPECT_TRUE(same_bits(all, first)) << few.cells[cell].rounding;
  }
}

/// Turns a step in the mean over members; fails where a member does.
double turns(Study const& study, std::size_t cell) {
  auto const plan = make_plan(study, catalogue());
  Progress progress;
  auto const record = compute_unit(study, catalogue(), plan, plan.units.at(cell), "hash", progress, nullptr).record;
  for (auto const& reason : record.failure) EXPECT_EQ(reason, "") << plan.cells[cell].method;
  auto const& counts = record.series.at(0).errors;
  double sum = 0;
  for (double const count : counts) sum += count;
  return sum / static_cast<double>(counts.size());
}

Study study_of_turns(char const* system) {
  auto study = standard_study(catalogue().system(system));
  study.methods = {"gauss-4", "gauss-16"};
  study.arithmetics = {"float", "double"};
  study.coefficients = {"standard", "split", "symplectic"};
  study.compensation = {false};
  study.step = {std::string(system) == "outer_solar_system" ? 100.0 : 0.1};
  study.steps = 16;
  study.members = 4;
  study.perturb = {{"position", {Perturbation::Law::uniform, 1e-3}}};
  study.quantities = {"iterations"};
  study.samples = {1, Samples::Spacing::linear};
  return study;
}

class GaussMethods : public testing::TestWithParam<char const*> {};

/// Rounding that pushes one way lets the stages settle as nearest does. Random rounding never lets them stand still, but
/// seldom moves them by less than ever before: the iteration ends after some turns more; the most, 14 in place of 7, where 30
/// numbers have to be at rest in the same turn.
TEST_P(GaussMethods, ComeToRestByEveryRounding) {
  auto study = study_of_turns(GetParam());
  auto const cells = make_plan(study, catalogue()).cells.size();
  for (std::size_t cell = 0; cell < cells; ++cell) {
    double const nearest = turns(study, cell);
    for (auto const* rounding : {"up", "down", "toward-zero", "stochastic"}) {
      auto other = study;
      other.rounding = {rounding};
      EXPECT_NEAR(turns(other, cell), nearest, std::string(rounding) == "stochastic" ? 1.5 * nearest : 1)
          << rounding << ", cell " << cell;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Systems, GaussMethods,
                         testing::Values("henon_heiles", "kepler", "double_pendulum", "outer_solar_system"),
                         [](auto const& system) { return std::string(system.param); });

}  // namespace
}  // namespace brouwer
