// The page that a report is: complete, self-contained, and deaf to what names try to say to a browser.
#include "analysis/pages/report.hpp"

#include <gmock/gmock.h>

#include <brouwer/error.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "tests/analysis/presented_estimates.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr char const* tiny_svg =
    "<?xml version=\"1.0\"?>\n<svg viewBox=\"0 0 1 1\"><title>name</title><defs><circle id='gpDot' r='1'/></defs>"
    "<g id=\"canvas\"><use xlink:href='#gpDot'/></g></svg>\n";

ReportContent content() {
  ReportContent c;
  c.title = "elliptic-drift";
  c.question = "Do three constants remove the drift?";
  c.source = "G. Vilmart, J. Comput. Phys. 227 (2008) 7083";
  c.run = {{"members", "64"}};
  c.outcomes = {{true, "energy: no drift", "t = 0.2"}, {false, "casimir: no drift", "t = −90"}};
  c.estimates = {presented_estimates("elliptic-naive", "energy", -2.31e-17),
                 presented_estimates("elliptic-three-constants", "energy", 0)};
  c.figures = {{"first", tiny_svg}, {"second", tiny_svg}};
  c.study_text = "question = \"…\"";
  c.provenance = "g++ 12.2";
  return c;
}

/// Every element that is opened is closed, in order; void elements of HTML apart.
void expect_balanced(std::string const& page) {
  static std::set<std::string> const empty = {"meta"};
  std::regex const tag("<(/?)([a-zA-Z0-9]+)[^<>]*?(/?)>");
  std::vector<std::string> open;
  for (std::sregex_iterator it(page.begin(), page.end(), tag), end; it != end; ++it) {
    std::string const name = (*it)[2];
    if (empty.contains(name) || (*it)[3] == "/") continue;
    if ((*it)[1] != "/") {
      open.push_back(name);
      continue;
    }
    ASSERT_FALSE(open.empty()) << "</" << name << "> closes nothing";
    ASSERT_EQ(open.back(), name);
    open.pop_back();
  }
  EXPECT_TRUE(open.empty());
}

TEST(Report, SaysEverythingItWasGiven) {
  auto const page = render_report(content());
  for (auto const* part :
       {"<title>elliptic-drift</title>", "<h1>Do three constants remove the drift?</h1>", "Vilmart",
        "1 of 2 expectations met", "casimir: no drift", "t = −90", "elliptic-three-constants",
        "The error of energy is as told.", "random walk", "first", "second", "g++ 12.2", "<dd>64</dd>"})
    EXPECT_THAT(page, HasSubstr(part));
  expect_balanced(page);
}

TEST(Report, SaysInItsHeadThatItIsUnfinished) {
  auto c = content();
  EXPECT_THAT(render_report(c), Not(HasSubstr("unfinished")));
  c.unfinished = "unfinished: 900 of 4200 members in 14 cells";
  auto const page = render_report(c);
  auto const said = page.find("<p class=\"summary fail\">unfinished: 900 of 4200 members in 14 cells</p>");
  ASSERT_NE(said, std::string::npos);
  EXPECT_GT(said, page.find("<h1>"));
  EXPECT_LT(said, page.find("</header>"));
  expect_balanced(page);
}

TEST(Report, LoadsNothingFromElsewhereAndRunsNothing) {
  auto const page = render_report(content());
  for (auto const* part : {"<script", "<link", "<img", "@import", "src="}) EXPECT_THAT(page, Not(HasSubstr(part)));
}

TEST(Report, IsReadableOnDarkScreens) {
  EXPECT_THAT(render_report(content()), HasSubstr("@media (prefers-color-scheme: dark)"));
}

TEST(Report, GivesEachFigureItsOwnIdentifiers) {
  auto const page = render_report(content());
  std::set<std::string> ids;
  std::regex const id(" id=['\"]([^'\"]*)['\"]");
  for (std::sregex_iterator it(page.begin(), page.end(), id), end; it != end; ++it)
    EXPECT_TRUE(ids.insert((*it)[1]).second) << (*it)[1];
  EXPECT_EQ(ids.size(), 4u);
  EXPECT_THAT(page, HasSubstr("xlink:href='#f1-gpDot'"));
  EXPECT_THAT(page, Not(HasSubstr("<?xml")));
}

TEST(Report, EscapesEveryText) {
  std::string const evil = "<script>alert('x')</script>&\"";
  auto c = content();
  c.title = c.question = c.source = c.study_text = c.provenance = c.note = c.unfinished = evil;
  c.run = {{evil, evil}};
  c.unjudged = {evil};
  c.outcomes = {{true, evil, evil}};
  for (auto& row : c.estimates) row.quantity = row.sentence = row.cell.method = evil;
  c.figures = {{evil, tiny_svg}};
  auto const page = render_report(c);
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;&amp;&quot;"));
  expect_balanced(page);
}

TEST(Report, OfNothingIsStillAPage) {
  auto const page = render_report({});
  EXPECT_THAT(page, HasSubstr("<title>Growth of round-off error</title>"));
  expect_balanced(page);
}

TEST(Report, EmbedsFiguresThatGnuplotDrew) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no gnuplot";
  auto c = content();
  for (auto& row : c.estimates) row.family = row.cell.method += "<script>";
  auto const folder = std::filesystem::path(testing::TempDir()) / "brouwer_report_figures";
  c.figures = report_figures(draw_figures(c.estimates, {}, folder, "svg"));
  std::filesystem::remove_all(folder);
  ASSERT_EQ(c.figures.size(), 4u);
  EXPECT_THAT(c.figures[0].caption, HasSubstr("Brouwer's law"));
  auto const page = render_report(c);
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  expect_balanced(page);
}

TEST(Report, MissesAFigureThatIsGone) {
  EXPECT_THROW(report_figures({{"/nonexistent/growth-energy.svg"}, ""}), RunError);
}

}  // namespace
}  // namespace brouwer
