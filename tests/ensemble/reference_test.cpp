// A double-double reference is checked against mpfr-256, and replaced where it fails.
#include <brouwer/ensemble/reference.hpp>
#include <brouwer/ensemble/run.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/ensemble/small_study.hpp"

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Study study_with_double_double() {
  auto study = testing_support::small_study();
  study.reference = {Reference::Kind::same_method, "double-double", 8};
  return study;
}

/// The built-in methods, but double-double takes a slightly other step: a reference that is not sound.
Catalogue with_broken_double_double() {
  auto catalogue = builtin_catalogue();
  for (auto& method : catalogue.methods)
    for (auto& maker : method.makers)
      maker.begin = [sound = maker.begin](TrajectoryRequest request) {
        if (request.arithmetic == "double-double") request.step *= 1 + 0x1p-40;
        return sound(request);
      };
  return catalogue;
}

TEST(DoubleDoubleReference, IsSoundForEveryMethod) {
  auto const catalogue = builtin_catalogue();
  auto study = study_with_double_double();
  study.methods.clear();
  for (auto const& method : catalogue.methods)
    if (method.system == study.system) study.methods.push_back(method.name);
  study.coefficients = {"per-step", "per-trajectory"};
  auto plan = make_plan(study, catalogue);
  EXPECT_THAT(check_references(study, catalogue, plan), IsEmpty());
  EXPECT_THAT(plan.references, testing::Each("double-double"));
  auto const check = check_reference(study, catalogue, plan.cells.front());
  EXPECT_EQ(check.steps, 200);
  EXPECT_EQ(check.members, 2);
  EXPECT_LT(check.worst, 1e-12);
  EXPECT_GT(check.worst, 0) << "it must have compared something";
}

TEST(DoubleDoubleReference, ThatFailsIsReplacedWithASentence) {
  auto const catalogue = with_broken_double_double();
  auto study = study_with_double_double();
  study.methods = {"dmv-2"};
  study.compensation = {false};
  auto plan = make_plan(study, catalogue);
  auto const sentences = check_references(study, catalogue, plan);
  EXPECT_THAT(sentences, ElementsAre(HasSubstr("double-double reference of dmv-2")));
  EXPECT_THAT(sentences.front(), HasSubstr("replaced by mpfr-256"));
  EXPECT_THAT(plan.references, ElementsAre("mpfr-256"));
  // and the unit is judged by what it says
  Progress progress;
  auto const record = compute_unit(study, catalogue, plan, plan.units[0], "hash", progress, nullptr).record;
  EXPECT_EQ(record.reference, "mpfr-256");
  for (auto const& series : record.series)
    for (double e : series.errors) EXPECT_LT(std::abs(e), 1e-13) << series.name;
}

TEST(DoubleDoubleReference, ThatIsNoNumberInOneMemberAloneFails) {
  auto catalogue = builtin_catalogue();
  for (auto& method : catalogue.methods)
    for (auto& maker : method.makers)
      maker.begin = [sound = maker.begin](TrajectoryRequest request) {
        if (request.arithmetic == "double-double") request.starts.front().state.front() = std::nan("");
        return sound(request);
      };
  auto study = study_with_double_double();
  study.methods = {"dmv-2"};
  study.compensation = {false};
  auto plan = make_plan(study, catalogue);
  EXPECT_FALSE(check_reference(study, catalogue, plan.cells.front()).passed());
  EXPECT_EQ(check_references(study, catalogue, plan).size(), 1U);
}

TEST(DoubleDoubleReference, AgreesWithFloat128ToTheLastDigitsOfAnError) {
  auto const catalogue = builtin_catalogue();
  auto study = study_with_double_double();
  study.quantities = {"state"};
  auto const errors = [&](char const* arithmetic) {
    study.reference.arithmetic = arithmetic;
    auto const plan = make_plan(study, catalogue);
    Progress progress;
    std::vector<double> all;
    for (auto const& series : compute_unit(study, catalogue, plan, plan.units[0], "", progress, nullptr).record.series)
      all.insert(all.end(), series.errors.begin(), series.errors.end());
    return all;
  };
  auto const by_pairs = errors("double-double"), by_quads = errors("float128");
  ASSERT_EQ(by_pairs.size(), by_quads.size());
  for (std::size_t i = 0; i < by_pairs.size(); ++i) EXPECT_NEAR(by_pairs[i], by_quads[i], 1e-28);
}

TEST(Reference, IsNotCheckedWhereNothingIsCompared) {
  auto const catalogue = with_broken_double_double();
  auto study = study_with_double_double();
  study.quantities = {"energy"};
  auto plan = make_plan(study, catalogue);
  EXPECT_THAT(check_references(study, catalogue, plan), IsEmpty());
}

}  // namespace
}  // namespace brouwer
