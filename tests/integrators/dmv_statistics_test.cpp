// Round-off of the discrete Moser–Veselov algorithm with compensated summation is a random walk: no drift, no slopes
// of single members. Statistics, with fixed seeds.
#include <brouwer/integrators/dmv.hpp>
#include <brouwer/scalar/pack.hpp>

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Uniform;

constexpr int in_pack = 4, members = 64, samples = 20, steps_a_sample = 250;
using P = Pack<double, in_pack>;
using State = Compensated<RigidBodyState<P>>;

/// The standard test, the momentum (and the body) a little different in each member.
Setup<RigidBody<P>> next_setup(Uniform& uniform, double h, double spread_of_bodies) {
  auto const about = [&](double a, double relative) {
    return from_lanes<P>([&](int) { return a * (1 + uniform(-relative, relative)); });
  };
  Vector3<P> const inertia{about(0.6, spread_of_bodies), about(0.8, spread_of_bodies), about(1.0, spread_of_bodies)};
  return {RigidBody<P>(inertia),
          P(h),
          {{about(1.8, 0.01), about(0.4, 0.01), about(-0.9, 0.01)}, {P(1), P(0), P(0), P(0)}},
          false};
}

/// H of the state that is meant, value + residue.
Float128 energy(RigidBody<P> const& body, State const& y, int l) {
  Float128 sum = 0;
  for (int j = 0; j < 3; ++j)
    sum += squared(Float128(Float128(lane(y.value.momentum[j], l)) + Float128(lane(y.residue.momentum[j], l)))) /
           Float128(lane(body.inertia()[j], l));
  return sum / 2;
}

struct Verdict {
  double p_of_drift, p_of_slopes, beta;
};

/// t and F of the model e(t) = (β + b) t + σ W(t) (analysis/growth/inference.hpp), as chances.
Verdict judged(std::vector<std::vector<double>> const& errors) {
  double const n = members, delta = steps_a_sample, end = delta * samples;
  double beta = 0, spread = 0, diffusion = 0;
  for (auto const& e : errors) beta += e.back() / end / n;
  for (auto const& e : errors) {
    double const slope = e.back() / end;
    spread += squared(slope - beta) / (n - 1);
    for (std::size_t j = 0; j < e.size(); ++j)
      diffusion += squared(e[j] - (j > 0 ? e[j - 1] : 0) - delta * slope) / delta / (n * (samples - 1));
  }
  double const t = beta / std::sqrt(spread / n), F = end * spread / diffusion;
  return {2 * gsl_cdf_tdist_Q(std::abs(t), n - 1), gsl_cdf_fdist_Q(F, n - 1, n * (samples - 1)), beta};
}

template <class S>
Verdict verdict(double h, double spread_of_bodies) {
  Uniform uniform(11);
  std::vector<std::vector<double>> errors(members);
  for (std::size_t first = 0; first < members; first += in_pack) {
    auto const setup = next_setup(uniform, h, spread_of_bodies);
    std::vector<S> const steppers{S(setup)};
    std::vector<State> states{State(setup.start)};
    auto const start = states[0];
    for (int sample = 0; sample < samples; ++sample) {
      advance_block(std::span<S const>(steppers), std::span(states), steps_a_sample);
      for (int l = 0; l < in_pack; ++l) {
        auto const before = energy(setup.system, start, l);
        errors[first + static_cast<std::size_t>(l)].push_back(
            static_cast<double>(Float128((energy(setup.system, states[0], l) - before) / before)));
      }
    }
  }
  return judged(errors);
}

template <class S>
void expect_a_random_walk(double h, double spread_of_bodies) {
  auto const v = verdict<S>(h, spread_of_bodies);
  EXPECT_GT(v.p_of_drift, 1e-3) << "drift " << v.beta << " a step";
  EXPECT_GT(v.p_of_slopes, 1e-3);
}

TEST(DmvStatistics, EnergyDoesNotDrift) {
  expect_a_random_walk<Dmv2<P>>(0.16, 0);
  expect_a_random_walk<Dmv<P, 10, PerStep>>(0.05, 0);
  expect_a_random_walk<Dmv<P, 10, PerTrajectory>>(0.05, 0);
  expect_a_random_walk<Dmv<P, 10, PerTrajectory>>(0.16, 0);
}

TEST(DmvStatistics, NoBodyHasADriftOfItsOwn) {
  expect_a_random_walk<Dmv2<P>>(0.16, 0.1);
  expect_a_random_walk<Dmv<P, 10, PerStep>>(0.05, 0.1);
  expect_a_random_walk<Dmv<P, 10, PerTrajectory>>(0.16, 0.1);
}

}  // namespace
}  // namespace brouwer
