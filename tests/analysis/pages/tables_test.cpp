// Growth tables: what people read is aligned and short, what programs read is complete and well formed.
#include "analysis/pages/tables.hpp"

#include <gmock/gmock.h>

#include <brouwer/error.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

#include "analysis/escape.hpp"
#include "analysis/growth/inference.hpp"
#include "analysis/numbers.hpp"
#include "analysis/pages/growth_table.hpp"
#include "tests/analysis/presented_estimates.hpp"
#include "tests/analysis/simulated.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<Estimates> two_methods() {
  return {presented_estimates("elliptic-naive", "energy", -2.31e-17),
          presented_estimates("elliptic-three-constants", "energy", 0)};
}

std::vector<Estimates> two_methods_two_quantities() {
  auto rows = two_methods();
  rows.push_back(presented_estimates("elliptic-naive", "casimir", 1e-18));
  rows.push_back(presented_estimates("elliptic-three-constants", "casimir", 0));
  return rows;
}

std::vector<std::string> lines_of(std::string const& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::size_t line_with(std::vector<std::string> const& lines, std::string const& part) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].find(part) != std::string::npos) return i;
  return lines.size();
}

/// Columns of the terminal in front of `part`.
std::size_t column_of(std::string const& line, std::string const& part) {
  return display_width(line.substr(0, line.rfind(part)));
}

TEST(Number, HasTheDigitsAskedForAndAPowerOfTenOnlyWhereItHelps) {
  EXPECT_EQ(number(-2.2874e-17, 3), "−2.29e-17");
  EXPECT_EQ(number(0.5149, 2), "0.51");
  EXPECT_EQ(number(-167.4, 3), "−167");
  EXPECT_EQ(number(9.996, 3), "10.0");
  EXPECT_EQ(number(9.96e-17, 2), "1.0e-16");
  EXPECT_EQ(number(0, 3), "0");
  EXPECT_EQ(number(5e-324, 1), "5e-324");
  EXPECT_EQ(number(std::nan(""), 3), "–");
  EXPECT_EQ(number(-std::numeric_limits<double>::infinity(), 3), "−∞");
  EXPECT_EQ(number(-2.2874e-17, 3, Notation::latex), "$-2.29\\cdot10^{-17}$");
}

TEST(Measured, SharesOnePowerOfTenWithItsHalfWidth) {
  EXPECT_EQ(measured(-2.314e-17, {-2.334e-17, -2.294e-17}), "(−2.314 ± 0.020)e-17");
  EXPECT_EQ(measured(2.0e-20, {-3.8e-19, 4.2e-19}), "(0.2 ± 4.0)e-19");
  EXPECT_EQ(measured(0.512, {0.48, 0.54}), "0.51 ± 0.03");
  EXPECT_EQ(measured(0, {0, 0}), "0");
  EXPECT_EQ(measured(1.5, {1.5, 1.5}), "1.50");
  EXPECT_EQ(measured(2e-17, {std::nan(""), 1}), "2.00e-17");
  EXPECT_EQ(measured(-3e-17, {-4e-17, -2e-17}, Notation::latex), "$(-3.0 \\pm 1.0)\\cdot10^{-17}$");
}

TEST(TextTable, StatesOnceWhatDoesNotVaryAndPutsTheVerdictLast) {
  auto const lines = lines_of(render_table(two_methods(), TableFormat::text));
  EXPECT_THAT(lines[0], HasSubstr("rigid_body, double, own functions"));
  EXPECT_THAT(lines[0], HasSubstr("h = 0.01, 20000 steps, 64 members, error of energy"));
  EXPECT_THAT(lines[2], testing::StartsWith("method"));
  EXPECT_THAT(lines[2], Not(HasSubstr("arithmetic")));
  EXPECT_THAT(lines[3], testing::EndsWith("drift"));
  EXPECT_THAT(lines[4], testing::EndsWith("random walk"));
}

TEST(TextTable, TellsCellsApartByTheirCoefficients) {
  auto rows = two_methods();
  rows[1].cell.method = rows[0].cell.method;
  rows[0].cell.coefficients = "per-step";
  rows[1].cell.coefficients = "per-trajectory";
  auto const lines = lines_of(render_table(rows, TableFormat::text));
  EXPECT_THAT(lines[2], testing::StartsWith("coefficients"));
  EXPECT_THAT(lines[3], testing::StartsWith("per-step "));
  EXPECT_THAT(lines[4], testing::StartsWith("per-trajectory "));
  rows.pop_back();
  EXPECT_THAT(render_table(rows, TableFormat::text),
              HasSubstr("own functions, per-step coefficients, not compensated"));
}

TEST(TextTable, SaysNothingOfCoefficientsThatAMethodDoesNotHave) {
  EXPECT_THAT(render_table(two_methods(), TableFormat::text), Not(HasSubstr("coefficients")));
}

TEST(TextTable, AlignsByWhatATerminalShowsAndNotByBytes) {
  auto rows = two_methods();
  rows[0].cell.method = "méthode-β";
  rows[1].cell.method = "方法";
  auto const lines = lines_of(render_table(rows, TableFormat::text));
  EXPECT_EQ(column_of(lines[2], "verdict"), column_of(lines[3], "drift"));
  EXPECT_EQ(column_of(lines[2], "verdict"), column_of(lines[4], "random walk"));
}

TEST(TextTable, GroupsTheQuantitiesOfACell) {
  auto const lines = lines_of(render_table(two_methods_two_quantities(), TableFormat::text));
  auto const naive = line_with(lines, "elliptic-naive"), three = line_with(lines, "elliptic-three-constants");
  ASSERT_EQ(three, naive + 3);
  EXPECT_THAT(lines[naive + 1], testing::StartsWith("  energy"));
  EXPECT_THAT(lines[naive + 2], testing::StartsWith("  casimir"));
}

TEST(TextTable, FitsOnAWideTerminalAndExplainsItsHeadings) {
  auto rows = two_methods();
  rows[1].cell.step = 0.005;
  auto const text = render_table(rows, TableFormat::text);
  for (auto const& line : lines_of(text)) EXPECT_LE(display_width(line), 140u) << line;
  for (auto const* word : {"β:", "t =", "F:", "σ:", "q:", "smallest β:"}) EXPECT_THAT(text, HasSubstr(word));
}

TEST(TextTable, MentionsMembersThatWereLeftOut) {
  auto rows = two_methods();
  rows[0].failed = 3;
  EXPECT_THAT(render_table(rows, TableFormat::text),
              HasSubstr("elliptic-naive, energy: 3 of 67 members were left out"));
}

TEST(TextTable, SpeaksOfTheMembersThatWereRun) {
  auto rows = two_methods();
  for (auto& row : rows) row.members = 39, row.failed = 61;
  EXPECT_THAT(lines_of(render_table(rows, TableFormat::text))[0], HasSubstr("20000 steps, 39 of 100 members, error"));
  rows[1].members = 100, rows[1].failed = 0;
  auto const text = render_table(rows, TableFormat::text);
  EXPECT_THAT(lines_of(text)[0], HasSubstr("20000 steps, 100 members, error"));
  EXPECT_THAT(text, HasSubstr(" 39 of 100 "));
  rows[1].members = 50;
  EXPECT_THAT(lines_of(render_table(rows, TableFormat::text))[0], testing::Not(HasSubstr("members,")));
}

TEST(EveryTableForPeople, SaysWhyMembersWereLeftOut) {
  auto rows = two_methods();
  rows[0].failed = 3;
  rows[0].failures = {{"the iteration did not converge", 2, 1200}, {"collision", 1, 17}};
  for (auto const format : {TableFormat::text, TableFormat::markdown, TableFormat::latex})
    EXPECT_THAT(render_table(rows, format),
                HasSubstr("elliptic-naive, energy: 3 of 67 members are left out: 2 because the iteration did not "
                          "converge (the first at step 1200), 1 because of a collision (at step 17)."));
  EXPECT_THAT(render_table(rows, TableFormat::json), HasSubstr("\"failures\": \"2 because the iteration"));
}

TEST(EveryTableForPeople, SaysOnceWhatIsTrueOfEveryErrorOfACell) {
  auto rows = two_methods_two_quantities();
  for (auto& row : rows)
    if (row.cell == rows[0].cell) {
      row.failed = 64, row.members = 0;
      row.failures = {{"the iteration did not converge", 64, 0}};
    }
  auto const text = render_table(rows, TableFormat::text), note = std::string("64 of 64 members are left out");
  EXPECT_THAT(text, HasSubstr("elliptic-naive, every error: 64 of 64 members are left out because the iteration did "
                              "not converge (the first at step 0)."));
  EXPECT_EQ(text.find(note), text.rfind(note));
  rows[2].failures[0].first_step = 5;
  EXPECT_THAT(render_table(rows, TableFormat::text), HasSubstr("elliptic-naive, casimir: 64 of 64"));
}

TEST(EveryTableForPeople, SaysOnceWhatIsTrueOfSeveralErrorsOfACell) {
  auto rows = std::vector<Estimates>(5, two_methods()[0]);
  char const* const names[] = {"energy", "state", "angular-momentum", "phase", "casimir"};
  std::int64_t const failed[] = {3, 5, 3, 5, 0};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].quantity = names[i];
    rows[i].failed = failed[i];
    if (failed[i] > 0) rows[i].failures = {{"collision", failed[i], 17}};
  }
  auto const notes = growth_table(rows, CellsAs::columns).notes;
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_THAT(notes[0], HasSubstr(", energy, angular-momentum: 3 of 67 members are left out because of a collision"));
  EXPECT_THAT(notes[1], HasSubstr(", state, phase: 5 of 69 members are left out because of a collision"));
}

TEST(EveryTable, HasARowOfACountWithoutALaw) {
  Ensemble iterations = simulated({}, 10, {1, 10, 100}, 1ul);
  iterations.quantity = "iterations";
  iterations.errors.setConstant(14);
  iterations.count = true;
  auto const row = estimate(iterations, {});
  EXPECT_THAT(render_table({row}, TableFormat::text), testing::ContainsRegex("  14 +– +– +– +– +– +–  count\n"));
  EXPECT_THAT(render_table({row}, TableFormat::json), HasSubstr("\"count\": {\"mean\": 14, \"range\": [14, 14]}"));
  EXPECT_THAT(render_table(two_methods(), TableFormat::json), HasSubstr("\"count\": {\"mean\": null,"));
}

TEST(TextTable, OfAnEnsembleFromElsewhereClaimsNothingAboutIt) {
  auto row = presented_estimates("", "error", 0);
  row.cell = {};
  row.time_unit = "time unit";
  auto const text = render_table({row}, TableFormat::text);
  EXPECT_THAT(text, Not(HasSubstr("compensated")));
  EXPECT_THAT(text, HasSubstr("per time unit"));
}

TEST(MarkdownTable, HasAsManyCellsInEveryRowAsInItsHead) {
  auto rows = two_methods_two_quantities();
  rows[0].cell.method = "a|b`c";
  std::ptrdiff_t const columns = 10;  // method, error of, seven of numbers, verdict
  for (auto line : lines_of(render_table(rows, TableFormat::markdown))) {
    if (line.empty() || line[0] != '|') continue;
    for (auto at = line.find("\\|"); at != std::string::npos; at = line.find("\\|")) line.erase(at, 2);
    EXPECT_EQ(std::count(line.begin(), line.end(), '|'), columns + 1) << line;
  }
}

TEST(LatexTable, IsABooktabsTabularWithEverythingEscaped) {
  auto rows = two_methods_two_quantities();
  rows[1].cell.method = "50%_of #1 & {x}";
  auto const text = render_table(rows, TableFormat::latex);
  for (auto const* part : {"\\begin{tabular}", "\\toprule", "\\midrule", "\\bottomrule", "\\end{tabular}"})
    EXPECT_THAT(text, HasSubstr(part));
  EXPECT_THAT(text, HasSubstr("50\\%\\_of \\#1 \\& \\{x\\}"));
  EXPECT_THAT(text, HasSubstr("$(-2.31 \\pm 0.03)\\cdot10^{-17}$"));
}

TEST(CsvTable, QuotesWhatHoldsACommaAndReadsBackBitForBit) {
  auto rows = two_methods();
  rows[0].quantity = "a,\"b\"";
  rows[0].rms_final = 0.1 + 0.2;
  rows[0].cell.system = "";
  auto const lines = lines_of(render_table(rows, TableFormat::csv));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_THAT(lines[0],
              testing::StartsWith("system,method,arithmetic,special_functions,coefficients,compensation,step,steps,"));
  EXPECT_THAT(lines[0], HasSubstr("drift_per_step,drift_ci_low,drift_ci_high,drift_t,drift_p"));
  EXPECT_THAT(lines[1], testing::StartsWith(",elliptic-naive,"));
  EXPECT_THAT(lines[1], HasSubstr("\"a,\"\"b\"\"\""));
  EXPECT_THAT(lines[1], HasSubstr(",0.30000000000000004,"));
  EXPECT_EQ(std::count(lines[0].begin(), lines[0].end(), ','), std::count(lines[2].begin(), lines[2].end(), ','));
}

TEST(JsonTable, HasTheKeysThatProgramsRelyOn) {
  auto const text = render_table({two_methods()[0]}, TableFormat::json);
  for (auto const* key : {"system", "method", "arithmetic", "compensation", "step", "steps", "members", "quantity",
                          "rms_final", "smallest_visible_drift", "verdict", "special_functions", "coefficients",
                          "failed", "samples", "levels", "sentence"})
    EXPECT_THAT(text, HasSubstr('"' + std::string(key) + "\": "));
  EXPECT_THAT(text,
              testing::ContainsRegex("\"drift\": \\{\"per_step\": -2.3[01][0-9]*e-17, \"ci\": \\[-2.3[0-9]*e-17, "
                                     "-2.2[78][0-9]*e-17\\], \"t\": -14[0-9.]*, \"p\": [0-9.]*e-81, \"share\": "));
  EXPECT_THAT(text, testing::ContainsRegex("\"persistence\": \\{\"per_step\": 0, \"F\": [0-9.]+, \"p\": [0-9.]+"));
  EXPECT_THAT(text, testing::ContainsRegex("\"diffusion\": \\{\"per_sqrt_step\": [0-9.e-]+, \"ci\": \\[[^]]*\\]\\}"));
  EXPECT_THAT(text, testing::ContainsRegex("\"growth\": \\{\"exponent\": [0-9.]+, \"ci\": \\[[^]]*\\]\\}"));
  EXPECT_THAT(text, HasSubstr("\"compensation\": false"));
}

TEST(JsonTable, WritesNullForWhatIsNoNumberAndEscapesNames) {
  auto row = two_methods()[0];
  row.drift.t = std::numeric_limits<double>::infinity();
  row.growth.exponent = std::nan("");
  row.cell.method = "a\"b\\c\n\x01\xff";
  auto const text = render_table({row}, TableFormat::json);
  EXPECT_THAT(text, HasSubstr("\"t\": null"));
  EXPECT_THAT(text, HasSubstr("\"exponent\": null"));
  EXPECT_THAT(text, HasSubstr("\"a\\\"b\\\\c\\n\xEF\xBF\xBD\xEF\xBF\xBD\""));
  EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(JsonTable, IsReadByPython) {
  if (std::system("python3 -c '' 2> /dev/null") != 0) GTEST_SKIP() << "there is no python3";
  auto rows = two_methods_two_quantities();
  rows[1].quantity = "\"\\\x02\t\xfe/é方";
  rows[2].drift.p = std::nan("");
  auto const file = testing::TempDir() + "brouwer_table.json";
  std::ofstream(file) << render_table(rows, TableFormat::json);
  EXPECT_EQ(std::system(("python3 -m json.tool '" + file + "' > /dev/null").c_str()), 0);
}

TEST(JsonTable, IsAnArrayEvenOfNothing) {
  EXPECT_EQ(render_table({}, TableFormat::json), "[\n]\n");
  EXPECT_EQ(lines_of(render_table({}, TableFormat::csv)).size(), 1u);
}

TEST(TableFormatName, IsFoundOrTheNearestIsTold) {
  EXPECT_EQ(table_format("markdown"), TableFormat::markdown);
  try {
    table_format("markdwon");
    FAIL() << "accepted a format that does not exist";
  } catch (InputError const& error) {
    EXPECT_THAT(error.what(), HasSubstr("'markdwon'; did you mean 'markdown'?"));
  }
}

TEST(Escaping, MakesAnyBytesHarmless) {
  EXPECT_EQ(gnuplot_string("it's `x`\n"), "'it''s `x` '");
  EXPECT_EQ(xml_text("<a b='c'>&\x02"), "&lt;a b=&#39;c&#39;&gt;&amp;\xEF\xBF\xBD");
  EXPECT_EQ(file_stem("../../etc/x y"), "etc-x-y");
  EXPECT_EQ(file_stem("''"), "quantity");
  EXPECT_EQ(one_line("\xC0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD");  // an overlong NUL is no UTF-8
}

TEST(GrowthTable, HasAColumnOfNoiseOnlyWhereARowHasSome) {
  auto rows = two_methods();
  EXPECT_THAT(render_table(rows, TableFormat::text), Not(HasSubstr("ν")));
  rows[0].noise = {3e-15, {2.9e-15, 3.1e-15}};
  auto const text = render_table(rows, TableFormat::text);
  EXPECT_THAT(text, HasSubstr("noise ν"));
  EXPECT_THAT(text, HasSubstr("(3.00 ± 0.10)e-15"));
  EXPECT_THAT(text, HasSubstr("told apart from it by restricted maximum likelihood"));
  EXPECT_THAT(render_table(rows, TableFormat::latex), HasSubstr("$\\nu$"));
}

TEST(GrowthTable, JsonHasAllLawsOfTheFullModel) {
  auto rows = two_methods();
  EXPECT_THAT(render_table(rows, TableFormat::json), HasSubstr(R"("chosen": "", "candidates": [], "p_noise": null)"));
  rows[0].model = FullModel{{{{true, true, true}, -1.5, 1, 2, 3, 4}}};
  EXPECT_THAT(
      render_table(rows, TableFormat::json),
      HasSubstr(
          R"("chosen": "walk + slopes + noise", "candidates": [{"law": "walk + slopes + noise", "log_likelihood": -1.5, "drift": 1, "slopes": 2, "diffusion": 3, "noise": 4}])"));
}

}  // namespace
}  // namespace brouwer
