// Starts depend on (seed, member) alone, follow their law, and are possible.
#include <brouwer/ensemble/start.hpp>
#include <brouwer/error.hpp>
#include <brouwer/systems/rigid_body.hpp>

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/ensemble/small_study.hpp"

namespace brouwer {
namespace {

using testing_support::small_study;

/// The first momentum component of many members.
std::vector<double> first_components(Perturbation const& perturbation, int members) {
  auto study = small_study();
  study.perturb = {{"momentum", perturbation}};
  auto const catalogue = builtin_catalogue();
  std::vector<double> values;
  for (int i = 0; i < members; ++i) values.push_back(member_start(study, catalogue.system("rigid_body"), i).state[0]);
  std::sort(values.begin(), values.end());
  return values;
}

/// Kolmogorov–Smirnov distance between sorted values and a distribution function, times √n.
template <class Cdf>
double kolmogorov(std::vector<double> const& sorted, Cdf cdf) {
  double worst = 0;
  auto const n = static_cast<double>(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    double const f = cdf(sorted[i]);
    worst = std::max({worst, f - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - f});
  }
  return worst * std::sqrt(n);
}

constexpr double level_0001 = 1.95;  // P(√n D > 1.95) = 0.001

TEST(MemberStart, FollowsItsLaw) {
  auto const uniform = first_components({Perturbation::Law::uniform, 1e-2}, 4000);
  EXPECT_LT(kolmogorov(uniform, [](double x) { return std::clamp((x - 1.79) / 0.02, 0.0, 1.0); }), level_0001);
  auto const normal = first_components({Perturbation::Law::normal, 1e-2}, 4000);
  EXPECT_LT(kolmogorov(normal, [](double x) { return gsl_cdf_gaussian_P(x - 1.8, 1e-2); }), level_0001);
}

TEST(MemberStart, MovesByWholeUlpsEachAsOften) {
  auto const values = first_components({Perturbation::Law::ulps, 2}, 5000);
  double const ulp = std::nextafter(1.8, 2) - 1.8;
  int counts[5] = {};
  for (double v : values) {
    double const k = (v - 1.8) / ulp;
    ASSERT_EQ(k, std::round(k));
    ASSERT_LE(std::abs(k), 2);
    ++counts[static_cast<int>(k) + 2];
  }
  for (int count : counts) EXPECT_NEAR(count, 1000, 4 * std::sqrt(1000 * 0.8));
}

TEST(MemberStart, DependsOnSeedAndMemberAlone) {
  auto study = small_study();
  auto const catalogue = builtin_catalogue();
  auto const& system = catalogue.system("rigid_body");
  auto const before = member_start(study, system, 5);
  study.members = 1'000'000;
  study.methods = {"dmv-2"};
  study.steps = 3;
  study.perturb["inertia"] = {Perturbation::Law::uniform, 1e-3};  // another field's numbers are its own
  auto const after = member_start(study, system, 5);
  EXPECT_EQ(before.state, after.state);
  EXPECT_NE(before.parameters, after.parameters);
  EXPECT_NE(member_start(study, system, 6).state, after.state);
  study.seed += 1;
  EXPECT_NE(member_start(study, system, 5).state, after.state);
}

TEST(MemberStart, IsDrawnAgainUntilTheBodyIsPossible) {
  auto study = small_study();
  study.perturb = {{"inertia", {Perturbation::Law::uniform, 0.3}}, {"attitude", {Perturbation::Law::normal, 0.5}}};
  auto const catalogue = builtin_catalogue();
  for (int i = 0; i < 500; ++i) {
    auto const start = member_start(study, catalogue.system("rigid_body"), i);
    EXPECT_FALSE(inertia_complaint(start.parameters)) << i;
    double const n = start.state[3] * start.state[3] + start.state[4] * start.state[4] +
                     start.state[5] * start.state[5] + start.state[6] * start.state[6];
    EXPECT_NEAR(n, 1, 1e-15);
  }
  auto impossible = catalogue.system("rigid_body");
  impossible.complaint = [](FieldValues const&) { return std::optional<std::string>("no"); };
  EXPECT_THROW(member_start(study, impossible, 0), InputError);
}

TEST(MemberStart, IsNominalWithoutPerturbation) {
  auto study = small_study();
  study.perturb.clear();
  auto const catalogue = builtin_catalogue();
  auto const& system = catalogue.system("rigid_body");
  EXPECT_EQ(member_start(study, system, 3).state, nominal_start(study, system).state);
  EXPECT_EQ(nominal_start(study, system).state, (std::vector<double>{1.8, 0.4, -0.9, 1, 0, 0, 0}));
}

TEST(Rounding, OfAStartToFloatIsWhatFloatHolds) {
  EXPECT_EQ(rounded_to("float", 0.1), static_cast<double>(0.1F));
  EXPECT_EQ(rounded_to("double", 0.1), 0.1);
  EXPECT_EQ(rounded_to("mpfr-256", 0.1), 0.1);
}

}  // namespace
}  // namespace brouwer
