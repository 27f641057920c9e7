// A member's result depends on (study, member, arithmetic) alone: not on threads, units, resumption, or other members.
#include <brouwer/ensemble/run.hpp>
#include <brouwer/ensemble/start.hpp>
#include <brouwer/error.hpp>
#include <brouwer/store/file.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "tests/ensemble/small_study.hpp"

namespace brouwer {
namespace {

namespace fs = std::filesystem;
using testing_support::small_study;

struct RunOfAStudy : testing::Test {
  Catalogue const catalogue = builtin_catalogue();
  Study const study = small_study();
  Plan const plan = make_plan(study, catalogue);
  fs::path const folder = fs::temp_directory_path() / ("brouwer-run-" + std::to_string(::getpid()) + "-" +
                                                       testing::UnitTest::GetInstance()->current_test_info()->name());
  ~RunOfAStudy() override { fs::remove_all(folder); }

  bool run_into(fs::path const& where, int threads, std::atomic<bool> const* stop = nullptr) const {
    Progress progress;
    return run(study, "question = \"?\"\n", catalogue, plan, where, {threads, stop}, progress);
  }
  static std::string bytes(fs::path const& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(RunOfAStudy, GivesTheSameBytesForOneAndTwoThreads) {
  ASSERT_TRUE(run_into(folder / "one", 1));
  ASSERT_TRUE(run_into(folder / "two", 2));
  for (auto const& unit : plan.units) {
    auto const one = bytes(folder / "one" / unit.file);
    EXPECT_FALSE(one.empty());
    EXPECT_EQ(one, bytes(folder / "two" / unit.file)) << unit.file;
  }
}

TEST_F(RunOfAStudy, TakesUpWhatIsMissingAndLeavesTheRest) {
  ASSERT_TRUE(run_into(folder, 2));
  auto const lost = plan.units[1].file, kept = plan.units[0].file;
  auto const before = bytes(folder / lost);
  auto const written = fs::last_write_time(folder / kept);
  fs::remove(folder / lost);
  ASSERT_TRUE(run_into(folder, 2));
  EXPECT_EQ(bytes(folder / lost), before);
  EXPECT_EQ(fs::last_write_time(folder / kept), written);
}

TEST_F(RunOfAStudy, StopsWithoutHalfAUnit) {
  std::atomic<bool> const stop = true;
  EXPECT_FALSE(run_into(folder, 2, &stop));
  for (auto const& unit : plan.units) EXPECT_FALSE(fs::exists(folder / unit.file));
}

TEST_F(RunOfAStudy, RefusesTheFolderOfAnotherStudy) {
  ASSERT_TRUE(run_into(folder, 2));
  auto other = study;
  other.step = {0.06};
  Progress progress;
  try {
    run(other, "", catalogue, make_plan(other, catalogue), folder, {1, nullptr}, progress);
    FAIL() << "accepted";
  } catch (InputError const& error) {
    EXPECT_NE(std::string(error.what()).find("step"), std::string::npos) << error.what();
  }
}

TEST_F(RunOfAStudy, ReportsADamagedUnitAndKeepsIt) {
  ASSERT_TRUE(run_into(folder, 1));
  auto const file = folder / plan.units[0].file;
  std::ofstream(file, std::ios::binary | std::ios::trunc) << "not a unit";
  EXPECT_THROW(run_into(folder, 1), RunError);
  EXPECT_EQ(bytes(file), "not a unit");
}

TEST_F(RunOfAStudy, GivesAMemberAloneTheBitsThatItHasInTheEnsemble) {
  ASSERT_TRUE(run_into(folder, 2));
  for (auto const& unit : plan.units) {
    auto const record = read_unit(folder / unit.file);
    auto const& cell = plan.cells[unit.cell];
    std::int64_t const i = unit.members - 1;
    auto const start = member_start(study, catalogue.system("rigid_body"), unit.first_member + i);
    auto const alone = begin_trajectory(catalogue, cell, start, true);
    alone->advance(cell.steps);
    std::vector<Widest> last(7);
    alone->state(0, last);
    std::vector<double> errors(6);
    alone->first_integral_errors(errors);
    for (std::size_t c = 0; c < 7; ++c)
      EXPECT_EQ(record.final_state[static_cast<std::size_t>(i) * 7 + c], static_cast<double>(last[c]));
    EXPECT_EQ(record.series[0].errors.at(static_cast<std::size_t>(i + 1) * 8 - 1), errors[0]) << record.series[0].name;
  }
}

TEST_F(RunOfAStudy, ComparesAsManyMembersAsAskedAndTheExactFlowAgrees) {
  ASSERT_TRUE(run_into(folder, 2));
  auto const record = read_unit(folder / plan.units[0].file);
  int compared = 0;
  for (auto const& series : record.series) {
    EXPECT_EQ(series.members, series.quantity == "state" ? 4 : 16) << series.name;
    EXPECT_EQ(series.errors.size(), static_cast<std::size_t>(series.members) * 8);
    for (double e : series.errors) EXPECT_LT(std::abs(e), 1e-12) << series.name;  // the increment form is exact
    compared += series.quantity == "state";
  }
  EXPECT_EQ(compared, 6);
}

TEST(Reference, OfAFloatRunStartsFromTheSameRoundedNumbers) {
  auto study = small_study();
  auto const catalogue = builtin_catalogue();
  study.arithmetics = {"float"};
  study.compensation = {false};
  study.methods = {"dmv-2"};
  study.quantities = {"state", "phase"};
  study.samples = {1, Samples::Spacing::linear};
  study.steps = 1;
  study.reference = {Reference::Kind::same_method, "float128", 4};
  auto const plan = make_plan(study, catalogue);
  Progress progress;
  auto const outcome = compute_unit(study, catalogue, plan, plan.units[0], "hash", progress, nullptr);
  ASSERT_TRUE(outcome.finished);
  // one step errs by a few roundings; a step or a start that were not rounded alike would show as 10⁻⁸·h or more
  for (auto const& series : outcome.record.series)
    for (double e : series.errors) EXPECT_LT(std::abs(e), 3e-7) << series.name;
  for (double x : outcome.record.start) EXPECT_EQ(x, static_cast<double>(static_cast<float>(x)));
}

TEST(Reference, InWiderArithmeticIsTheSameMethodSoThatTruncationCancels) {
  auto study = small_study();
  auto const catalogue = builtin_catalogue();
  study.compensation = {false};
  study.methods = {"dmv-2"};
  study.quantities = {"phase"};
  study.steps = 500;
  auto const worst = [&](Reference const& reference) {
    study.reference = reference;
    auto const plan = make_plan(study, catalogue);
    Progress progress;
    auto const record = compute_unit(study, catalogue, plan, plan.units[0], "hash", progress, nullptr).record;
    double largest = 0;
    for (double e : record.series[0].errors) largest = std::max(largest, std::abs(e));
    return largest;
  };
  EXPECT_LT(worst({Reference::Kind::same_method, "float128", 3}), 1e-12);  // round-off alone
  EXPECT_LT(worst({Reference::Kind::same_method, "mpfr-256", 3}), 1e-12);
  EXPECT_GT(worst({Reference::Kind::exact, "", 3}), 1e-4);  // with the truncation error of order 2
}

TEST(FinalState, HoldsOnlyWhatWasIntegrated) {
  auto study = small_study();
  study.quantities = {"energy"};
  study.reference = {};
  auto const catalogue = builtin_catalogue();
  auto const plan = make_plan(study, catalogue);
  Progress progress;
  auto const record = compute_unit(study, catalogue, plan, plan.units[0], "hash", progress, nullptr).record;
  EXPECT_EQ(record.state_names, (std::vector<std::string>{"y1", "y2", "y3"}));
  EXPECT_EQ(record.final_state.size(), 3U * 16U);
}

TEST(FailedMember, IsMarkedAndLeavesTheOthersAlone) {
  auto study = small_study();
  auto const catalogue = builtin_catalogue();
  study.methods = {"dmv-2"};
  study.compensation = {false};
  study.step = {0.9};  // the fixed-point iteration settles for some starts only
  study.perturb = {{"momentum", {Perturbation::Law::uniform, 1.5}}};
  study.quantities = {"energy"};
  study.reference = {};
  auto const plan = make_plan(study, catalogue);
  Progress progress;
  auto const record = compute_unit(study, catalogue, plan, plan.units[0], "hash", progress, nullptr).record;
  int failed = 0, good = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    double const last = record.series[0].errors[i * 8 + 7];
    if (std::isnan(last))
      ++failed;
    else if (std::abs(last) < 1e-12)
      ++good;
  }
  EXPECT_GT(failed, 0);
  EXPECT_GT(good, 0);
  EXPECT_EQ(failed + good, 16);
}

}  // namespace
}  // namespace brouwer
