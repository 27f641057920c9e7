// Elliptic functions and integrals in packs: every lane has the scalar's bits, whatever its neighbours need.
#include <brouwer/special/elliptic.hpp>

#include <gtest/gtest.h>

#include "tests/lanes.hpp"
#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::packed;
using testing_support::same_bits;
using testing_support::Uniform;

/// Generic and near 1, so that lanes converge after different numbers of stages; 0 and 1 among them.
template <class E>
std::vector<E> moduli(int count) {
  Uniform uniform(21);
  std::vector<E> ks;
  for (int i = 0; i < count; ++i) {
    double const near_one = 1 - std::pow(10.0, uniform(-16, -1)), generic = uniform(0, 1);
    ks.push_back(static_cast<E>(i % 7 == 0 ? 0 : i % 11 == 0 ? 1 : i % 3 == 0 ? near_one : generic));
  }
  return ks;
}

template <class E>
std::vector<E> sizes(int count, double largest) {
  Uniform uniform(22);
  std::vector<E> us;
  for (int i = 0; i < count; ++i) {
    double const scale = i % 13 == 0 ? 0 : i % 5 == 0 ? std::pow(10.0, uniform(-30, 0)) : 1;
    us.push_back(static_cast<E>(scale * uniform(-largest, largest)));
  }
  return us;
}

template <class T>
struct EllipticLanes : testing::Test {
  using E = Element<T>;
  static constexpr int count = 20'000;
  std::vector<T> ks = packed<T>(moduli<E>(count)), us = packed<T>(sizes<E>(count, 10)),
                 phis = packed<T>(sizes<E>(count, 3.14));

  template <class F>
  int differing(F function) const {
    int found = 0;
    for (std::size_t n = 0; n < ks.size(); ++n) {
      T const result = function(ks[n], us[n], phis[n]);
      for (int i = 0; i < lanes<T>; ++i)
        if (!same_bits(result[i], function(E(ks[n][i]), E(us[n][i]), E(phis[n][i])))) ++found;
    }
    return found;
  }
};
using Packs =
    testing::Types<Pack<double, 2>, Pack<double, 4>, Pack<double, 8>, Pack<float, 4>, Pack<float, 8>, Pack<float, 16>>;
TYPED_TEST_SUITE(EllipticLanes, Packs);

TYPED_TEST(EllipticLanes, OfJacobisFunctionsEqualTheScalar) {
  EXPECT_EQ(this->differing([](auto k, auto u, auto) { return jacobi_elliptic(u, k).sn; }), 0);
  EXPECT_EQ(this->differing([](auto k, auto u, auto) { return jacobi_elliptic(u, k).cn; }), 0);
  EXPECT_EQ(this->differing([](auto k, auto u, auto) { return jacobi_elliptic(u, k).dn; }), 0);
}

TYPED_TEST(EllipticLanes, OfTheIntegralEqualTheScalar) {
  EXPECT_EQ(this->differing([](auto k, auto, auto phi) { return elliptic_f(phi, k); }), 0);
}

TYPED_TEST(EllipticLanes, OfAnAdvanceEqualTheScalar) {
  auto const advanced = [](auto k, auto u, auto phi) { return jacobi_advanced(phi, decltype(k)(u + k), phi, k); };
  EXPECT_EQ(this->differing([&](auto k, auto u, auto phi) { return advanced(k, u, phi).sn; }), 0);
  EXPECT_EQ(this->differing([&](auto k, auto u, auto phi) { return advanced(k, u, phi).dn; }), 0);
}

TYPED_TEST(EllipticLanes, OfCarlsonsIntegralAndOfKEqualTheScalar) {
  EXPECT_EQ(this->differing([](auto k, auto u, auto phi) {
    using T = decltype(k);
    return carlson_rf(T(u * u), T(k + phi * phi), T(1));
  }),
            0);
  EXPECT_EQ(this->differing([](auto k, auto, auto) {
    using T = decltype(k);
    return complete_elliptic_k(T(select(k < T(1), k, T(0))));
  }),
            0);
}

}  // namespace
}  // namespace brouwer
