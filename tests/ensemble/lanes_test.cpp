// Members as lanes: whatever the instruction set, a member's bits are those that it has alone.
#include <brouwer/ensemble/run.hpp>
#include <brouwer/ensemble/start.hpp>
#include <brouwer/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "tests/ensemble/small_study.hpp"

namespace brouwer {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;
using testing_support::levels_or_none;
using testing_support::small_study;
using testing_support::standard_study;

Catalogue const& catalogue() {
  static Catalogue const all = builtin_catalogue();
  return all;
}

/// Those that this processor has, narrowest first.
std::vector<InstructionSet> pack_sets() {
  std::vector<InstructionSet> sets;
  for (auto const set : {InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512})
    if (set <= widest_instruction_set()) sets.push_back(set);
  return sets;
}

/// Members of different bodies, in both branches, one at rest, one that fails where steps can be too large.
std::vector<Start> mixed_bodies() {
  auto study = small_study();
  study.perturb = {{"momentum", {Perturbation::Law::uniform, 1.0}}, {"inertia", {Perturbation::Law::uniform, 0.1}}};
  std::vector<Start> starts;
  for (std::int64_t i = 0; i < 37; ++i) starts.push_back(member_start(study, catalogue().system("rigid_body"), i));
  starts[5].state = {0, 0, 1.5, 1, 0, 0, 0};
  starts[11].state = {40, -30, 20, 1, 0, 0, 0};
  return starts;
}

/// The standard start, in ways that differ by some per cent in every number, and one that is no number.
std::vector<Start> mixed_starts(SystemDescription const& system) {
  if (system.name == "rigid_body") return mixed_bodies();
  auto study = standard_study(system);
  for (auto const& field : system.fields)
    if (!field.parameter) study.perturb[field.name] = {Perturbation::Law::uniform, 0.03};
  std::vector<Start> starts;
  for (std::int64_t i = 0; i < 19; ++i) starts.push_back(member_start(study, system, i));
  starts[11].state[0] = std::numeric_limits<double>::quiet_NaN();
  return starts;
}

std::uint64_t bits(double x) { return std::isnan(x) ? 0 : std::bit_cast<std::uint64_t>(x); }

/// Everything that can be seen of trajectories, as bits.
std::vector<std::uint64_t> seen(Trajectories const& trajectories, SystemDescription const& system) {
  std::vector<std::uint64_t> all;
  std::vector<double> errors(trajectories.members() * system.count(Quantity::Kind::integral));
  trajectories.first_integral_errors(errors);
  for (double e : errors) all.push_back(bits(e));
  std::vector<Widest> state(system.state_components.size());
  for (std::size_t i = 0; i < trajectories.members(); ++i) {
    trajectories.state(i, state);
    for (auto const& component : state) {
      double const high = static_cast<double>(component);
      all.push_back(bits(high));
      all.push_back(bits(std::isfinite(high) ? static_cast<double>(Widest(component - high)) : 0));
    }
    all.push_back(bits(trajectories.iterations(i)));
    auto const failure = trajectories.failure(i);
    all.push_back(failure ? static_cast<std::uint64_t>(failure->step) : ~std::uint64_t{0});
    all.push_back(failure ? static_cast<std::uint64_t>(failure->reason) : 0);
  }
  return all;
}

struct Case {
  MethodEntry const* method;
  CellLabels cell;
};

std::vector<Case> cases(std::string const& system) {
  std::vector<Case> all;
  for (auto const& method : catalogue().methods)
    for (char const* arithmetic : {"float", "double", "double-double"})
      for (auto const& coefficients : levels_or_none(method.coefficients))
        for (bool const compensation : {false, true})
          if (method.system == system && method.runs_in_lanes && (!compensation || method.compensable))
            all.push_back({&method,
                           {method.system, method.name, arithmetic, method.uses_special_functions ? "own" : no_level,
                            coefficients, compensation, 10 * catalogue().system(method.system).usual_step, 12}});
  return all;
}

struct LanesOf : testing::TestWithParam<std::string> {};
std::vector<std::string> system_names() {
  std::vector<std::string> names;
  for (auto const& system : catalogue().systems) names.push_back(system.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Each, LanesOf, testing::ValuesIn(system_names()), [](auto const& one) { return one.param; });

TEST_P(LanesOf, EveryMethodAndInstructionSetAreTheScalarRunsBitForBit) {
  auto const& system = catalogue().system(GetParam());
  auto const starts = mixed_starts(system);
  int compared = 0;
  for (auto const& [method, cell] : cases(system.name)) {
    auto const alone = begin_trajectories(catalogue(), cell, starts, true, InstructionSet::none);
    alone->advance(12);
    auto const expected = seen(*alone, system);
    for (auto const set : pack_sets()) {
      auto const together = begin_trajectories(catalogue(), cell, starts, true, set);
      together->advance(5);  // in two parts
      together->advance(7);
      EXPECT_EQ(seen(*together, system), expected) << cell.method << ' ' << cell.arithmetic << ' ' << cell.coefficients
                                                   << ' ' << cell.compensation << ' ' << name_of(set);
      ++compared;
    }
  }
  EXPECT_GE(compared, 50) << "the catalogue must have methods that run in lanes";
}

TEST(Lanes, AreWhatRuns) {
  // the packs of every set are there, and each is another maker than that of single numbers
  for (auto const& method : catalogue().methods) {
    if (!method.runs_in_lanes) continue;
    for (auto const set : pack_sets())
      EXPECT_EQ(std::count_if(method.makers.begin(), method.makers.end(), [&](auto const& m) { return m.set == set; }),
                1)
          << method.name << ' ' << name_of(set);
  }
}

TEST(Lanes, LeaveTheUnitsOfAStudyAsTheyAre) {
  auto study = small_study();
  study.methods = {"elliptic-increment", "elliptic-naive", "dmv-2", "dmv-10"};
  study.special_functions = {"own", "gsl"};  // the latter runs number by number
  study.coefficients = {"per-step", "per-trajectory"};
  study.reference = {Reference::Kind::same_method, "double-double", 10};
  auto const plan = make_plan(study, catalogue());
  Progress progress;
  for (auto const& unit : plan.units) {
    auto const record = [&](InstructionSet set) {
      return compute_unit(study, catalogue(), plan, unit, "hash", progress, nullptr, set).record;
    };
    auto const alone = record(InstructionSet::none);
    for (auto const set : pack_sets()) {
      auto const together = record(set);
      EXPECT_EQ(together.start, alone.start);
      EXPECT_EQ(together.final_state, alone.final_state);
      ASSERT_EQ(together.series.size(), alone.series.size());
      for (std::size_t s = 0; s < alone.series.size(); ++s)
        EXPECT_EQ(together.series[s].errors, alone.series[s].errors)
            << alone.cell.method << ' ' << alone.series[s].name << ' ' << name_of(set);
    }
  }
}

TEST(InstructionSets, HaveNamesAndAreRefusedWhereTheProcessorLacksThem) {
  EXPECT_EQ(instruction_set("sse2"), InstructionSet::sse2);
  EXPECT_EQ(instruction_set("none"), InstructionSet::none);
  EXPECT_EQ(name_of(InstructionSet::avx512), "avx512");
  EXPECT_THAT([] { instruction_set("avx-2"); }, ThrowsMessage<InputError>(HasSubstr("'avx-2'; did you mean 'avx2'?")));
  if (widest_instruction_set() < InstructionSet::avx512) {
    EXPECT_THAT([] { instruction_set("avx512"); }, ThrowsMessage<InputError>(HasSubstr("does not have avx512")));
  }
}

}  // namespace
}  // namespace brouwer
