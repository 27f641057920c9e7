#pragma once
#include <algorithm>
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
/// How many turns settle m and α to 1/256 ulp is found once, at the trajectory's start, in wider arithmetic. A step makes
/// these, all but the last without looking, which lets packs run side by side. Where the last one still moved them by
/// more than rounding does, it goes on, each lane until it stands still or no longer comes closer. Where it never
/// settles (h is too large) the increment is NaN: the member has failed.
///
/// m is rounded to its own ulp, and comes to rest on the side that it comes from: biased, and no smaller than the
/// rounding of the increment. The increment is taken at m + r instead, r = y + αλmm − m, to first order in r. (Without
/// it the energy of order 10 drifted by 8.6·10⁻¹⁹ a step at h = 0.16, and by a drift of its own in every body. What
/// remains in double with compensation, the standard test, 2·10⁸ steps: 5·10⁻²¹ at h = 0.16, none seen (7·10⁻²³ ± 8·10⁻²³)
/// at 0.05.)
/// @tparam Coefficients  PerStep or PerTrajectory: when η is formed
template <Real T, int order_, class Coefficients>
class Dmv {
 public:
  using Scalar = T;
  using System = RigidBody<T>;
  using State = RigidBodyState<T>;
  static constexpr int order = order_;
  static constexpr bool runs_in_lanes = true;
  static constexpr int turn_limit = 50 + 8 * significand_bits<T>;  ///< linear convergence, at worst 1/8 bit a turn

  explicit Dmv(Setup<System> const& setup)
      : attitude_(setup.attitude), inertia_(setup.system, setup.step), constants_(inertia_(setup.start.momentum)) {
    using math::sqrt;
    length_ = sqrt(squared_norm(setup.start.momentum));
    tolerance_ = T(2) * epsilon<T>() * length_;
    turns_ = turns_needed(setup.start.momentum);
    fewest_turns_ = most_turns_ = static_cast<int>(lane(turns_, 0));
    for (int i = 1; i < lanes<T>; ++i) {
      fewest_turns_ = std::min(fewest_turns_, static_cast<int>(lane(turns_, i)));
      most_turns_ = std::max(most_turns_, static_cast<int>(lane(turns_, i)));
    }
  }

  /// The equation of one step, being solved: the iterate, and the constants where they are this step's own.
  struct Equation {
    Vector3<T> m;
    T alpha;
    [[no_unique_address]] std::conditional_t<std::same_as<Coefficients, PerStep>, DmvConstants<T>, PerTrajectory> own;
  };

  Equation begin(State const& s) const {
    if constexpr (per_step)
      return {s.momentum, T(1), DmvConstants<T>(inertia_(s.momentum))};
    else
      return {s.momentum, T(1), {}};
  }

  int blind_turns() const { return fewest_turns_ - 1; }
  void turn(State const& s, Equation& e) const { turn(s.momentum, length_, constants_of(e), e); }

  void settle(State const& s, Equation& e, int made) const {
    auto const& k = constants_of(e);
    T change{};
    if (made + 1 == most_turns_) {
      change = turn(s.momentum, length_, k, e);
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

 private:
  static constexpr bool per_step = std::same_as<Coefficients, PerStep>;

  DmvConstants<T> const& constants_of(Equation const& e) const {
    if constexpr (per_step)
      return e.own;
    else
      return constants_;
  }

  /// One turn of whatever has m and alpha.
  /// @return by how much the last lines moved m, and α times |y|: of a ball, or near an axis, α alone has to settle
  template <class U, class Iterate>
  static U turn(Vector3<U> const& y, U const& length, DmvConstants<U> const& k, Iterate& e) {
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
    return moved(length, alpha, once, e.m, {a1, a2, a3});
  }

  template <class U>
  static U distance(Vector3<U> const& a, Vector3<U> const& b) {
    using math::abs;
    return larger(larger(U(abs(U(a[0] - b[0]))), U(abs(U(a[1] - b[1])))), U(abs(U(a[2] - b[2]))));
  }

  template <class U>
  static U moved(U const& length, U const& alpha, U const& alpha_before, Vector3<U> const& m,
                 Vector3<U> const& before) {
    using math::abs;
    return larger(U(length * abs(U(alpha - alpha_before))), distance(m, before));  // in this order NaN of m prevails
  }

  T turn_where(Mask<T> const& mask, Vector3<T> const& y, DmvConstants<T> const& k, Equation& e) const {
    Equation next = e;
    T const change = turn(y, length_, k, next);
    e.m = select_vector<T>(mask, next.m, e.m);
    e.alpha = select(mask, next.alpha, e.alpha);
    return change;
  }

  /// Rare: kept out of the loop over steps. Rounding may keep m moving to and fro by a few ulp: that is settled, too.
  [[gnu::noinline]] void go_on(Mask<T> active, T change, Vector3<T> const& y, DmvConstants<T> const& k,
                               Equation& e) const {
    T const to_and_fro = T(4) * tolerance_;
    for (int i = 0; any(active) && i < turn_limit; ++i) {
      T const before = change;
      change = select(active, turn_where(active, y, k, e), change);
      active = both(active, both(change > T(0), either(change<before, change> to_and_fro)));
    }
    e.alpha = select(change <= to_and_fro, e.alpha, T(std::numeric_limits<T>::quiet_NaN()));
  }

  /// Turns from y until the next one would move m by less than 1/256 ulp of |y|, lane by lane; at least one. One where
  /// it never settles: such a member is to fail soon.
  T turns_needed(Vector3<T> const& y) const {
    using W = Wider<T>;
    using math::sqrt;
    auto const wide = [](Vector3<T> const& v) { return Vector3<W>{W(v[0]), W(v[1]), W(v[2])}; };
    struct {
      Vector3<W> m;
      W alpha;
    } iterate{wide(y), W(1)};
    DmvConstants<W> const k(wide(constants_.eta));
    W const length = sqrt(squared_norm(iterate.m)), goal = W(epsilon<T>()) / W(256) * length;
    T needed = T(1);
    auto active = W(0) < W(1);
    for (int i = 0; i < turn_limit && any(active); ++i) {
      auto const before = iterate;
      turn(wide(y), length, k, iterate);
      active = both(active, moved(length, iterate.alpha, before.alpha, iterate.m, before.m) > goal);
      if (i > 0) needed = from_lanes<T>([&](int l) { return lane(needed, l) + Element<T>(is_set(active, l) ? 1 : 0); });
    }
    return from_lanes<T>([&](int l) { return is_set(active, l) ? Element<T>(1) : lane(needed, l); });
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
  T turns_, length_, tolerance_;
  DmvModifiedInertia<T, order> inertia_;
  DmvConstants<T> constants_;
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
