#pragma once
#include <brouwer/integrators/coefficients.hpp>
#include <brouwer/integrators/dmv_iteration.hpp>
#include <brouwer/integrators/stepper.hpp>

namespace brouwer {

/// The discrete Moser–Veselov algorithm and its preprocessed forms of order 4, 6, 8, 10: symmetric, symplectic; conserves
/// H, C and Qy exactly in exact arithmetic. J. Moser, A. P. Veselov, Comm. Math. Phys. 139 (1991) 217; in quaternions and
/// preprocessed E. Hairer, G. Vilmart, J. Phys. A 39 (2006) 13225.
///
/// There the step's rotation (1, c₁, c₂, c₃)/√α solves c₁ = αη₁y₁ + (J₂−J₃)/J₁ c₂c₃ with α = 1 + |c|² and η₁ = h/(2J₁).
/// For the midpoint m = (y + y')/2, of which c is αηm, the same equation needs no constant but η, and no quotient:
///     m₁ = y₁ + αλ₁m₂m₃    α = 1 + α² Σ (ηⱼmⱼ)²    y₁' = y₁ + 2αλ₁m₂m₃    λ₁ = η₃ − η₂    (and cyclic)
///     q' = q ⊗ (1, αηm)/√α
/// It is solved by fixed-point iteration from m = y, α = 1. A turn is twice the line for α and then twice those for m,
/// in Gauss–Seidel order: m comes closer by |αλm|² in a turn, α by (2α Σ (ηm)²)².
///
/// m is rounded to its own ulp, and comes to rest on the side that it comes from: biased, and no smaller than the
/// rounding of the increment. The increment is taken at m + r instead, r = y + αλmm − m, to first order in r, which also
/// takes up what the iteration has left, but for a factor |αλm|. (Without it the energy of order 10 drifted by 8.6·10⁻¹⁹
/// a step at h = 0.16, and by a drift of its own in every body. What is left with compensation, standard test, 1024 members
/// × 10⁵ steps: 5·10⁻²¹ at h = 0.16 (t = 12); at h = 0.1 1.2·10⁻²¹ for order 2 (t = 5) and none seen for order 10,
/// (3 ± 5)·10⁻²²; at 0.05 and 0.01 none, below 6·10⁻²² and 10⁻²².)
///
/// In double-double the iteration begins where that of the high parts, in double, comes to rest: half the turns are cheap.
/// @tparam Inertia  what forms η from y: DmvModifiedInertia in every step, or void: η is the start's
template <Real T, class Inertia>
class DmvStep {
 public:
  using Scalar = T;
  using System = RigidBody<T>;
  using State = RigidBodyState<T>;
  static constexpr bool runs_in_lanes = true;

  static constexpr bool per_step = !std::is_void_v<Inertia>;
  struct Nothing {};

  /// The equation of one step, being solved: the iterate, and the constants where they are this step's own.
  struct Equation : DmvIterate<T> {
    [[no_unique_address]] std::conditional_t<per_step, DmvConstants<T>, Nothing> own;
  };

  Equation begin(State const& s) const {
    auto const& y = s.momentum;
    Equation e{};
    if constexpr (per_step) e.own = DmvConstants<T>(inertia_(y));
    static_cast<DmvIterate<T>&>(e) = first_iterate(y, constants_of(e), high_turns_);
    return e;
  }

  int blind_turns() const { return turns_.blind(); }
  void turn(State const& s, Equation& e) const { dmv_turn<T>(s.momentum, constants_of(e), e); }
  void settle(State const& s, Equation& e, int made) const { turns_.settle(s.momentum, constants_of(e), e, made); }

  State finish(State const& s, Equation const& e) const {
    auto const& k = constants_of(e);
    auto const& m = e.m;
    T const rotation2 = k.length2(m) * squared(e.alpha);  // |c|²
    T const alpha = 1 + rotation2;
    auto const& y = s.momentum;
    T const mu1 = alpha * k.lambda[0], mu2 = alpha * k.lambda[1], mu3 = alpha * k.lambda[2];
    T const d1 = mu1 * (m[1] * m[2]), d2 = mu2 * (m[2] * m[0]), d3 = mu3 * (m[0] * m[1]);
    T const r1 = (y[0] - m[0]) + d1, r2 = (y[1] - m[1]) + d2, r3 = (y[2] - m[2]) + d3;
    T const e1 = d1 + mu1 * (m[1] * r3 + r2 * m[2]), e2 = d2 + mu2 * (m[2] * r1 + r3 * m[0]),
            e3 = d3 + mu3 * (m[0] * r2 + r1 * m[1]);
    Vector3<T> const dy{e1 + e1, e2 + e2, e3 + e3};
    if (!attitude_) return {dy, {T(0), T(0), T(0), T(0)}};
    return {dy, attitude_increment(s.attitude, {k.eta[0] * m[0], k.eta[1] * m[1], k.eta[2] * m[2]}, alpha, rotation2)};
  }

  /// η is no number where the modified inertia does not exist; otherwise it is the iteration that has not settled.
  Failure failure(State const& s, int l) const {
    auto const eta = lane(constants_of(begin(s)).eta[0], l);
    return eta - eta == Element<T>(0) ? Failure::no_convergence : Failure::step_too_large;
  }

  State increment(State const& s) const {
    Equation e = begin(s);
    for (int i = 0; i < blind_turns(); ++i) turn(s, e);
    settle(s, e, blind_turns());
    return finish(s, e);
  }

 protected:
  DmvStep(Setup<System> const& setup, std::conditional_t<per_step, Inertia, Nothing> const& inertia,
          Vector3<T> const& eta)
      : attitude_(setup.whole_state),
        inertia_(inertia),
        constants_(eta),
        high_turns_(turns_of_high_parts(setup.start.momentum, eta)),
        turns_(setup.start.momentum, eta, first_iterate(setup.start.momentum, constants_, high_turns_)) {}

 private:
  static constexpr bool has_high_part = !std::is_void_v<typename HighPart<T>::type>;
  using High = std::conditional_t<has_high_part, typename HighPart<T>::type, T>;
  using HighTurns = std::conditional_t<has_high_part, DmvTurns<High>, Nothing>;

  static Vector3<High> high(Vector3<T> const& v) requires has_high_part {
    return {v[0].high(), v[1].high(), v[2].high()};
  }

  static HighTurns turns_of_high_parts(Vector3<T> const& y, Vector3<T> const& eta) {
    if constexpr (has_high_part)
      return {high(y), high(eta), {high(y), High(1)}};
    else
      return {};
  }

  /// m = y, α = 1, or where these lead in the high parts.
  static DmvIterate<T> first_iterate(Vector3<T> const& y, DmvConstants<T> const& k, HighTurns const& turns) {
    if constexpr (has_high_part) {
      DmvIterate<High> e{high(y), High(1)};
      turns.solve(high(y), DmvConstants<High>(high(k.eta)), e);
      return {{T(e.m[0]), T(e.m[1]), T(e.m[2])}, T(e.alpha)};
    } else {
      return {y, T(1)};
    }
  }

  DmvConstants<T> const& constants_of(Equation const& e) const {
    if constexpr (per_step)
      return e.own;
    else
      return constants_;
  }

  /// q ⊗ (1, c)/√α − q with c = αηm: (1, c)/√α − 1 = (−|c|²/(√α + α), √α ηm)
  static Quaternion<T> attitude_increment(Quaternion<T> const& q, Vector3<T> const& eta_m, T const& alpha,
                                          T const& rotation2) {
    using math::sqrt;
    T const root = sqrt(alpha);
    return hamilton_product(
        q, Quaternion<T>(-(rotation2 / (root + alpha)), root * eta_m[0], root * eta_m[1], root * eta_m[2]));
  }

  bool attitude_;
  [[no_unique_address]] std::conditional_t<per_step, Inertia, Nothing> inertia_;
  DmvConstants<T> constants_;
  [[no_unique_address]] HighTurns high_turns_;
  DmvTurns<T> turns_;
};

/// The algorithm of an order, with η formed in every step (PerStep), or once (PerTrajectory): then all orders make the
/// same step, and are one Core.
template <Real T, int order_, class Coefficients>
class Dmv : public DmvStep<T, DmvModifiedInertia<T, order_>> {
 public:
  using Core = DmvStep<T, DmvModifiedInertia<T, order_>>;
  static constexpr int order = order_;
  explicit Dmv(Setup<RigidBody<T>> const& setup)
      : Dmv(setup, DmvModifiedInertia<T, order_>(setup.system, setup.step)) {}

 private:
  Dmv(Setup<RigidBody<T>> const& setup, DmvModifiedInertia<T, order_> const& inertia)
      : Core(setup, inertia, inertia(setup.start.momentum)) {}
};

template <Real T, int order_>
class Dmv<T, order_, PerTrajectory> : public DmvStep<T, void> {
 public:
  using Core = DmvStep<T, void>;
  static constexpr int order = order_;
  explicit Dmv(Setup<RigidBody<T>> const& setup)
      : Core(setup, {}, DmvModifiedInertia<T, order_>(setup.system, setup.step)(setup.start.momentum)) {}
};

template <Real T>
using Dmv2 = Dmv<T, 2, PerTrajectory>;
template <Real T, class Coefficients>
using Dmv4 = Dmv<T, 4, Coefficients>;
template <Real T, class Coefficients>
using Dmv6 = Dmv<T, 6, Coefficients>;
template <Real T, class Coefficients>
using Dmv8 = Dmv<T, 8, Coefficients>;
template <Real T, class Coefficients>
using Dmv10 = Dmv<T, 10, Coefficients>;

}  // namespace brouwer
