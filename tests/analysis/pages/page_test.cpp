// The page of several studies: what it says, that its tables are tables, and that it is the same page every time.
#include "analysis/pages/page.hpp"

#include <gmock/gmock.h>

#include <brouwer/error.hpp>
#include <sstream>

#include "analysis/figures/main_figures.hpp"
#include "tests/analysis/presented_estimates.hpp"

namespace brouwer {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

PageSection drift_study() {
  PageSection section;
  section.name = "elliptic-drift";
  section.question = "Do three constants remove the drift?";
  section.source = "G. Vilmart, J. Comput. Phys. 227 (2008) 7083";
  section.estimates = {presented_estimates("elliptic-naive", "energy", -2.31e-17),
                       presented_estimates("elliptic-three-constants", "energy", 0)};
  section.outcomes = {{true, "energy: no drift", "t = 0.2"}, {false, "casimir: no drift", "t = −90"}};
  section.figures = {{"Growth of the RMS.", "page-figures/elliptic-drift-growth-energy.svg"}};
  return section;
}

PageSection count_study() {
  PageSection section;
  section.name = "iterations";
  section.estimates = {presented_estimates("gauss-4", "iterations", 0)};
  section.estimates[0].verdict = Verdict::count;
  section.estimates[0].count = Counted{14.21, {13.9, 14.6}};
  section.estimates[0].unit = "iterations per step";
  section.outcomes = {{true, "iterations: mean", "mean = 14.2"}};
  section.unjudged = {"'where' matches nothing"};
  section.note = "gnuplot is not installed";
  return section;
}

std::string page() { return render_page({drift_study(), count_study()}, {"brouwer 0.1.0, g++ 12.2.0"}); }

TEST(Page, BeginsWithATableOfAllStudies) {
  auto const text = page();
  EXPECT_THAT(text,
              testing::StartsWith(
                  "# Results\n\n| question | expectations | study |\n|:---|:---|:---|\n"
                  "| Do three constants remove the drift? | **1 of 2 hold** | [elliptic-drift](#elliptic-drift) |\n"
                  "| iterations | 1 of 1 hold, 1 not judged | [iterations](#iterations) |\n\n"
                  "2 studies; 2 of 3 expectations hold.\n"));
}

TEST(Page, HasASectionAStudy) {
  auto const text = page();
  for (auto const* part :
       {"<a id=\"elliptic-drift\"></a>\n\n## Do three constants remove the drift?\n\nSource: G. Vilmart",
        "## iterations\n",
        "![elliptic-drift-growth-energy](page-figures/elliptic-drift-growth-energy.svg)\n\n*Growth of the RMS.*",
        "| energy: no drift | t = 0.2 | passed |", "| casimir: no drift | t = −90 | **CONTRADICTED** |",
        "- Not judged: 'where' matches nothing", "gnuplot is not installed"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST(Page, GivesTheNumberThatCarriesEachVerdict) {
  auto const text = page();
  for (auto const* part :
       {"| energy | elliptic-naive | 4.6e-13 | drift β = (−2.31 ± 0.03)e-17 per step | drift |",
        "| energy | elliptic-three-constants | 4.6e-13 | diffusion σ = (1.96 ± 0.06)e-16 per √step | random walk |",
        "14.2 (13.9 … 14.6) iterations per step | count |"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST(Page, SaysWhyMembersWereLeftOut) {
  auto section = drift_study();
  section.estimates[0].failed = 1;
  section.estimates[0].failures = {{"collision", 1, 17}};
  EXPECT_THAT(render_page({section}, {}),
              HasSubstr("- elliptic-naive, energy: 1 of 65 members is left out because of a collision (at step 17)."));
}

TEST(Page, SaysAtTheHeadOfASectionThatItIsUnfinished) {
  auto section = drift_study();
  section.unfinished = "unfinished: 900 of 4200 members in 14 cells";
  auto const text = render_page({section}, {});
  EXPECT_THAT(text, HasSubstr("## Do three constants remove the drift?\n\n"
                              "**unfinished: 900 of 4200 members in 14 cells**\n\nSource:"));
  EXPECT_THAT(text, HasSubstr("| **1 of 2 hold**, unfinished |"));
  EXPECT_THAT(page(), Not(HasSubstr("unfinished")));
}

TEST(Page, EndsWithThePrograms) {
  EXPECT_THAT(page(), testing::EndsWith("---\n\nComputed with brouwer 0.1.0, g++ 12.2.0.\n"));
  EXPECT_EQ(page(), page());
}

TEST(Page, HasEqualCellsInEveryRowOfATableWhateverNamesSay) {
  auto section = drift_study();
  std::string const evil = "a|b`c\n<script>\\[x](y)";
  section.name = section.question = section.source = section.note = section.unfinished = evil;
  for (auto& e : section.estimates) e.quantity = e.cell.method = evil;
  section.outcomes = {{false, evil, evil}};
  section.unjudged = {evil};
  auto const text = render_page({section}, {evil});
  EXPECT_THAT(text, AllOf(Not(HasSubstr("<script")), Not(HasSubstr("[x](y)"))));
  std::istringstream lines(text);
  std::ptrdiff_t wanted = 0;
  for (std::string line; std::getline(lines, line);) {
    for (auto at = line.find("\\|"); at != std::string::npos; at = line.find("\\|")) line.erase(at, 2);
    auto const bars = std::count(line.begin(), line.end(), '|');
    EXPECT_TRUE(bars == wanted || bars == 0 || wanted == 0) << line;
    wanted = bars;
  }
}

TEST(Page, FoldsLongTablesButNotWhatIsContradicted) {
  auto section = drift_study();
  for (int i = 0; i < 40; ++i) {
    section.estimates.push_back(section.estimates[0]);
    section.outcomes.push_back({i != 20, "claim " + std::to_string(i), "found"});
  }
  auto const text = render_page({section}, {});
  EXPECT_THAT(text, HasSubstr("<details><summary>42 measurements</summary>\n\n| error of |"));
  auto const fold = text.find("<details><summary>40 expectations passed</summary>\n\n| expected |");
  ASSERT_NE(fold, std::string::npos);
  EXPECT_LT(text.find("| claim 20 | found | **CONTRADICTED** |"), fold);
  EXPECT_GT(text.find("| claim 21 | found | passed |"), fold);
  EXPECT_THAT(page(), Not(HasSubstr("<details>")));
}

TEST(Page, HasNoEmptyParagraphs) { EXPECT_THAT(page(), Not(HasSubstr("\n\n\n"))); }

TEST(Page, TellsStudiesOfOneNameApart) {
  auto const text = render_page({drift_study(), drift_study()}, {});
  EXPECT_THAT(text, AllOf(HasSubstr("<a id=\"elliptic-drift\">"), HasSubstr("<a id=\"elliptic-drift-2\">"),
                          HasSubstr("(#elliptic-drift-2)")));
}

TEST(Page, OfNothingIsStillAPage) {
  EXPECT_THAT(render_page({}, {}), HasSubstr("0 studies; 0 of 0 expectations hold"));
}

TEST(PageFormat, IsReadOffTheName) {
  EXPECT_EQ(page_format("a/two.md"), PageFormat::markdown);
  EXPECT_EQ(page_format("two.html"), PageFormat::html);
  EXPECT_EQ(page_format("two.v1.htm"), PageFormat::html);
  for (auto const* name : {"two.txt", "two", "html", ".md", "two.md.bak", "two.HTMLX"})
    EXPECT_THAT([&] { page_format(name); }, testing::ThrowsMessage<InputError>(HasSubstr("ends in .html, .htm or .md")))
        << name;
}

TEST(MainFigures, AreThoseOfWhatWasAsked) {
  auto rows = drift_study().estimates;
  rows.push_back(presented_estimates("elliptic-naive", "spatial-momentum-1", 0));
  Figures figures;
  for (auto const* name : {"growth-energy", "histogram-energy", "mean-energy", "precision-energy",
                           "growth-spatial-momentum", "cloud-still"})
    figures.files.push_back(std::string("f/") + name + ".svg");
  EXPECT_THAT(main_figures(figures, rows, {"energy"}),
              ElementsAre("f/growth-energy.svg", "f/precision-energy.svg", "f/cloud-still.svg"));
  EXPECT_THAT(main_figures(figures, rows, {"spatial-momentum-1"}),
              ElementsAre("f/growth-spatial-momentum.svg", "f/cloud-still.svg"));
  EXPECT_EQ(main_figures(figures, rows, {}).size(), 4u);
}

TEST(MainFigures, OfACrowdOverManyStepsAreItsWorkAndPrecision) {
  std::vector<Estimates> rows;
  for (int i = 1; i <= 9; ++i) {
    rows.push_back(presented_estimates("a", "energy", 0));
    rows.back().cell.step = 0.01 * i;
    rows.back().cell.steps = 252'000 / i;
  }
  Figures const figures{{"growth-energy.svg", "precision-energy.svg"}, ""};
  EXPECT_THAT(main_figures(figures, rows, {}), ElementsAre("precision-energy.svg"));
  rows.pop_back();
  EXPECT_EQ(main_figures(figures, rows, {}).size(), 2u);
}

TEST(Programs, AreNamedOnceWithoutTheMachine) {
  EXPECT_THAT(programs_of("brouwer = 0.1.0\ncompiler = g++ 12.2.0\ncpu = secret\n\nbrouwer = 0.1.0\ncompiler = g++ "
                          "12.2.0\ncpu = another\n\nbrouwer = 0.2.0\ncompiler = clang\n"),
              ElementsAre("brouwer 0.1.0, g++ 12.2.0", "brouwer 0.2.0, clang"));
}

}  // namespace
}  // namespace brouwer
