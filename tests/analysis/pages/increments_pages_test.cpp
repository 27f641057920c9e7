// Where people read of increments and decisions: report, page, figure, table.
#include <gmock/gmock.h>

#include "analysis/expectations/correct.hpp"
#include "analysis/figures/figure_family.hpp"
#include "analysis/growth/inference.hpp"
#include "analysis/increments/increments_objection.hpp"
#include "analysis/pages/increments_table.hpp"
#include "analysis/pages/page.hpp"
#include "analysis/pages/report.hpp"
#include "analysis/pages/tables.hpp"
#include "tests/analysis/presented_estimates.hpp"
#include "tests/analysis/simulated_increments.hpp"

namespace brouwer {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// A walk, and one of correlated increments, in two cells.
std::vector<Estimates> two_cells() {
  Increments next(9);
  auto walk = ensemble_of([&](double) { return next.normal(); }, 32, linearly_spaced(32, 3200));
  auto correlated = ensemble_of([&](double x) { return next.autoregressive(0.4, x); }, 32, linearly_spaced(32, 3200));
  walk.cell.method = "white<&>";
  correlated.cell.method = "red";
  return {estimate(walk, {}), estimate(correlated, {})};
}

TEST(IncrementsTable, HasAnEffectBesideEveryP) {
  auto const table = increments_table(two_cells(), CellsAs::columns);
  std::vector<std::string> heads;
  for (auto const& heading : table.headings) heads.push_back(heading.text);
  EXPECT_THAT(heads, testing::ElementsAre("cell", "error of", "increments", "ρ₁", "p", "clearest variance ratio",
                                          "p of all", "skewness", "excess kurtosis", "A²", "p"));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[1].words[0], "red");
  EXPECT_EQ(table.rows[1].words[2], "992");
  EXPECT_THAT(table.rows[1].words[3], ContainsRegex("^0\\.(3[0-9]|4[0-9]) ± 0\\.0[0-9]"));
}

TEST(IncrementsTable, LeavesOutWhatHasNone) {
  auto const rows = std::vector{presented_estimates("m", "energy", 0)};
  EXPECT_TRUE(increments_table(rows, CellsAs::columns).rows.empty());
  EXPECT_EQ(decisions_table(rows, CellsAs::columns).rows.size(), 1u);
}

TEST(Report, HasDecisionsAndIncrements) {
  ReportContent content;
  content.estimates = two_cells();
  auto const html = render_report(content);
  EXPECT_THAT(html, AllOf(HasSubstr("<h2>Decisions</h2>"), HasSubstr("<h2>Increments</h2>"),
                          HasSubstr("<li><b>energy</b>, red: Its increments are correlated"),
                          HasSubstr("white&lt;&amp;&gt;"), Not(HasSubstr("white<&>"))));
  content.estimates = {presented_estimates("m", "energy", 0)};
  EXPECT_THAT(render_report(content), Not(HasSubstr("<h2>Increments</h2>")));
}

TEST(Page, FoldsIncrementsAway) {
  PageSection section;
  section.name = "s";
  section.estimates = two_cells();
  EXPECT_THAT(render_page({section}, {}),
              HasSubstr("<details><summary>Increments</summary>\n\n| cell | error of | increments |"));
}

TEST(IncrementsFigure, HasAPanelACell) {
  auto const rows = two_cells();
  auto const all = families(rows, {});
  auto const sheet = increments_sheet(all.at(0));
  ASSERT_EQ(sheet.panels.size(), 2u);
  EXPECT_EQ(sheet.stem, "increments-energy");
  EXPECT_THAT(sheet.panels[0].subtitle, HasSubstr("excess kurtosis"));
  EXPECT_THAT(sheet.data, HasSubstr("# energy, red: 992 increments\n# z  density\n-3.8"));
  std::vector<Estimates> const none = {presented_estimates("m", "energy", 0)};
  EXPECT_TRUE(increments_sheet(families(none, {}).at(0)).panels.empty());
}

TEST(JsonTable, HasIncrementsAndPower) {
  auto const json = render_table(two_cells(), TableFormat::json);
  EXPECT_THAT(json, AllOf(HasSubstr("\"increments\": {\"count\": 992, \"lag\": [1, 2, 3, 4, 5], \"correlation\": ["),
                          HasSubstr("\"variance_ratio\": ["), HasSubstr("\"histogram_density\": [0, "),
                          HasSubstr("\"smallest_provable_drift\": "), HasSubstr("\"power\": {\"drift\": [0, "),
                          HasSubstr("\"chance\": [0.001, ")));
  EXPECT_THAT(render_table({presented_estimates("m", "energy", 0)}, TableFormat::json),
              HasSubstr("\"increments\": {\"count\": 0, \"lag\": [], "));
}

TEST(TextTable, SaysThatDriftsWereCorrected) {
  auto rows = two_cells();
  EXPECT_THAT(render_table(rows, TableFormat::text), Not(HasSubstr("corrected")));
  correct(rows, Correction::holm);
  EXPECT_THAT(render_table(rows, TableFormat::text), HasSubstr("corrected for all drifts tested beside it (holm)"));
}

}  // namespace
}  // namespace brouwer
