// An explanation as people and programs read it: columns that say something, the cause in words, all numbers in json.
#include "analysis/causes/explain_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "analysis/causes/causes.hpp"
#include "analysis/causes/causes_figure.hpp"
#include "tests/scratch.hpp"

namespace brouwer {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

CellLabels nominal_cell() { return {"rigid_body", "elliptic-naive", "double", "own", no_level, false, 0.01, 50000}; }

ComparedCell cell(char const* factor, CellLabels labels, double left, double half) {
  ComparedCell c;
  c.cell = std::move(labels);
  c.bits = c.cell.arithmetic == "double" ? 53 : 106;
  c.changed = {factor};
  c.drift = {left * 2e-17, {(left - half) * 2e-17, (left + half) * 2e-17}, 1, 0.5, 0};
  c.drift_left = {left, {left - half, left + half}};
  c.diffusion_left = c.size_left = {1.1, {1.05, 1.15}};
  return c;
}

Explanation explanation() {
  Explanation e;
  e.nominal.cell = nominal_cell();
  e.nominal.quantity = "energy";
  e.nominal.verdict = Verdict::drift;
  e.nominal.members = e.members = 64;
  e.nominal.drift = {2e-17, {1.9e-17, 2.1e-17}, 40, 1e-40, 0.9};
  e.nominal.persistence.p = 0.4;
  auto exact = nominal_cell(), stochastic = nominal_cell(), wide = nominal_cell();
  exact.constants = "exact";
  stochastic.rounding = "stochastic";
  wide.arithmetic = "double-double";
  e.cells = {cell("constants", exact, 0.01, 0.03), cell("rounding", stochastic, 1.02, 0.05),
             cell("arithmetic", wide, 0, 1e-16)};
  e.cells[0].lost = 2;
  e.not_run = {"fused products: exist in float and double only"};
  FactorialEffect effect;
  effect.factors = {"exact constants", "stochastic rounding"};
  effect.drift = {-1e-17, {-1.1e-17, -0.9e-17}, -20, 1e-20, 0.5};
  effect.diffusion = {1.2, {1.1, 1.3}};
  e.effects = {effect};
  e.left_out = {"float: 60 of 64 members failed"};
  name_cause(e);
  return e;
}

TEST(ExplainTable, SaysTheCauseBelowWhatShowsIt) {
  auto const text = explain_text({explanation()});
  EXPECT_THAT(text,
              AllOf(HasSubstr("rigid_body, elliptic-naive, double"), HasSubstr("β₀ = (2.00 ± 0.10)e-17 per step"),
                    HasSubstr("exact constants × stochastic rounding"), HasSubstr("gone"), HasSubstr("stays"),
                    HasSubstr("left out: float: 60 of 64 members failed"),
                    HasSubstr("The drift comes from the rounded constants: it persists (97 … 107 %) with stochastic "
                              "rounding and vanishes (−2 … 4 %) with exact constants.")));
  EXPECT_THAT(text, Not(HasSubstr("τ²/τ₀²"))) << "there are no slopes to speak of";
  EXPECT_THAT(text, HasSubstr("Not run: fused products: exist in float and double only."));
}

TEST(ExplainTable, IsMarkdown) {
  auto const text = explain_markdown({explanation()});
  EXPECT_THAT(text, AllOf(HasSubstr("### energy"), HasSubstr("**The drift comes"), HasSubstr("| with | drift β |"),
                          HasSubstr("|:---|---:|")));
}

TEST(ExplainTable, IsJsonWithNullsWhereNothingIsKnown) {
  auto e = explanation();
  e.cells[1].drift_left.interval = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  auto const text = explain_json({e, explanation()});
  EXPECT_THAT(text, AllOf(HasSubstr("\"cause\": \"rounded constants\""), HasSubstr("\"subject\": \"drift\""),
                          HasSubstr("\"changed\": [\"constants\"]"), HasSubstr("\"ci\": [null, null]"),
                          HasSubstr("\"constants\": \"exact\""), HasSubstr("\"value\": 1.02"), HasSubstr("\"lost\": 2"),
                          HasSubstr("\"not_run\": [\"fused products")));
  EXPECT_THAT(text, AllOf(Not(HasSubstr("inf")), Not(HasSubstr("nan"))));
}

TEST(ExplainTable, OfNothingSaysSo) {
  EXPECT_EQ(explain_text({}), "There is nothing to explain.\n");
  EXPECT_EQ(explain_json({}), "[\n\n]\n");
}

TEST(CausesFigure, HasAScriptAndDataBesideIt) {
  Scratch const folder;
  auto hostile = explanation();
  hostile.nominal.quantity = "energy' \"{of}\n`ls`";
  hostile.cells[1].drift_left = {35, {34, 36}};  // far beyond the axis
  auto nothing = explanation();
  nothing.subject = Subject::nothing;
  auto const figures = draw_causes({explanation(), nothing, hostile}, folder.path(), "svg");
  for (auto const* file : {"causes-1.gp", "causes-1.dat", "causes-2.gp"}) EXPECT_TRUE(exists(folder / file)) << file;
  EXPECT_FALSE(exists(folder / "causes-3.gp"));
  EXPECT_EQ(figures.note, "");
  EXPECT_EQ(figures.files.size(), 2U);
  std::ostringstream script;
  script << std::ifstream(folder / "causes-2.gp").rdbuf();
  EXPECT_THAT(script.str(), AllOf(HasSubstr("exact constants"), HasSubstr("3400 … 3600 %"), HasSubstr("▶")));
  std::ostringstream data;
  data << std::ifstream(folder / "causes-2.dat").rdbuf();
  EXPECT_THAT(data.str(), HasSubstr("\n2 3500 3400 3600 0xd55e00 0\n")) << "kept, though not drawn to scale";
}

}  // namespace
}  // namespace brouwer
