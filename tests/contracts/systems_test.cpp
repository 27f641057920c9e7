// Promises that every system keeps.
#include <brouwer/scalar/observing.hpp>
#include <brouwer/systems/kepler_flow.hpp>
#include <brouwer/systems/rigid_body_flow.hpp>

#include <gtest/gtest.h>

#include <set>

#include "tests/contracts/systems.hpp"
#include "tests/lanes.hpp"

namespace brouwer {
namespace {

using testing_support::components_of;
using testing_support::Judge;
using testing_support::moved;
using testing_support::same_bits;
using testing_support::SystemCase;
using testing_support::Uniform;
using testing_support::values_near_standard;

constexpr int cases = 4;

/// Σ mv = 0 to all digits of T, not only to those of a double: what the barycentre's rest hangs on.
template <class S>
void rest_the_barycentre(S const& system, typename S::State& y) {
  if constexpr (requires { system.barycentre(y); })
    for (std::size_t c = 0; c < 3; ++c) {
      typename S::Scalar planets(0);
      for (std::size_t i = 1; i < S::bodies; ++i) planets = planets + system.masses()[i] * y.p[3 * i + c];
      y.p[c] = -planets / system.masses()[0];
    }
}

/// What a coordinate's velocity is multiplied with to become its momentum.
template <class S>
typename S::Scalar mass_of(S const& system, std::size_t coordinate) {
  if constexpr (requires { system.masses(); })
    return system.masses()[coordinate / 3];
  else
    return typename S::Scalar((void(system), void(coordinate), 1));
}

template <class Family>
struct EverySystem : testing::Test {
  using InJudge = typename Family::template In<Judge>;
  SystemDescription const description = Family::describe();
  Uniform uniform{20260501};

  template <class T>
  SystemCase<typename Family::template In<T>> random_case() {
    return {description, values_near_standard(description, uniform)};
  }
};
TYPED_TEST_SUITE(EverySystem, testing_support::Systems);

TYPED_TEST(EverySystem, IsWhatEnsemblesAndIntegratorsAskForInEveryArithmetic) {
  auto const check = []<class T>(T const&) {
    using S = typename TypeParam::template In<T>;
    static_assert(FieldSystem<S>);
    static_assert(std::same_as<typename S::template In<double>, typename TypeParam::template In<double>>);
    if constexpr (TypeParam::separable) static_assert(SeparableSystem<S>);
  };
  check(1.0F), check(1.0), check(1.0L), check(Float128(1)), check(Judge(1)), check(DoubleDouble<double>(1));
  check(Pack<double, 4>(1)), check(Pack<float, 8>(1)), check(DoubleDouble<Pack<double, 4>>(1));
  EXPECT_EQ(this->description.has_exact_flow, HasExactFlow<typename TestFixture::InJudge>);
}

TYPED_TEST(EverySystem, AndItsDescriptionAgreeOnCounts) {
  using S = typename TypeParam::template In<double>;
  auto const& d = this->description;
  std::size_t const size = components_of(this->template random_case<double>().state).size();
  EXPECT_EQ(d.count(Quantity::Kind::integral), static_cast<std::size_t>(S::first_integral_count));
  EXPECT_EQ(d.count(Quantity::Kind::state), static_cast<std::size_t>(S::state_error_count));
  EXPECT_EQ(d.state_components.size(), size);
  EXPECT_LE(d.always_integrated, size);
  EXPECT_LT(std::max(d.plane[0], d.plane[1]), size);
  EXPECT_EQ(testing_support::numbers_of(d, testing_support::standard_values(d), false).size(), size);
}

TYPED_TEST(EverySystem, NamesEverythingOnceAndSaysItsUnits) {
  auto const& d = this->description;
  std::set<std::string> components, quantities, fields;
  for (auto const& quantity : d.quantities) {
    EXPECT_TRUE(quantities.insert(quantity.name).second) << quantity.name;
    EXPECT_FALSE(quantity.unit.empty() || quantity.help.empty() || quantity.components.empty()) << quantity.name;
    for (auto const& name : quantity.components) EXPECT_TRUE(components.insert(name).second) << name;
  }
  for (auto const& field : d.fields) {
    EXPECT_TRUE(fields.insert(field.name).second) << field.name;
    EXPECT_FALSE(field.unit.empty() || field.help.empty()) << field.name;
    EXPECT_EQ(field.standard.size(), static_cast<std::size_t>(field.size)) << field.name;
  }
  EXPECT_EQ(std::set(d.state_components.begin(), d.state_components.end()).size(), d.state_components.size());
}

/// ∂H/∂cₖ by a central difference of 10⁻²⁰, whose error is 10⁻⁴⁰.
template <class S>
std::vector<Judge> energy_gradient(S const& system, typename S::State const& y) {
  auto const at = components_of(y);
  Judge const h("1e-20");
  std::vector<Judge> gradient;
  for (std::size_t k = 0; k < at.size(); ++k) {
    auto up = at, down = at;
    up[k] += h;
    down[k] -= h;
    auto const energy = [&](auto const& c) {
      return first_integrals(system, S::State::from_components(c), Judge(0))[0];
    };
    gradient.push_back((energy(up) - energy(down)) / (2 * h));
  }
  return gradient;
}

/// M q̇ = ∂H/∂p, M ṗ = −∂H/∂q with M = 1, or the masses where p are velocities.
template <class S, int n>
std::vector<Judge> motion(S const& system, PhaseState<Judge, n> const&, std::vector<Judge> const& gradient) {
  std::vector<Judge> rate(2 * n);
  for (std::size_t k = 0; k < n; ++k) {
    rate[k] = gradient[n + k] / mass_of(system, k);
    rate[n + k] = -gradient[k] / mass_of(system, k);
  }
  return rate;
}

/// The Lie–Poisson structure of the rigid body: ẏ = y × ∂H/∂y, and q̇ = ½ q ⊗ (0, ∂H/∂y).
std::vector<Judge> motion(RigidBody<Judge> const&, RigidBodyState<Judge> const& s, std::vector<Judge> const& gradient) {
  auto const y = cross(s.momentum, {gradient[0], gradient[1], gradient[2]});
  auto const q = hamilton_product(s.attitude, {Judge(0), gradient[0] / 2, gradient[1] / 2, gradient[2] / 2});
  return {y[0], y[1], y[2], q.w(), q.x(), q.y(), q.z()};
}

TYPED_TEST(EverySystem, MovesAlongTheSymplecticGradientOfItsEnergyTo36Digits) {
  for (int i = 0; i < cases; ++i) {
    auto const one = this->template random_case<Judge>();
    auto const rate = components_of(one.system.rate(one.state)),
               expected = motion(one.system, one.state, energy_gradient(one.system, one.state));
    ASSERT_EQ(rate.size(), expected.size());
    // where a mass of 10⁻⁸ is divided by, the difference quotient's error is
    for (std::size_t k = 0; k < rate.size(); ++k) EXPECT_LT(abs(Judge(rate[k] - expected[k])), Judge("1e-36")) << k;
  }
}

TYPED_TEST(EverySystem, ConservesItsFirstIntegralsTo36Digits) {
  Judge const e("1e-20");
  for (int i = 0; i < cases; ++i) {
    auto one = this->template random_case<Judge>();
    rest_the_barycentre(one.system, one.state);
    auto const rate = one.system.rate(one.state);
    auto const ahead = first_integrals(one.system, moved(one.state, rate, e), Judge(0)),
               behind = first_integrals(one.system, moved(one.state, rate, Judge(-e)), Judge(0));
    auto const scales = one.system.first_integral_scales(one.state);
    for (std::size_t k = 0; k < ahead.size(); ++k) {
      EXPECT_GT(scales[k], 0);
      EXPECT_LT(abs(Judge((ahead[k] - behind[k]) / (2 * e * scales[k]))), Judge("1e-36")) << k;
    }
  }
}

TYPED_TEST(EverySystem, HasARateThatIsRightToRoundingInEveryArithmetic) {
  auto const check = [this]<class T>(T const&) {
    for (int i = 0; i < cases; ++i) {
      auto const values = values_near_standard(this->description, this->uniform);
      SystemCase<typename TypeParam::template In<T>> const one(this->description, values);
      auto const wide = one.system.template in<Judge>();
      std::vector<Judge> numbers;
      for (auto const& number : one.numbers) numbers.push_back(static_cast<Judge>(number));
      auto const computed = components_of(one.system.rate(one.state)),
                 exact = components_of(wide.rate(decltype(wide)::State::from_components(numbers)));
      Judge largest = 0, error = 0;
      for (std::size_t k = 0; k < exact.size(); ++k) {
        largest = larger(largest, Judge(abs(exact[k])));
        error = larger(error, Judge(abs(Judge(static_cast<Judge>(computed[k]) - exact[k]))));
      }
      EXPECT_LT(static_cast<double>(Judge(error / largest)), 8 * static_cast<double>(epsilon<T>()));
    }
  };
  check(1.0F), check(1.0), check(1.0L), check(Float128(1)), check(DoubleDouble<double>(1));
}

TYPED_TEST(EverySystem, IsTheSameSystemInAWiderArithmetic) {
  using Narrow = typename TypeParam::template In<float>;
  SystemCase<Narrow> const narrow(this->description, values_near_standard(this->description, this->uniform));
  std::vector<Judge> const parameters(narrow.parameters.begin(), narrow.parameters.end()),
      numbers(narrow.numbers.begin(), narrow.numbers.end());
  using Wide = typename TestFixture::InJudge;
  auto const y = Wide::State::from_components(numbers);
  EXPECT_EQ(components_of(narrow.system.template in<Judge>().rate(y)),
            components_of(Wide(std::span<Judge const>(parameters)).rate(y)));
}

TYPED_TEST(EverySystem, SeesNoErrorInAStateThatIsItsReference) {
  auto const one = this->template random_case<double>();
  for (double error : one.system.state_errors(one.state, one.state)) EXPECT_EQ(error, 0);
}

TYPED_TEST(EverySystem, SeesHowLongAStateIsAhead) {
  Judge const t("1e-30");
  auto const one = this->template random_case<Judge>();
  auto const errors = one.system.state_errors(moved(one.state, one.system.rate(one.state), t), one.state);
  std::size_t k = 0, phases = 0;
  for (auto const& quantity : this->description.quantities) {
    if (quantity.kind != Quantity::Kind::state) continue;
    for (auto const& name : quantity.components) {
      if (name.starts_with("phase")) {
        EXPECT_LT(abs(Judge(errors[k] / t - 1)), Judge("1e-25")) << name;
        ++phases;
      }
      ++k;
    }
  }
  EXPECT_GE(phases, 1U);
}

TYPED_TEST(EverySystem, RefusesImpossibleValuesAndNotTheStandardOnes) {
  auto const& d = this->description;
  auto const standard = testing_support::standard_values(d);
  EXPECT_EQ(d.complaint(standard), std::nullopt);
  EXPECT_EQ(d.warning ? d.warning(standard) : std::nullopt, std::nullopt);
  for (auto const& field : d.fields)
    for (std::size_t c = 0; c < field.standard.size(); ++c)
      for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        auto values = standard;
        values.at(field.name)[c] = bad;
        EXPECT_NE(d.complaint(values), std::nullopt) << field.name << ' ' << c;
      }
  for (auto const& refused : testing_support::refused_values()) {
    if (refused.system != d.name) continue;
    auto values = standard;
    values.at(refused.field) = refused.values;
    auto const complaint = d.complaint(values);
    ASSERT_NE(complaint, std::nullopt) << refused.field;
    EXPECT_NE(complaint->find(refused.field), std::string::npos) << *complaint << " does not name " << refused.field;
  }
}

TYPED_TEST(EverySystem, KnowsOfNoFailureWhereNothingIsTheMatter) {
  auto const one = this->template random_case<double>();
  if constexpr (KnowsFailures<typename TypeParam::template In<double>, decltype(one.state)>) {
    EXPECT_EQ(one.system.failure(one.state, 0), Failure::none);
  }
}

template <class Family, class T, int N>
void expect_lanes_to_be_scalars(SystemDescription const& description, Uniform& uniform) {
  using P = Pack<T, N>;
  using S = typename Family::template In<P>;
  using One = SystemCase<typename Family::template In<T>>;
  std::vector<One> members, references;
  for (int l = 0; l < N; ++l) {
    members.emplace_back(description, values_near_standard(description, uniform));
    references.emplace_back(description, values_near_standard(description, uniform));
  }
  auto const gathered = [](std::vector<One> const& ones, auto part) {
    std::vector<P> packs((ones[0].*part).size());
    for (std::size_t k = 0; k < packs.size(); ++k)
      packs[k] = from_lanes<P>([&](int l) { return (ones[static_cast<std::size_t>(l)].*part)[k]; });
    return packs;
  };
  auto const parameters = gathered(members, &One::parameters);
  S const system{std::span<P const>(parameters)};
  auto const y = S::State::from_components(gathered(members, &One::numbers)),
             z = S::State::from_components(gathered(references, &One::numbers));
  T const h = T(1) / T(8);
  auto const expect_equal = [](auto const& pack, auto const& scalar, int l, char const* what) {
    for (std::size_t k = 0; k < scalar.size(); ++k)
      EXPECT_TRUE(same_bits(lane(pack[k], l), scalar[k])) << what << ' ' << k << ", lane " << l << " of " << N;
  };
  for (int l = 0; l < N; ++l) {
    auto const& one = members[static_cast<std::size_t>(l)];
    auto const& other = references[static_cast<std::size_t>(l)].state;
    expect_equal(components_of(system.rate(y)), components_of(one.system.rate(one.state)), l, "rate");
    expect_equal(first_integrals(system, y, P(h)), first_integrals(one.system, one.state, h), l, "integral");
    expect_equal(system.first_integral_scales(y), one.system.first_integral_scales(one.state), l, "scale");
    expect_equal(system.state_errors(y, z), one.system.state_errors(one.state, other), l, "error");
    if constexpr (Family::separable) expect_equal(system.force(y.q), one.system.force(one.state.q), l, "force");
  }
}

TYPED_TEST(EverySystem, IsObservedInTwiceTheBitsOfADoubleInLanesToo) {
  using P = DoubleDouble<Pack<double, 4>>;
  auto const values = values_near_standard(this->description, this->uniform);
  SystemCase<typename TypeParam::template In<double>> const one(this->description, values);
  SystemCase<typename TypeParam::template In<DoubleDouble<double>>> const alone(this->description, values);
  SystemCase<typename TypeParam::template In<Judge>> const judge(this->description, values);
  std::vector<P> numbers;
  for (double number : one.numbers) numbers.emplace_back(Pack<double, 4>(number));
  using Packed = typename TypeParam::template In<P>;
  Packed const packed =
      SystemCase<typename TypeParam::template In<Pack<double, 4>>>(this->description, values).system.template in<P>();
  auto const in_lanes = first_integrals(packed, Packed::State::from_components(numbers), P(0)),
             scales = packed.first_integral_scales(Packed::State::from_components(numbers));
  auto const by_itself = first_integrals(alone.system, alone.state, DoubleDouble<double>(0));
  auto const exact = first_integrals(judge.system, judge.state, Judge(0));
  for (std::size_t k = 0; k < exact.size(); ++k) {
    EXPECT_TRUE(all(scales[k] > P(0)));
    EXPECT_LT(abs(Judge(static_cast<Judge>(by_itself[k]) - exact[k])), Judge("1e-29")) << k;
    for (int l = 0; l < 4; ++l) EXPECT_TRUE(lane(in_lanes[k], l) == by_itself[k]) << k << ", lane " << l;
  }
  SystemCase<typename TypeParam::template In<Float128>> const wide(this->description, values);
  for (auto const& error : wide.system.state_errors(wide.state, wide.state)) EXPECT_EQ(error, 0);
}

TYPED_TEST(EverySystem, HasTheBitsOfItsScalarRunInEveryLane) {
  expect_lanes_to_be_scalars<TypeParam, double, 2>(this->description, this->uniform);
  expect_lanes_to_be_scalars<TypeParam, double, 4>(this->description, this->uniform);
  expect_lanes_to_be_scalars<TypeParam, double, 8>(this->description, this->uniform);
  expect_lanes_to_be_scalars<TypeParam, float, 4>(this->description, this->uniform);
  expect_lanes_to_be_scalars<TypeParam, float, 8>(this->description, this->uniform);
}

}  // namespace
}  // namespace brouwer
