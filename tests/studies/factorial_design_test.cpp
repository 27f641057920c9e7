// The design around a study: which cells are run to explain it.
#include "studies/factorial_design.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <brouwer/error.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "tests/scratch.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

Catalogue const& catalogue() {
  static auto const built = builtin_catalogue();
  return built;
}

/// A study file for the time of a test.
struct File {
  explicit File(std::string const& text) { std::ofstream(path) << text; }
  FactorialDesign design(std::vector<std::string> const& factors = {}) const {
    return design_around(path, catalogue(), {}, factors);
  }
  Scratch folder;
  std::filesystem::path path = folder / "toy.toml";
};

std::string study(std::string const& system, std::string const& integrate, std::string const& observe = "") {
  return "[system." + system + "]\n[integrate]\n" + integrate +
         "\nsteps = 100\n[ensemble]\nmembers = 8\nseed = 1\nperturb = { momentum = { uniform = 1e-2 } }\n[observe]\n" +
         (observe.empty() ? "quantities = [\"energy\"]\n" : observe) + "samples = { count = 8 }\n";
}

std::map<std::string, std::size_t> cells_by_part(FactorialDesign const& design) {
  std::map<std::string, std::size_t> cells;
  for (auto const& part : design.parts) cells[part.name] = part.study.plan.cells.size();
  return cells;
}

std::set<std::string> levels(FactorialDesign const& design, std::string const& part, std::string CellLabels::*factor) {
  std::set<std::string> found;
  for (auto const& p : design.parts)
    if (p.name == part)
      for (auto const& cell : p.study.plan.cells) found.insert(cell.*factor);
  return found;
}

TEST(FactorialDesign, CrossesConstantsRoundingAndSum) {
  auto const design = File(study("henon_heiles", "methods = [\"gauss-8\", \"kutta-4\"]\nstep = 0.1")).design();
  EXPECT_EQ(design.nominal.size(), 2U);
  auto const cells = cells_by_part(design);
  EXPECT_EQ(cells.at("operations"), 2U * 8);
  EXPECT_EQ(cells.at("rounding"), 2U * 3);
  EXPECT_EQ(cells.at("contraction"), 2U);
  EXPECT_EQ(cells.at("coefficients"), 2U) << "split and symplectic, of the method that has them";
  EXPECT_EQ(cells.at("lower-precision"), 2U);
  EXPECT_EQ(cells.at("higher-precision"), 2U);
  EXPECT_EQ(cells.count("special-functions"), 0U);
  EXPECT_THAT(levels(design, "rounding", &CellLabels::rounding), UnorderedElementsAre("up", "down", "toward-zero"));
  EXPECT_THAT(levels(design, "coefficients", &CellLabels::coefficients), UnorderedElementsAre("split", "symplectic"));
  EXPECT_THAT(levels(design, "higher-precision", &CellLabels::arithmetic), ElementsAre("double-double"));
}

TEST(FactorialDesign, IsAroundTheFirstLevelOfEachFactor) {
  auto const design = File(study("henon_heiles",
                                 "methods = \"gauss-8\"\nstep = [0.1, 0.2]\narithmetic = [\"float\", \"double\"]\n"
                                 "compensation = [true, false]\ncoefficients = [\"split\", \"standard\"]\n"
                                 "rounding = [\"up\", \"nearest\"]"))
                          .design();
  ASSERT_EQ(design.nominal.size(), 2U) << "one for each step";
  for (auto const& cell : design.nominal) {
    EXPECT_EQ(cell.arithmetic, "float");
    EXPECT_TRUE(cell.compensation);
    EXPECT_EQ(cell.coefficients, "split");
    EXPECT_EQ(cell.rounding, "up");
  }
  EXPECT_THAT(levels(design, "operations", &CellLabels::rounding), UnorderedElementsAre("up", "stochastic"));
  EXPECT_THAT(levels(design, "rounding", &CellLabels::rounding),
              UnorderedElementsAre("nearest", "down", "toward-zero"));
  EXPECT_THAT(levels(design, "higher-precision", &CellLabels::arithmetic), ElementsAre("double"));
  EXPECT_EQ(cells_by_part(design).count("lower-precision"), 0U);
}

TEST(FactorialDesign, HasOnlyWhatExists) {
  auto const design =
      File(study("rigid_body", "methods = \"elliptic-naive\"\nstep = 0.1\narithmetic = \"float128\"")).design();
  auto const cells = cells_by_part(design);
  EXPECT_EQ(cells.at("operations"), 1U) << "its operations are a library's, and it has no increment";
  EXPECT_EQ(cells.count("rounding"), 0U);
  EXPECT_THAT(design.left_out, testing::Contains(HasSubstr("float and double only")));
  EXPECT_THAT(levels(design, "higher-precision", &CellLabels::arithmetic), ElementsAre("mpfr-256"));
}

/// What exists in no other arithmetic is standard there: a truncation error is asked for around any cell.
TEST(FactorialDesign, HasHigherPrecisionForEveryNominalCell) {
  for (auto const* operations : {"rounding = \"up\"", "rounding = \"stochastic\"", "constants = \"exact\"",
                                 "contraction = true", "special_functions = \"gsl\""}) {
    auto const design =
        File(study("rigid_body", "methods = \"elliptic-naive\"\nstep = 0.1\n" + std::string(operations)))
            .design({"precision"});
    auto const cells = cells_by_part(design);
    EXPECT_EQ(cells.count("higher-precision"), 1U) << operations;
    EXPECT_THAT(levels(design, "higher-precision", &CellLabels::rounding), ElementsAre("nearest"));
    EXPECT_EQ(cells.count("lower-precision"), 1U) << operations;
  }
}

/// A method without an increment is explained as it is, though the study's first level is a compensated sum.
TEST(FactorialDesign, KeepsMethodsWithoutCompensation) {
  auto const design = File(study("rigid_body",
                                 "methods = [\"elliptic-naive\", \"dmv-2\"]\nstep = 0.1\n"
                                 "compensation = [true, false]"))
                          .design();
  ASSERT_EQ(design.nominal.size(), 2U);
  EXPECT_EQ(design.nominal[0].method, "dmv-2");
  EXPECT_TRUE(design.nominal[0].compensation);
  EXPECT_EQ(design.nominal[1].method, "elliptic-naive");
  EXPECT_FALSE(design.nominal[1].compensation);
  EXPECT_EQ(cells_by_part(design).at("operations-plain"), 4U);
}

TEST(FactorialDesign, RefusesCounts) {
  EXPECT_THROW(
      File(study("henon_heiles", "methods = \"gauss-8\"\nstep = 0.1", "quantities = [\"iterations\"]\n")).design(),
      InputError);
}

/// A reference in double-double cannot judge double-double: there, what needs it is not observed.
TEST(FactorialDesign, ObservesInHigherPrecisionWhatNeedsNoReference) {
  auto const observe =
      "quantities = [\"energy\", \"state\"]\nreference = { arithmetic = \"double-double\", members = 8 }\n";
  auto const design = File(study("henon_heiles", "methods = \"kutta-4\"\nstep = 0.1", observe)).design({"precision"});
  EXPECT_THAT(design.left_out, ElementsAre("state in double-double: its reference is in double-double"));
  ASSERT_EQ(design.parts.back().name, "higher-precision");
  EXPECT_THAT(design.parts.back().study.study.quantities, ElementsAre("energy"));
  EXPECT_EQ(cells_by_part(design).at("higher-precision"), 1U);
  EXPECT_EQ(cells_by_part(design).at("operations"), 1U) << "nothing else was asked for";
}

TEST(FactorialDesign, ChangesTheFactorsThatAreAskedFor) {
  File const file(study("henon_heiles", "methods = \"gauss-8\"\nstep = 0.1"));
  auto const cells = cells_by_part(file.design({"constants", "coefficients"}));
  EXPECT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells.at("operations"), 2U);
  try {
    file.design({"constant"});
    FAIL();
  } catch (InputError const& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'constants'?"));
  }
}

}  // namespace
}  // namespace brouwer
