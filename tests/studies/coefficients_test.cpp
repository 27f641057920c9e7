// The factor `coefficients` through the command line, with a catalogue that has a method for it.
#include <brouwer/ensemble/probe.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/read.hpp"
#include "tests/studies/in_process.hpp"

namespace brouwer {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr char const* study_text = R"([system.rigid_body]
[integrate]
methods = ["dmv-2", "preprocessed"]
coefficients = ["per-step", "per-trajectory"]
step = 0.01
steps = 100
[ensemble]
members = 4
perturb = { momentum = { uniform = 1e-2 } }
[observe]
quantities = "energy"
samples = { count = 8 }
[[expect]]
of = "energy"
where = { coefficients = "per-trajectory" }
drift = { per_step = [-1e-14, 1e-14] }
)";

/// dmv-2, twice: once as a method that lets a study choose its coefficients. It computes the same with either.
Catalogue const& catalogue() {
  static Catalogue const with_preprocessed = [] {
    auto all = builtin_catalogue();
    auto method = all.method("rigid_body", "dmv-2");
    method.name = "preprocessed";
    method.coefficients = {"per-step", "per-trajectory"};
    all.methods.push_back(method);
    return all;
  }();
  return with_preprocessed;
}

struct StudyOfCoefficients : InProcess {
  StudyOfCoefficients() : InProcess(study_text, catalogue()) {}
};

TEST_F(StudyOfCoefficients, IsRunTabulatedAndJudged) {
  auto const run = said({"run", study(), "-o", results(), "--no-figures"});
  EXPECT_THAT(run, HasSubstr("PASS  energy, preprocessed, double, per-trajectory coefficients, h = 0.01"));
  auto const table = said({"table", results(), "--format", "csv"});
  EXPECT_THAT(table, AllOf(HasSubstr("rigid_body,dmv-2,double,-,-,false"),
                           HasSubstr("rigid_body,preprocessed,double,-,per-step,false"),
                           HasSubstr("rigid_body,preprocessed,double,-,per-trajectory,false")));
}

TEST_F(StudyOfCoefficients, IsProbedCellByCell) {
  auto const file = read_study(study(), catalogue());
  ASSERT_EQ(file.plan.cells.size(), 3U);
  for (auto const& cell : file.plan.cells) {
    auto const errors = probe(file.study, catalogue(), cell, {}, RunOptions()).errors;
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].cell, cell);
    EXPECT_EQ(errors[0].rounding.rows(), 4) << "of this cell alone";
  }
}

TEST_F(StudyOfCoefficients, ListsWhichMethodsHaveThem) {
  auto const listed = said({"list", "methods"});
  auto const preprocessed = listed.substr(listed.find("\n  preprocessed"));
  EXPECT_THAT(preprocessed, HasSubstr("coefficients per-step, per-trajectory"));
  auto const plain = listed.find("\n  dmv-2"), after = listed.find("\n  dmv-4");
  EXPECT_THAT(listed.substr(plain, after - plain), Not(HasSubstr("coefficients per-step")));
}

}  // namespace
}  // namespace brouwer
