// Error against work: which runs belong on one line, and how lines are told apart.
#include "analysis/figures/precision.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "analysis/figures/plots.hpp"
#include "tests/analysis/presented_estimates.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A method of order p to the time 10: its error is h^p.
std::vector<Estimates> order(std::string const& method, int p, std::vector<double> const& steps,
                             std::string const& quantity = "energy") {
  std::vector<Estimates> rows;
  for (double const h : steps) {
    auto row = presented_estimates(method, quantity, 0);
    row.cell.step = h;
    row.cell.steps = std::lround(10 / h);
    row.rms_final = std::pow(h, p);
    rows.push_back(row);
  }
  return rows;
}

std::vector<Estimates> joined(std::vector<Estimates> a, std::vector<Estimates> const& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(WorkPrecision, IsALineAMethodByNumberOfSteps) {
  auto const rows = joined(order("gauss-1", 2, {0.1, 0.05, 0.2}), order("gauss-2", 4, {0.1, 0.2}));
  auto const work = work_precision(families(rows, {}).at(0));
  ASSERT_EQ(work.lines.size(), 2u);
  EXPECT_DOUBLE_EQ(work.time, 10);
  std::vector<double> steps;
  for (auto const& point : work.lines[0].points) steps.push_back(point.steps);
  EXPECT_THAT(steps, ElementsAre(50, 100, 200));
  EXPECT_DOUBLE_EQ(work.lines[1].points[0].error, std::pow(0.2, 4));
  EXPECT_FALSE(work.has_cpu_seconds());
}

TEST(WorkPrecision, OfSeveralComponentsIsTheirEuclideanNorm) {
  auto const rows =
      joined(order("a", 1, {0.1, 0.2}, "spatial-momentum-1"), order("a", 1, {0.1, 0.2}, "spatial-momentum-1"));
  auto two = rows;
  two[2].quantity = two[3].quantity = "spatial-momentum-2";
  two[2].rms_final = 0.2 * 4 / 3;  // 3 : 4 : 5
  two[0].rms_final = 0.2;
  auto const work = work_precision(families(two, {}).at(0));
  ASSERT_EQ(work.lines.size(), 1u);
  EXPECT_DOUBLE_EQ(work.lines[0].points[1].error, 0.2 * 5 / 3);
}

TEST(WorkPrecision, TakesWhatEndsAtTheCommonTimeUpToOneStep) {
  auto rows = order("a", 2, {0.1, 0.3, 0.5, 1});
  rows[1].cell.steps = 33;   // 9.9: h does not divide 10
  rows[3].cell.steps = 100;  // 100
  auto const work = work_precision(families(rows, {}).at(0));
  ASSERT_EQ(work.lines.size(), 1u);
  EXPECT_EQ(work.lines[0].points.size(), 3u);
}

TEST(WorkPrecision, NeedsTwoStepsThatEndAtOneTimeAndAnError) {
  auto rows = order("a", 2, {0.1, 0.2});
  rows[0].cell.steps *= 3;
  EXPECT_TRUE(work_precision(families(rows, {}).at(0)).lines.empty());
  rows = order("a", 2, {0.1, 0.2});
  rows[0].rms_final = 0;
  EXPECT_TRUE(work_precision(families(rows, {}).at(0)).lines.empty());
  rows = order("a", 2, {0.1, 0.2});
  for (auto& row : rows) row.count = {14, {13, 15}};
  EXPECT_TRUE(work_precision(families(rows, {}).at(0)).lines.empty());
  EXPECT_TRUE(precision_sheet(families(rows, {}).at(0)).panels.empty());
}

TEST(WorkPrecision, TellsArithmeticsApart) {
  auto rows = joined(order("a", 2, {0.1, 0.2}), order("a", 2, {0.1, 0.2}));
  rows[2].cell.arithmetic = rows[3].cell.arithmetic = "float";
  auto const sheet = precision_sheet(families(rows, {}).at(0));
  ASSERT_EQ(sheet.legend.size(), 2u);
  EXPECT_EQ(sheet.legend[1].text, "float");
  EXPECT_NE(sheet.legend[0].style, sheet.legend[1].style);
}

TEST(WorkPrecision, TellsNothingOfAnOptionThatOnlySomeMethodsHave) {
  auto rows = joined(order("dmv-2", 2, {0.1, 0.2}), order("dmv-4", 4, {0.1, 0.2}));
  rows[2].cell.coefficients = rows[3].cell.coefficients = "per-trajectory";
  auto sheet = precision_sheet(families(rows, {}).at(0));
  EXPECT_EQ(sheet.legend[1].text, "dmv-4");
  EXPECT_THAT(sheet.legend[1].style, HasSubstr(" dt 1 "));
  auto const both = order("dmv-4", 4, {0.1, 0.2});
  rows = joined(rows, both);
  rows[4].cell.coefficients = rows[5].cell.coefficients = "per-step";
  sheet = precision_sheet(families(rows, {}).at(0));
  EXPECT_EQ(sheet.legend[1].text, "dmv-4, per-trajectory coefficients");
  EXPECT_THAT(sheet.legend[2].style, Not(HasSubstr(" dt 1 ")));
}

TEST(Series, OfMethodsAreNamedAlikeButForTheirNumbers) {
  EXPECT_EQ(series_of("dmv-2"), series_of("dmv-10"));
  EXPECT_NE(series_of("gauss-4-split"), series_of("gauss-4"));
  EXPECT_EQ(paler("#0072b2", 0), "#0072b2");
  EXPECT_EQ(paler("#0072b2", 1), "#ffffff");
}

TEST(PrecisionFigure, HasASecondPanelWhereTimesAreKnown) {
  auto const rows = order("a", 2, {0.1, 0.2});
  auto const without = precision_sheet(families(rows, {}).at(0));
  ASSERT_EQ(without.panels.size(), 1u);
  EXPECT_THAT(without.subtitle, HasSubstr("CPU times were not recorded"));
  EXPECT_EQ(without.stem, "precision-energy");
  auto const with = precision_sheet(families(rows, {}, {0.2, 0.1}).at(0));
  ASSERT_EQ(with.panels.size(), 2u);
  EXPECT_THAT(with.subtitle, Not(HasSubstr("CPU")));
  EXPECT_EQ(with.panels[1].x_label, "CPU seconds per member");
  EXPECT_THAT(with.data, HasSubstr("\n50 0.04 0.1\n100 0.01 0.2\n"));
}

TEST(PrecisionFigure, IsDrawn) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no gnuplot";
  auto const folder = std::filesystem::path(testing::TempDir()) / "brouwer_precision";
  auto const figures = draw_figures(order("a", 2, {0.1, 0.2}), {}, folder, "svg", {0.2, 0.1});
  EXPECT_EQ(figures.note, "");
  EXPECT_TRUE(std::filesystem::exists(folder / "precision-energy.svg"));
  std::filesystem::remove_all(folder);
}

TEST(CountFigure, TakesThePlaceOfThoseOfAnError) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no gnuplot";
  auto rows = order("a", 2, {0.1, 0.2}, "iterations");
  for (auto& row : rows) row.count = {14, {13, 15}};
  auto const folder = std::filesystem::path(testing::TempDir()) / "brouwer_counts";
  auto const figures = draw_figures(rows, {{1, 2}, {1, 2}}, folder, "svg");
  EXPECT_EQ(figures.note, "");
  EXPECT_THAT(figures.files, ElementsAre(folder / "count-iterations.svg"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace brouwer
