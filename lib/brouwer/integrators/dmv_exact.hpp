#pragma once
#include <algorithm>
#include <array>
#include <limits>

#include <brouwer/integrators/dmv.hpp>
#include <brouwer/integrators/symmetric_step.hpp>

namespace brouwer {

/// σ and δ for which the discrete Moser–Veselov step with 1/Jⱼ = σ/Iⱼ + δ is the exact flow over h; NaN where there are
/// none.
template <Real W>
struct DmvExactParameters {
  W sigma, delta;

  bool exist() const { return sigma > W(0); }
};

/// σ and δ of one trajectory: functions of C, H, I and h alone, to which the series of DmvPreprocessing converges.
///
/// The step conserves C, H and Qy whatever σ and δ are, so that it differs from the flow by a shift along the trajectory
/// and a turn about Qy, the same at every point of it (docs/dmv-exact.md): if it is the flow at one point it is so
/// everywhere. At the point of SymmetricStep both sides are known: αη = S(1/I + ρ) there, hence
///     δ = ρσ    σ = S/(hα/2)    α = 1 + |c|²
/// @param body   single numbers, no packs; inertia sorted
/// @param y      momentum anywhere on the trajectory
/// @param h      step; of either sign; 0 gives the limit σ = 1, δ = 0
/// @return       NaN where the step turns the body by a right angle or more, which the iteration of DmvTurns (α < 2) does
///               not find. α is largest at the point that is looked at. On a principal axis, in a ball and for
///               I₁ = I₂ or I₂ = I₃ the limit of general motions, where σ and δ of the step are not the only ones.
/// Error:        σ below 3 ε, δ below 3 ε σ/I₁ beside which it stands, over the random bodies of
///               tests/integrators/dmv_exact_test.cpp with σ > 0.3; measured in double and Float128, not proved.
template <Real W>
DmvExactParameters<W> dmv_exact_parameters(RigidBody<W> const& body, Vector3<W> const& y, W const& h) {
  using math::abs;
  if (h == W(0) && squared_norm(y) < std::numeric_limits<W>::infinity()) return {W(1), W(0)};
  W const nan = std::numeric_limits<W>::quiet_NaN(), whole_turn = W(2) * pi<W>();
  EllipticConstants<W> const c(body);
  W const argument = abs(W(EllipticBranch<W>(c, y).rate(c.c3) * h));
  if (!(argument <= whole_turn)) return {nan, nan};

  double const half_argument = std::max(static_cast<double>(argument) / 2, 1e-12);
  auto const step = symmetric_step(body, y, h, GaussLegendre<W>::nodes_needed(half_argument, singularity_distance));
  W const alpha = W(1) + step.half_tangent2(body.inertia()), sigma = W(2) * step.stride / (h * alpha);
  bool const exist = sigma > W(0) && step.half_cosine > W(0) && abs(step.psi) < whole_turn && alpha < W(2);
  return exist ? DmvExactParameters<W>{sigma, step.rho * sigma} : DmvExactParameters<W>{nan, nan};
}

/// Whether DmvExact has a step of this size.
template <Real W>
bool dmv_exact_exists(RigidBody<W> const& body, Vector3<W> const& y, W const& h) {
  return dmv_exact_parameters(body, y, h).exist();
}

/// The discrete Moser–Veselov algorithm preprocessed to order infinity: exact in momentum and attitude, and each step the
/// one of order 2 (dmv.hpp), with η from the start. Where σ and δ do not exist, η is NaN and the member fails.
template <Real T>
class DmvExact : public DmvStep<T, void> {
 public:
  using Core = DmvStep<T, void>;
  static constexpr int order = 0;
  explicit DmvExact(Setup<RigidBody<T>> const& setup) : Core(setup, {}, exact_eta(setup)) {}

 private:
  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

  /// ηⱼ = (h/2)(σ/Iⱼ + δ), in wider arithmetic, lane by lane, rounded once.
  static Vector3<T> exact_eta(Setup<RigidBody<T>> const& setup) {
    std::array<Vector3<Element<Wider<T>>>, at(lanes<T>)> of_lanes;
    for (int i = 0; i < lanes<T>; ++i) of_lanes[at(i)] = eta_of_lane(setup, i);
    Vector3<T> eta;
    for (int j = 0; j < 3; ++j) eta[j] = from_lanes<T>([&](int i) { return rounded<Element<T>>(of_lanes[at(i)][j]); });
    return eta;
  }

  static Vector3<Element<Wider<T>>> eta_of_lane(Setup<RigidBody<T>> const& setup, int i) {
    using W = Element<Wider<T>>;
    auto const wide = [&](Vector3<T> const& v) {
      return Vector3<W>{W(lane(v[0], i)), W(lane(v[1], i)), W(lane(v[2], i))};
    };
    Vector3<W> const I = wide(setup.system.inertia());
    W const h = W(lane(setup.step, i)), half = h / W(2);
    auto const p = dmv_exact_parameters(RigidBody<W>(I), wide(setup.start.momentum), h);
    return {half * (p.sigma / I[0] + p.delta), half * (p.sigma / I[1] + p.delta), half * (p.sigma / I[2] + p.delta)};
  }
};

}  // namespace brouwer
