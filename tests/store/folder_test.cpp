// A result folder belongs to one study, is made whole or taken up, and nothing foreign is touched.
#include <brouwer/store/folder.hpp>

#include <fstream>
#include <gmock/gmock.h>

#include <brouwer/error.hpp>
#include <brouwer/store/plan_text.hpp>
#include <brouwer/store/whole_file.hpp>

#include "tests/store/sample_unit.hpp"

namespace brouwer {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

std::string const text_here = "members = 64\nstep = 0x1.47ae147ae147bp-7\nmethods = elliptic-naive\n";
std::string const text_there = "members = 64\nstep = 0x1.47ae147ae147bp-6\nseed = 1\nmethods = elliptic-naive\n";

Provenance machine(std::string const& name, std::string const& date) { return {{{"cpu", name}, {"date", date}}}; }

void create(std::filesystem::path const& folder, std::string const& hash = "here", std::string const& text = text_here,
            Provenance const& provenance = machine("one", "Monday")) {
  create_result_folder(folder, hash, text, "question = \"?\"\n", provenance, {sample_cell(), sample_cell()});
}

TEST(ResultFolder, HoldsTheStudyThePlanAndWithWhatItWasMade) {
  Scratch const scratch;
  create(scratch / "a/b");
  EXPECT_EQ(read_whole(scratch / "a/b/study.toml"), "question = \"?\"\n");
  EXPECT_EQ(read_whole(scratch / "a/b/provenance.txt"), "cpu = one\ndate = Monday\n");
  EXPECT_TRUE(std::filesystem::is_directory((scratch / "a/b") / cell_path(1)));
  auto const plan = read_plan(scratch / "a/b");
  EXPECT_EQ(plan.study_hash, "here");
  EXPECT_EQ(plan.canonical_text, text_here);
  EXPECT_EQ(plan.cells, std::vector(2, sample_cell()));
}

TEST(ResultFolder, IsTakenUpByTheSameStudy) {
  Scratch const scratch;
  create(scratch.path());
  auto const unit = scratch / unit_path(0, 64);
  write_unit(unit, sample_unit());
  std::ofstream(scratch / "units/cell-000/.tmp-1-0-members-000000.h5") << "half";
  create(scratch.path());
  EXPECT_TRUE(same(read_unit(unit), sample_unit()));
  EXPECT_FALSE(std::filesystem::exists(scratch / "units/cell-000/.tmp-1-0-members-000000.h5"));
}

TEST(ResultFolder, NotesEachMachineOnce) {
  Scratch const scratch;
  create(scratch.path());
  create(scratch.path(), "here", text_here, machine("one", "Tuesday"));
  create(scratch.path(), "here", text_here, machine("two", "Wednesday"));
  create(scratch.path(), "here", text_here, machine("two", "Thursday"));
  EXPECT_EQ(read_whole(scratch / "provenance.txt"), "cpu = one\ndate = Monday\n\ncpu = two\ndate = Wednesday\n");
}

TEST(ResultFolder, IsRefusedToAnotherStudyWithWhatDiffers) {
  Scratch const scratch;
  create(scratch.path(), "there", text_there);
  EXPECT_THAT([&] { create(scratch.path()); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("step was 0.02 there and is 0.01 here"),
                                              HasSubstr("seed was 1 there and is not given here"),
                                              testing::Not(HasSubstr("members")))));
  EXPECT_EQ(read_plan(scratch.path()).study_hash, "there");
}

TEST(ResultFolder, HasNoDifferenceWhereThereIsNone) {
  Scratch const scratch;
  EXPECT_EQ(difference_to(scratch / "none", "here", text_here), std::nullopt);
  EXPECT_EQ(difference_to(scratch.path(), "here", text_here), std::nullopt);
  create(scratch.path());
  EXPECT_EQ(difference_to(scratch.path(), "here", text_here), std::nullopt);
}

TEST(ResultFolder, LeavesForeignFilesAlone) {
  Scratch const scratch;
  std::ofstream(scratch / "study.toml") << "mine";
  EXPECT_THAT([&] { create(scratch.path()); }, ThrowsMessage<InputError>(HasSubstr("holds other files")));
  EXPECT_EQ(read_whole(scratch / "study.toml"), "mine");
  EXPECT_FALSE(std::filesystem::exists(scratch / "units"));
  EXPECT_THAT([&] { create(scratch / "study.toml"); }, ThrowsMessage<InputError>(HasSubstr("is a file")));
  EXPECT_THAT([&] { create(scratch / "study.toml/results"); }, ThrowsMessage<InputError>(HasSubstr("Not a directory")));
  EXPECT_THAT([&] { create(""); }, ThrowsMessage<InputError>(HasSubstr("result folder")));
}

TEST(ResultFolder, IsMadeAfreshWhereMakingItWasInterrupted) {
  Scratch const scratch;
  create(scratch.path());
  std::filesystem::remove(scratch / "plan.txt");
  std::ofstream(scratch / ".tmp-1-0-plan.txt") << "stud";
  create(scratch.path(), "other", text_there);
  EXPECT_EQ(read_plan(scratch.path()).study_hash, "other");
  EXPECT_FALSE(std::filesystem::exists(scratch / ".tmp-1-0-plan.txt"));
}

TEST(ResultFolder, WithoutAPlanKeepsUnitsThatItCannotExplain) {
  Scratch const scratch;
  create(scratch.path());
  write_unit(scratch / unit_path(0, 64), sample_unit());
  std::filesystem::remove(scratch / "plan.txt");
  EXPECT_THROW(create(scratch.path()), InputError);
  EXPECT_TRUE(std::filesystem::exists(scratch / unit_path(0, 64)));
}

TEST(PlanText, ReturnsEveryBitOfTheStep) {
  FolderPlan plan{"hash", text_here, {}};
  for (double const step : {0.1, 0.1 + 0.2, 1e-300, 5e-324, -0.0, 1e22, 1.0 / 3.0}) {
    plan.cells = {sample_cell()};
    plan.cells[0].step = step;
    auto const back = plan_of_text(to_text(plan));
    ASSERT_EQ(back.cells.size(), 1U);
    EXPECT_TRUE(same_bits({back.cells[0].step}, {step})) << step;
    EXPECT_EQ(back.canonical_text, text_here);
  }
}

TEST(PlanText, SaysNothingOfOperationsThatAreTheProcessors) {
  CellLabels const standard;
  CellLabels cell = sample_cell();
  cell.rounding = standard.rounding;
  cell.constants = standard.constants;
  cell.contraction = standard.contraction;
  auto const text = to_text(FolderPlan{"hash", text_here, {cell}});
  EXPECT_THAT(text, testing::Not(HasSubstr("rounding")));
  EXPECT_THAT(text, testing::Not(HasSubstr("contraction")));
  EXPECT_EQ(plan_of_text(text).cells, std::vector{cell});
}

TEST(PlanText, FromBeforeTheFactorCoefficientsHasNone) {
  FolderPlan plan{"hash", text_here, {sample_cell()}};
  auto text = to_text(plan);
  std::string const level = "coefficients = per-trajectory, ";
  ASSERT_NE(text.find(level), std::string::npos);
  plan.cells[0].coefficients = no_level;
  EXPECT_EQ(plan_of_text(text.erase(text.find(level), level.size())).cells, plan.cells);
}

TEST(PlanText, SaysWhatIsDamaged) {
  EXPECT_THROW(plan_of_text(""), std::invalid_argument);
  EXPECT_THROW(plan_of_text("members = 3\n"), std::invalid_argument);
  EXPECT_THAT([] { plan_of_text("study = x\ncell 0: system = a, method = b\n"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("cell 0 lacks arithmetic")));
  auto const text = to_text(FolderPlan{"hash", text_here, {sample_cell()}});
  for (std::size_t length = 0; length < text.size(); ++length) try {
      plan_of_text(text.substr(0, length));
    } catch (std::invalid_argument const&) {
    }
}

}  // namespace
}  // namespace brouwer
