// What the benchmarks count is what is done, and counting changes no bit.
#include "tests/benchmarks/counting.hpp"

#include <brouwer/integrators/dmv.hpp>
#include <brouwer/integrators/elliptic_branch_free.hpp>
#include <brouwer/integrators/elliptic_naive.hpp>
#include <brouwer/scalar/double_double.hpp>
#include <gtest/gtest.h>

#include "tests/bodies.hpp"
#include "tests/lanes.hpp"

namespace brouwer {
namespace {

using C = Counting<double>;
using testing_support::same_bits;

template <class F>
Operations counted(F f) {
  C::done = {};
  f();
  return C::done;
}

TEST(Counting, IsReal) {
  static_assert(Real<C> && Real<Counting<float>> && Real<DoubleDouble<C>>);
  static_assert(OwnElementary<C>, "or sin and cos would be a library's");
}

TEST(Counting, CountsEveryOperationOnceByItsKind) {
  C const a(2), b(3);
  EXPECT_EQ(counted([&] { a + b - b; }), (Operations{.additions = 2}));
  EXPECT_EQ(counted([&] { 2 * a* b / b; }), (Operations{.multiplications = 2, .divisions = 1}));
  EXPECT_EQ(counted([&] { sqrt(squared(a)); }), (Operations{.multiplications = 1, .roots = 1}));
  EXPECT_EQ(counted([&] { larger(a, b); }), (Operations{.comparisons = 1}));
  EXPECT_EQ(counted([&] { -abs(copysign(a, b)); }), Operations{});
  EXPECT_EQ(counted([&] { two_prod(a, b); }).flops(), 3) << "a product and a fused operation, which is two";
}

TEST(Counting, AgreesWithWhatFormulasAreSaidToCost) {
  C const a(2), b(3);
  EXPECT_EQ(counted([&] { two_sum(a, b); }).flops(), 6);
  EXPECT_EQ(counted([&] { fast_two_sum(a, b); }).flops(), 3);
  DoubleDouble<C> const x(a), y(b);
  EXPECT_EQ(counted([&] { x + y; }), (Operations{.additions = 20}));
  EXPECT_EQ(counted([&] { x* y; }), (Operations{.additions = 4, .multiplications = 2, .fused = 2}));
  Quaternion<C> const q(a, b, a, b);
  EXPECT_EQ(counted([&] { hamilton_product(q, q); }), (Operations{.additions = 12, .multiplications = 16}));
}

/// The same steps in E and in Counting<E>.
template <template <class> class Stepper>
void expect_the_same_bits() {
  for (auto const& body : testing_support::generic_bodies()) {
    auto alone = body.start<double>();
    advance(Stepper<double>({body.body<double>(), 0.1, alone}), alone, 100);
    auto with_count = body.start<C>();
    Stepper<C> const step({body.body<C>(), C(0.1), with_count});
    EXPECT_GT(counted([&] { advance(step, with_count, 100); }).flops(), 5000);
    for_components([&](double a, C b) { EXPECT_TRUE(same_bits(a, b.value())) << body.name; }, alone, with_count);
  }
}

template <class T>
using Dmv10PerStep = Dmv10<T, PerStep>;
template <class T>
using Naive = EllipticNaive<T, OwnElliptic>;

TEST(Counting, LeavesEveryBitOfAStepAlone) {
  expect_the_same_bits<Dmv10PerStep>();
  expect_the_same_bits<EllipticIncrement>();
  expect_the_same_bits<Naive>();
}

}  // namespace
}  // namespace brouwer
