#pragma once
#include <algorithm>
#include <array>

#include <brouwer/special/sn_series.hpp>
#include <brouwer/systems/elliptic_constants.hpp>

namespace brouwer {

/// How a step is made with full precision from a start: σ = A + B is a first integral, so that the start decides.
struct SeriesPlan {
  int halvings = 1, terms = 1;
};

/// @param y  momentum at the start
template <Real T>
SeriesPlan plan_series(EllipticConstants<T> const& c, Vector3<T> const& y, double h, int lane_index) {
  auto const number = [&](T const& x) { return static_cast<double>(lane(x, lane_index)); };
  double const c1 = number(c.c1), c2 = number(c.c2), tau = number(c.c3) * h;
  double const y1 = number(y[0]), y2 = number(y[1]), y3 = number(y[2]);
  double const a = c1 * c1 * (c2 * c2 * y2 * y2 + y3 * y3), b = c2 * c2 * (y1 * y1 + c1 * c1 * y2 * y2);
  double sigma = 1.01 * tau * tau * (a + b) / 4;  // 1 %: round-off over a long run stays far below
  SeriesPlan plan;
  constexpr int most_halvings = 1024;  // a step beyond 2^1024 is not finite anyway
  while (SnSeries<T>::terms_needed(sigma) > SnSeries<T>::most_terms && plan.halvings < most_halvings) {
    sigma /= 4;
    ++plan.halvings;
  }
  plan.terms = std::min(SnSeries<T>::terms_needed(sigma), SnSeries<T>::most_terms);
  return plan;
}

/// Half a step: what sn, cn, dn of it are, free of branches. sn over its frequency is τg; s² = Ag² and t² = Bg² are the
/// squares of sn and k sn.
template <Real T>
struct HalfStep {
  T g, slope_less_one;  ///< slope = cn dn
  T s2, t2, s2t2;

  /// The whole step's E, P − E and R − E (AdditionStep)
  T E() const { return T(1) - s2t2; }
  T p() const { return twice(s2t2 - s2); }
  T r() const { return twice(s2t2 - t2); }

 private:
  static T twice(T const& a) { return a + a; }
};

/// The elliptic solution over a fixed time by the addition theorem in a form with no modulus, no sign, no branch, no
/// root and no inverse function, from the three coefficients of Euler's equations times half the step (or a quarter …):
///     λ₁ = c₁²c₃h/2    λ₂ = c₃h/2    λ₃ = c₂²c₃h/2
/// Each is rounded once; the step conserves its two quadratic first integrals whatever they are, so that they cannot
/// contradict one another. Half the step:
///     A = λ₁(λ₃y₂² + λ₂y₃²)    B = λ₃(λ₂y₁² + λ₁y₂²)    g = g(A+B, AB)    q = cn dn = q(A+B, AB)    s² = Ag²    t² = Bg²
/// and doubled, where nothing cancels: with E = 1 − s²t², all over E,
///     G = 2gq    P = E + p, p = 2(s²t² − s²)    R = E + r, r = 2(s²t² − t²)
/// Where the series would be too long, the half step is made from its half in the same way, and so on.
template <Real T>
class AdditionStep {
 public:
  /// @param time         h, in the body's unit of time; exact
  AdditionStep(EllipticConstants<T> const& c, Wider<T> const& time, Vector3<T> const& start)
      : AdditionStep(c, time, plans(c, time, start)) {}

  std::array<T, 3> const& lambda() const { return lambda_; }
  /// h/2, or a quarter …: as often halved as the half step's g is doubled.
  T const& shortest() const { return shortest_; }

  HalfStep<T> half(Vector3<T> const& y) const {
    T const y2_squared = squared(y[1]);
    T const A = lambda_[0] * (lambda_[2] * y2_squared + lambda_[1] * squared(y[2]));
    T const B = lambda_[2] * (lambda_[1] * squared(y[0]) + lambda_[0] * y2_squared);
    auto const series = series_(A + B, A * B);
    auto half = half_step(series.g, series.slope_less_one, A, B);
    for (int i = 1; i < most_halvings_; ++i) {
      auto const own = T(i) < halvings_;
      auto const next = doubled(half, A, B);
      half = {select(own, next.g, half.g), select(own, next.slope_less_one, half.slope_less_one),
              select(own, next.s2, half.s2), select(own, next.t2, half.t2), select(own, next.s2t2, half.s2t2)};
    }
    return half;
  }

  /// y' = (PEy₁ − λ₁GRy₂y₃, PRy₂ + λ₂GEy₁y₃, REy₃ − λ₃GPy₁y₂)/D    with e = λ₁λ₃G²y₂², D = E² − e
  Vector3<T> next(HalfStep<T> const& half, Vector3<T> const& y) const {
    T const E = half.E(), P = E + half.p(), R = E + half.r(), g = half.g + half.g;
    auto const turn = turning(T(g + g * half.slope_less_one), y);
    T const per_D = T(1) / (E - (E * (T(1) - E) + turn.e));  // 1 − E is exact: a rounded E², like PE, would persist
    return {per_D * (E * (P * y[0]) - R * turn.y1), per_D * (R * (P * y[1]) + E * turn.y2),
            per_D * (E * (R * y[2]) - P * turn.y3)};
  }

  /// The same less y, with what is near 1 taken apart: a rounded q or R would be the same in every step, and contradict p.
  /// With u = 2g, e = λ₁λ₃u²y₂²(1 − s²)(1 − t²) and 1 + κ = qR, qE, qP
  ///     y' − y = ((pE + e)y₁ − (1 + κ₁)λ₁uy₂y₃, (pE + rE + pr + e)y₂ + (1 + κ₂)λ₂uy₁y₃, (rE + e)y₃ − (1 + κ₃)λ₃uy₁y₂)/D
  Vector3<T> increment(HalfStep<T> const& half, Vector3<T> const& y) const {
    T const E = half.E(), p = half.p(), r = half.r(), pE = p * E, rE = r * E;
    auto const times_q = [&](T const& less_one) {
      return half.slope_less_one + (less_one + half.slope_less_one * less_one);
    };
    T const kappa1 = times_q(r - half.s2t2), kappa2 = times_q(-half.s2t2), kappa3 = times_q(p - half.s2t2);
    auto const turn = turning(T(half.g + half.g), y);
    T const e = turn.e - turn.e * ((half.s2 + half.t2) - half.s2t2);
    T const per_D = T(1) / (T(1) - (e + (half.s2t2 + E * half.s2t2)));
    return {per_D * (((pE + e) * y[0] - kappa1 * turn.y1) - turn.y1),
            per_D * ((((pE + rE) + (p * r + e)) * y[1] + kappa2 * turn.y2) + turn.y2),
            per_D * (((rE + e) * y[2] - kappa3 * turn.y3) - turn.y3)};
  }

 private:
  /// λ₁uy₂y₃, λ₂uy₁y₃, λ₃uy₁y₂ and λ₁λ₃u²y₂²
  struct Turning {
    T y1, y2, y3, e;
  };
  Turning turning(T const& u, Vector3<T> const& y) const {
    T const v = u * y[1], v1 = lambda_[0] * v, v3 = lambda_[2] * v;
    return {v1 * y[2], lambda_[1] * (u * y[0]) * y[2], v3 * y[0], v1 * v3};
  }

  using Plans = std::array<SeriesPlan, static_cast<std::size_t>(lanes<T>)>;

  static Plans plans(EllipticConstants<T> const& c, Wider<T> const& time, Vector3<T> const& start) {
    Plans all;
    for (int i = 0; i < lanes<T>; ++i)
      all[static_cast<std::size_t>(i)] = plan_series(c, start, static_cast<double>(lane(time, i)), i);
    return all;
  }

  AdditionStep(EllipticConstants<T> const& c, Wider<T> const& time, Plans const& plans)
      : series_([&](int i) { return plans[static_cast<std::size_t>(i)].terms; }) {
    using W = Wider<T>;
    auto const halvings_of = [&](int i) { return plans[static_cast<std::size_t>(i)].halvings; };
    halvings_ = from_lanes<T>([&](int i) { return Element<T>(halvings_of(i)); });
    for (int i = 0; i < lanes<T>; ++i) most_halvings_ = std::max(most_halvings_, halvings_of(i));
    W const shortest = from_lanes<W>([&](int i) {
      using std::ldexp;
      return Element<W>(ldexp(Element<W>(lane(time, i)), -halvings_of(i)));
    });
    W const tau = W(c.c3) * shortest;
    shortest_ = rounded<T>(shortest);
    lambda_ = {rounded<T>(W(squared(W(c.c1)) * tau)), rounded<T>(tau), rounded<T>(W(squared(W(c.c2)) * tau))};
  }

  static HalfStep<T> half_step(T const& g, T const& slope_less_one, T const& A, T const& B) {
    T const g2 = squared(g), s2 = A * g2, t2 = B * g2;
    return {g, slope_less_one, s2, t2, s2 * t2};
  }

  static HalfStep<T> doubled(HalfStep<T> const& h, T const& A, T const& B) {
    T const E = h.E(), p = h.p() / E, r = h.r() / E;
    T const g = T(2) * h.g * (T(1) + h.slope_less_one) / E;
    return half_step(g, p + r + p * r, A, B);
  }

  std::array<T, 3> lambda_;
  T shortest_, halvings_;
  int most_halvings_ = 1;
  SnSeries<T> series_;
};

}  // namespace brouwer
