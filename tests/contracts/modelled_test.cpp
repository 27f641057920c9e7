// By the standard rule, a stepper over modelled numbers makes the bits that it makes over float and double.
#include <brouwer/scalar/modelled.hpp>

#include <gtest/gtest.h>

#include "tests/bodies.hpp"
#include "tests/contracts/field_methods.hpp"
#include "tests/contracts/field_systems.hpp"
#include "tests/contracts/steppers.hpp"
#include "tests/lanes.hpp"

namespace brouwer {
namespace {

using testing_support::field_methods;
using testing_support::FieldMethod;

template <class T>
T value_of_number(T const& a) {
  return a;
}
template <class T>
T value_of_number(Modelled<T> const& a) {
  return a.value();
}

/// After each of some steps, component by component.
template <class S, class Y>
auto orbit(S const& step, Y y, int steps) {
  std::vector<decltype(value_of_number(typename S::Scalar{}))> numbers;
  for (int i = 0; i < steps; ++i) {
    take_step(step, y);
    for_components([&](auto const& c) { numbers.push_back(value_of_number(c)); }, value_of(y));
  }
  return numbers;
}

template <class T>
void expect_same(std::vector<T> const& expected, std::vector<T> const& found) {
  ASSERT_EQ(expected.size(), found.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    ASSERT_TRUE(testing_support::same_bits(expected[i], found[i]))
        << "number " << i << ": " << expected[i] << ", " << found[i];
}

template <class Family>
struct ModelledStepper : testing::Test {
  template <class T, class Y>
  static auto run(testing_support::BodyCase const& body) {
    brouwer::Setup<RigidBody<T>> const setup{body.body<T>(), T(1) / T(16), body.start<T>(), true};
    using S = typename Family::template In<T>;
    return orbit(S(setup), Y(setup.start), 60);
  }
  template <class T>
  static void expect_bits_of() {
    using M = Modelled<T>;
    for (auto const& body : testing_support::generic_bodies()) {
      expect_same(run<T, RigidBodyState<T>>(body), run<M, RigidBodyState<M>>(body));
      if constexpr (IncrementStep<typename Family::template In<T>>)
        expect_same(run<T, Compensated<RigidBodyState<T>>>(body), run<M, Compensated<RigidBodyState<M>>>(body));
    }
  }
};
TYPED_TEST_SUITE(ModelledStepper, testing_support::RigidBodySteppersInLanes);

TYPED_TEST(ModelledStepper, HasTheBitsOfItsTypeByTheStandardRule) {
  this->template expect_bits_of<double>();
  this->template expect_bits_of<float>();
}

struct ModelledFieldMethod : testing::TestWithParam<FieldMethod> {
  template <class T>
  static auto run(FieldMethod const& method) {
    using System = HenonHeiles<T>;
    std::vector<T> const start{T(0.12), T(-0.2), T(0.3), T(0.25)};
    brouwer::Setup<System> const setup{System(std::span<T const>()), T(1) / T(16),
                                       System::State::from_components(start)};
    decltype(orbit(ImplicitRungeKutta<System>(setup, implicit_methods()[0], CoefficientForm::standard), setup.start,
                   1)) numbers;
    testing_support::with_step<System>(method, setup,
                                       [&](auto const& step) { numbers = orbit(step, setup.start, 40); });
    return numbers;
  }
};

TEST_P(ModelledFieldMethod, HasTheBitsOfItsTypeByTheStandardRule) {
  expect_same(run<double>(GetParam()), run<Modelled<double>>(GetParam()));
}
INSTANTIATE_TEST_SUITE_P(All, ModelledFieldMethod, testing::ValuesIn(field_methods()),
                         [](auto const& each) { return testing_support::identifier(each.param.name); });

/// Coefficients are kept from the first use on: each kind of constants has its own.
TEST(KeptCoefficients, AreThoseOfTheirKindOfConstants) {
  using M = Modelled<double>;
  auto const form = CoefficientForm::standard;
  auto const& method = implicit_methods()[3];
  for (bool const exact : {false, true}) {
    ContextScope const scope(OperationContext{{.exact_constants = exact}, true, {}});
    auto const& c = implicit_coefficients<M>(method, CoefficientForm::symplectic);
    EXPECT_EQ(c.m[0][1].rest() != 0, exact);  // 1 − μ₁₀, formed in the working precision
    EXPECT_EQ((c.m[0][1] + c.m[1][0]).value(), 1);
    EXPECT_EQ(implicit_coefficients<M>(method, form).v[0].value(), implicit_coefficients<double>(method, form).v[0]);
  }
}

}  // namespace
}  // namespace brouwer
