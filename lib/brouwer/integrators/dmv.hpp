#pragma once
#include <algorithm>
#include <array>
#include <limits>

#include <brouwer/integrators/coefficients.hpp>
#include <brouwer/integrators/dmv_preprocessing.hpp>
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
/// How many turns settle m far below its ulp is found once, at the trajectory's start, in wider arithmetic. A step makes these,
/// all but the last without looking, which lets packs run side by side. Where the last line still moved m by more than
/// rounding does, it goes on, each lane until it stands still or no longer comes closer. Where it never settles (h is too
/// large) the increment is NaN: the member has failed.
///
/// m is rounded to its own ulp, and comes to rest on the side that it comes from: biased, and no smaller than the
/// rounding of the increment. The increment is taken at m + r instead, r = y + αλmm − m, to first order in r, which also
/// takes up what the iteration has left, but for a factor |αλm|. (Without it the energy of order 10 drifted by 8.6·10⁻¹⁹
/// a step at h = 0.16, and by a drift of its own in every body.)
/// @tparam Inertia  what forms η from y: DmvModifiedInertia in every step, or void: η is the start's
template <Real T, class Inertia>
class DmvStep {
 public:
  using Scalar = T;
  using System = RigidBody<T>;
  using State = RigidBodyState<T>;
  static constexpr bool runs_in_lanes = true;
  static constexpr int turn_limit = 50 + 8 * significand_bits<T>;  ///< linear convergence, at worst 1/8 bit a turn

  static constexpr bool per_step = !std::is_void_v<Inertia>;

  /// The equation of one step, being solved: the iterate, and the constants where they are this step's own.
  struct Nothing {};
  struct Equation {
    Vector3<T> m;
    T alpha;
    [[no_unique_address]] std::conditional_t<per_step, DmvConstants<T>, Nothing> own;
  };

  Equation begin(State const& s) const {
    if constexpr (per_step)
      return {s.momentum, T(1), DmvConstants<T>(inertia_(s.momentum))};
    else
      return {s.momentum, T(1), {}};
  }

  int blind_turns() const { return fewest_turns_ - 1; }
  void turn(State const& s, Equation& e) const { turn(s.momentum, constants_of(e), e); }

  void settle(State const& s, Equation& e, int made) const {
    auto const& k = constants_of(e);
    T change{};
    if (made + 1 == most_turns_) {
      change = turn(s.momentum, k, e);
    } else {
      for (int i = made; i < most_turns_; ++i) {
        auto const own = T(i) < turns_;
        change = select(own, turn_where(own, s.momentum, k, e), change);
      }
    }
    auto const unsettled = negated(change <= tolerance_);
    if (any(unsettled)) go_on(unsettled, change, s.momentum, k, e);
  }

  State finish(State const& s, Equation const& e) const {
    auto const& k = constants_of(e);
    auto const& m = e.m;
    T const rotation2 = k.length2(m) * squared(e.alpha);  // |c|²
    T const alpha = T(1) + rotation2;
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

  State increment(State const& s) const {
    Equation e = begin(s);
    for (int i = 0; i < blind_turns(); ++i) turn(s, e);
    settle(s, e, blind_turns());
    return finish(s, e);
  }

 protected:
  DmvStep(Setup<System> const& setup, std::conditional_t<per_step, Inertia, Nothing> const& inertia,
          Vector3<T> const& eta)
      : attitude_(setup.attitude), inertia_(inertia), constants_(eta) {
    auto needed = find_turns(setup.start.momentum);
    for (int& turns : needed) turns = std::max(turns, 1);
    turns_ = from_lanes<T>([&](int i) { return Element<T>(needed[at(i)]); });
    fewest_turns_ = *std::min_element(needed.begin(), needed.end());
    most_turns_ = *std::max_element(needed.begin(), needed.end());
  }

 private:
  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

  DmvConstants<T> const& constants_of(Equation const& e) const {
    if constexpr (per_step)
      return e.own;
    else
      return constants_;
  }

  /// One turn of whatever has m and alpha.
  /// @return by how much the last line moved m
  template <class U, class Iterate>
  static U turn(Vector3<U> const& y, DmvConstants<U> const& k, Iterate& e) {
    U const S = k.length2(e.m), once = U(1) + S * squared(e.alpha), alpha = U(1) + S * squared(once);
    U const mu1 = alpha * k.lambda[0], mu2 = alpha * k.lambda[1], mu3 = alpha * k.lambda[2];
    U const a1 = y[0] + mu1 * (e.m[1] * e.m[2]);
    U const a2 = y[1] + mu2 * (e.m[2] * a1);
    U const a3 = y[2] + mu3 * (a1 * a2);
    U const b1 = y[0] + mu1 * (a2 * a3);
    U const b2 = y[1] + mu2 * (a3 * b1);
    U const b3 = y[2] + mu3 * (b1 * b2);
    e.m[0] = b1;
    e.m[1] = b2;
    e.m[2] = b3;
    e.alpha = alpha;
    return distance(e.m, {a1, a2, a3});
  }

  template <class U>
  static U distance(Vector3<U> const& a, Vector3<U> const& b) {
    using math::abs;
    return larger(larger(U(abs(U(a[0] - b[0]))), U(abs(U(a[1] - b[1])))), U(abs(U(a[2] - b[2]))));
  }

  static T turn_where(Mask<T> const& mask, Vector3<T> const& y, DmvConstants<T> const& k, Equation& e) {
    Equation next = e;
    T const change = turn(y, k, next);
    e.m = select_vector<T>(mask, next.m, e.m);
    e.alpha = select(mask, next.alpha, e.alpha);
    return change;
  }

  /// Rare: kept out of the loop over steps. Rounding may keep m moving to and fro by a few ulp: that is settled, too.
  [[gnu::noinline]] void go_on(Mask<T> active, T change, Vector3<T> const& y, DmvConstants<T> const& k,
                               Equation& e) const {
    T const to_and_fro = T(8) * tolerance_;
    for (int i = 0; any(active) && i < turn_limit; ++i) {
      T const before = change;
      change = select(active, turn_where(active, y, k, e), change);
      active = both(active, both(change > T(0), either(change<before, change> to_and_fro)));
    }
    e.alpha = select(change <= to_and_fro, e.alpha, T(std::numeric_limits<T>::quiet_NaN()));
  }

  /// Turns from y after which the correction leaves less than 2⁻¹⁴ ulp of |y| of m, and α is settled to what that is worth
  /// (of a ball, α alone moves), lane by lane; 0 where it never is. The correction leaves as much of what m is off as a
  /// line does: the ratio of two moves. What a look accepts lies between 2 ulp, by which rounding moves m, and 16; it is
  /// negative where m never settles, so that the first look fails.
  std::array<int, lanes<T>> find_turns(Vector3<T> const& y) {
    using W = Wider<T>;
    using math::abs;
    using math::sqrt;
    Vector3<W> const wide_y{W(y[0]), W(y[1]), W(y[2])};
    struct {
      Vector3<W> m;
      W alpha;
    } iterate{wide_y, W(1)};
    DmvConstants<W> const k(Vector3<W>{W(constants_.eta[0]), W(constants_.eta[1]), W(constants_.eta[2])});
    W const length = sqrt(squared_norm(wide_y)), ulp = W(epsilon<T>()) * length;
    std::array<int, lanes<T>> turns{};
    W accepted = W(-1), last = W(0);
    auto active = W(0) < W(1);
    for (int i = 0; i < turn_limit && any(active); ++i) {
      auto const before = iterate;
      W const line = turn(wide_y, k, iterate);
      W const off =
          larger(W(length * k.length2(before.m) * abs(W(iterate.alpha - before.alpha))), distance(iterate.m, before.m));
      if (i > 0) {
        auto const settled = both(active, both(off * off <= last * ulp / W(1 << 14), last <= W(8) * ulp));
        accepted = select(settled, acceptable(ulp, off, last), accepted);
        active = both(active, negated(settled));
      }
      last = line;
      for (int l = 0; l < lanes<T>; ++l) turns[at(l)] += is_set(active, l) ? 1 : 0;
    }
    for (int l = 0; l < lanes<T>; ++l)
      if (is_set(active, l)) turns[at(l)] = 0;
    tolerance_ = rounded<T>(accepted);
    return turns;
  }

  /// The move of a line that leaves 2⁻¹² ulp after the correction, where the next turn moves m by `off` after `line`.
  template <class W>
  static W acceptable(W const& ulp, W const& off, W const& line) {
    auto const moves = off > W(0);
    W const ratio = line / select(moves, off, W(1)), most = W(16) * ulp;
    W const leaves = select(moves, ratio * ratio * ulp / W(1 << 12), most);
    return larger(W(W(2) * ulp), select(leaves < most, leaves, most));
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
  int fewest_turns_, most_turns_;  ///< over the lanes
  T turns_, tolerance_;
  [[no_unique_address]] std::conditional_t<per_step, Inertia, Nothing> inertia_;
  DmvConstants<T> constants_;
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
