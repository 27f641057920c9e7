// Figures: one file a quantity and kind, with the script and the data that make it; hostile names stay words.
#include "analysis/figures/plots.hpp"

#include <gmock/gmock.h>

#include <brouwer/error.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "analysis/figures/figure_family.hpp"
#include "tests/analysis/presented_estimates.hpp"

namespace brouwer {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string content(fs::path const& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

bool have_gnuplot() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }

struct Figure : testing::Test {
  fs::path folder =
      fs::path(testing::TempDir()) / "brouwer_figures" / testing::UnitTest::GetInstance()->current_test_info()->name();
  std::vector<Estimates> rows = {presented_estimates("elliptic-naive", "energy", -2.31e-17),
                                 presented_estimates("elliptic-three-constants", "energy", 0),
                                 presented_estimates("elliptic-naive", "spatial-momentum-1", 0)};
  std::vector<std::vector<double>> final_errors = std::vector<std::vector<double>>(3, {-2, -1, -1, 0, 0, 0, 1, 1, 2});

  void SetUp() override { fs::remove_all(folder); }
  void TearDown() override { fs::remove_all(folder); }
};

TEST_F(Figure, OfEachKindIsDrawnForEachQuantity) {
  if (!have_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
  auto const figures = draw_figures(rows, final_errors, folder, "svg");
  EXPECT_EQ(figures.note, "");
  EXPECT_EQ(figures.files.size(), 6u);
  for (auto const* kind : {"growth", "histogram", "mean"})
    for (auto const* name : {"energy", "spatial-momentum"}) {
      auto const stem = std::string(kind) + "-" + name;
      EXPECT_THAT(content(folder / (stem + ".svg")), AllOf(HasSubstr("<svg"), HasSubstr("</svg>"))) << stem;
      EXPECT_TRUE(fs::exists(folder / (stem + ".gp")) && fs::exists(folder / (stem + ".dat"))) << stem;
    }
}

TEST_F(Figure, IsDrawnInEveryFormat) {
  if (!have_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
  EXPECT_THAT(content(draw_figures({rows[0]}, {}, folder, "png").files.at(0)), testing::StartsWith("\x89PNG"));
  EXPECT_THAT(content(draw_figures({rows[0]}, {}, folder, "pdf").files.at(0)), testing::StartsWith("%PDF"));
  EXPECT_THROW(draw_figures(rows, final_errors, folder, "svgg"), InputError);
}

TEST_F(Figure, NeedsFinalErrorsForItsHistogramOnly) {
  auto const all = families(rows, {});
  EXPECT_TRUE(histogram_sheet(all[0]).panels.empty());
  EXPECT_FALSE(growth_sheet(all[0]).panels.empty());
}

TEST_F(Figure, TakesAnyNameAsWordsAndRunsNoneOfThem) {
  auto const trap = folder / "executed", trap2 = folder / "executed2";
  for (auto& row : rows) {
    row.cell.method += "`touch " + trap.string() + "`'; system('touch " + trap2.string() + "'); '\n\"_^{@&~}\\";
    row.quantity = row.family = "../energy'\n`touch " + trap.string() + "`; system(\"touch " + trap2.string() + "\")";
  }
  auto const figures = draw_figures(rows, final_errors, folder, "svg");
  EXPECT_EQ(figures.note.empty(), have_gnuplot()) << figures.note;
  EXPECT_FALSE(fs::exists(trap) || fs::exists(trap2));
  for (auto const& file : figures.files) EXPECT_EQ(file.parent_path(), folder);
}

TEST_F(Figure, OfAnExactOrBrokenQuantityIsDrawnAllTheSame) {
  if (!have_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
  rows[0].rms = rows[0].mean = rows[0].mean_error = {0, 0, 0};
  rows[0].drift = {};
  rows[0].diffusion = {};
  rows[1].rms = rows[1].mean = rows[1].mean_error = {std::nan(""), std::nan(""), std::nan("")};
  rows[1].quantity = rows[1].family = "broken";
  final_errors[0] = {0};
  final_errors[1] = {0, 0};
  auto const figures = draw_figures(rows, final_errors, folder, "svg");
  EXPECT_EQ(figures.note, "");
  EXPECT_EQ(figures.files.size(), 9u);
}

TEST_F(Figure, KeepsScriptsAndDataWhereGnuplotIsMissing) {
  std::string const path = std::getenv("PATH") == nullptr ? "" : std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  auto const figures = draw_figures(rows, final_errors, folder, "svg");
  setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(figures.files.empty());
  EXPECT_THAT(figures.note, AllOf(HasSubstr("gnuplot is not installed"), HasSubstr(folder.string())));
  EXPECT_TRUE(fs::exists(folder / "growth-energy.gp") && fs::exists(folder / "growth-energy.dat"));
}

TEST_F(Figure, RefusesAFolderThatCannotBeMade) {
  std::ofstream(fs::path(testing::TempDir()) / "brouwer_no_folder") << "a file";
  EXPECT_THROW(draw_figures(rows, final_errors, fs::path(testing::TempDir()) / "brouwer_no_folder/x", "svg"), RunError);
}

TEST_F(Figure, HasADistinctColourForEachOfAFewCellsAndMarksWhereColoursRepeat) {
  std::vector<Estimates> many;
  for (double const h : {0.01, 0.02, 0.04, 0.08})
    for (auto const* method : {"a", "b", "c", "d", "e"}) {
      many.push_back(presented_estimates(method, "energy", 0));
      many.back().cell.step = h;
    }
  auto const family = families(many, {}).at(0);
  EXPECT_EQ(family.colours[0], family.colours[5]) << "one method, one colour";
  EXPECT_NE(family.colours[0], family.colours[1]);
  EXPECT_NE(family.marks[0], family.marks[5]) << "two steps, two marks";
  auto const few = families({many.begin(), many.begin() + 7}, {}).at(0);
  EXPECT_EQ(std::set<std::string>(few.colours.begin(), few.colours.end()).size(), 7u);
}

/// χ²(64) gives a band from 1/√1.38 to 1/√0.68 of the RMS at 95 % where the mean is zero.
TEST_F(Figure, GivesTheRmsTheBandOfItsChiSquared) {
  auto row = rows[1];
  row.times = {1};
  row.rms = {1};
  row.mean = row.mean_error = {0};
  std::istringstream data(growth_sheet(families({row}, {}).at(0)).data);
  std::string comment;
  std::getline(data, comment);
  std::getline(data, comment);
  double t = 0, rms = 0, low = 0, high = 0;
  data >> t >> rms >> low >> high;
  EXPECT_NEAR(low, std::sqrt(64 / 88.004), 2e-4);  // χ²(64) quantiles at 0.975 and 0.025
  EXPECT_NEAR(high, std::sqrt(64 / 43.776), 2e-4);
}

TEST(Notes, AreJoinedAndSayNothingTwice) {
  EXPECT_EQ(joined_notes("a", "b"), "a; b");
  EXPECT_EQ(joined_notes("", "b"), "b");
  EXPECT_EQ(joined_notes("a", ""), "a");
  EXPECT_EQ(joined_notes("a", "c; a"), "c; a");
}

}  // namespace
}  // namespace brouwer
