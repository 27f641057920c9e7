#pragma once
#include <array>

#include <brouwer/special/trigonometric.hpp>
#include <brouwer/systems/exact_flow.hpp>
#include <brouwer/systems/kepler.hpp>

namespace brouwer {

/// G₁, G₂, G₃ of Kepler's problem in universal variables, Gₙ(s) = sⁿ cₙ(βs²) with Stumpff's functions
///     cₙ(x) = 1/n! − x/(n+2)! + x²/(n+4)! − …
/// so that G₁ = sin(√β s)/√β for β > 0, s for β = 0, sinh(√−β s)/√−β for β < 0: one formula for every kind of orbit.
/// K. Stumpff, Himmelsmechanik I (1959), section 41.
template <Real T>
struct StumpffFunctions {
  T g1, g2, g3;

  /// The series of c₂, c₃ for |x| ≤ 1/16, and from there by c₁ = 1 − x c₃, c₀ = 1 − x c₂ and
  /// c₂(4x) = ½ c₁², c₃(4x) = ¼ (c₂ + c₀c₃): no difference of large numbers, whatever the sign of x.
  StumpffFunctions(T const& beta, T const& s) {
    using math::abs;
    T const s2 = s * s, argument = beta * s2;
    T x = argument;
    int quarterings = 0;
    for (; abs(x) > T(1) / T(16); ++quarterings) x = x / T(4);
    T c2 = series(x, 2), c3 = series(x, 3);
    for (; quarterings > 0; --quarterings) {
      T const c1 = T(1) - x * c3;
      c3 = (c2 + (T(1) - x * c2) * c3) / T(4);
      c2 = c1 * c1 / T(2);
      x = T(4) * x;
    }
    g1 = s * (T(1) - argument * c3);
    g2 = s2 * c2;
    g3 = s * s2 * c3;
  }

 private:
  /// cₙ(x), to the last term that changes it.
  static T series(T const& x, int n) {
    T term = T(1);
    for (int k = 2; k <= n; ++k) term = term / T(k);
    using math::abs;
    T sum = term;
    for (int k = n; abs(term) > epsilon<T>() * sum / T(16); k += 2) {
      term = -(term * x / T((k + 1) * (k + 2)));
      sum = sum + term;
    }
    return sum;
  }
};

/// The exact flow of Kepler's problem from one start: the reference against which the error of a state is measured, and an
/// oracle of the tests. With r₀ = |q|, η = ⟨q, p⟩, β = 2/r₀ − |p|², ζ = 1 − βr₀ the time is t = r₀G₁ + ηG₂ + G₃, Kepler's
/// equation for s, and
///     q(t) = f q + g p    p(t) = ḟ q + ġ p    f = 1 − G₂/r₀    g = t − G₃    ḟ = −G₁/(r₀r)    ġ = 1 − G₂/r
/// with r = r₀ + ηG₁ + ζG₂ = dt/ds. Circles, ellipses, parabolas, hyperbolas, also through a collision (e = 1, L = 0, where a
/// body comes back the way it went). J. M. A. Danby, Fundamentals of Celestial Mechanics (1988), section 6.9.
///
/// Ellipses are reduced to half a period. Error: with semi-major axis 1 and e = 0.6 about 30 ε of T within a period and 2εt
/// over 10⁴ periods; more where a body is fast, 10⁷ ε near the pericentre of e = 1 − 10⁻⁶; measured in Float128, not proved.
/// Take a T wider than what is judged.
template <Real T>
class KeplerFlow {
 public:
  KeplerFlow(Kepler<T> const& system, PhaseState<T, 2> const& start)
      : start_(start),
        r0_(system.distance(start)),
        eta_(inner_product(start.q, start.p)),
        beta_(T(2) / r0_ - inner_product(start.p, start.p)),
        zeta_(T(1) - beta_ * r0_) {}

  PhaseState<T, 2> operator()(T const& t) const {
    T const rest = reduced(t);
    StumpffFunctions<T> const g(beta_, universal_anomaly(rest));
    T const r = r0_ + eta_ * g.g1 + zeta_ * g.g2;
    return combination(-(g.g2 / r0_), rest - g.g3, -(g.g1 / (r0_ * r)), -(g.g2 / r));
  }

 private:
  /// (1 + f) q + g p, ḟ q + (1 + ġ) p
  PhaseState<T, 2> combination(T const& f, T const& g, T const& f_rate, T const& g_rate) const {
    auto const& [q, p] = start_;
    return {{q[0] + (f * q[0] + g * p[0]), q[1] + (f * q[1] + g * p[1])},
            {p[0] + (f_rate * q[0] + g_rate * p[0]), p[1] + (f_rate * q[1] + g_rate * p[1])}};
  }

  /// t less whole periods 2π β^{−3/2}, at most half a period away from 0.
  T reduced(T const& t) const {
    using math::sqrt;
    if (!(beta_ > T(0))) return t;
    T const period = T(2) * pi<T>() / (beta_ * sqrt(beta_));
    return t - period * floor(T(t / period + T(1) / T(2)));
  }

  /// s with t(s) = t. t grows with s because r > 0: Newton's method inside a bracket that closes in. Backwards in time
  /// η has the other sign.
  T universal_anomaly(T const& t) const {
    T const side = sign_of(t), eta = side * eta_, duration = side * t;
    if (!(duration > T(0))) return t;
    auto bracket = bracket_of(duration, eta);
    T s = bracket[1];
    for (int turn = 0; turn < most_turns; ++turn) {
      auto const [excess, r] = at(s, duration, eta);
      bracket[excess > T(0) ? 1 : 0] = s;
      T const newton = s - excess / r;
      bool const inside = newton > bracket[0] && newton < bracket[1];
      T const next = inside ? newton : T((bracket[0] + bracket[1]) / T(2));
      bool const settled = abs(T(next - s)) <= T(2) * epsilon<T>() * next;
      s = next;
      if (settled) break;
    }
    return side * s;
  }

  /// s < … < 2s between which the root lies. Doubling from below: no e^{√−β s} of a hyperbola overflows.
  std::array<T, 2> bracket_of(T const& duration, T const& eta) const {
    using math::sqrt;
    T const size = abs(beta_), turn = T(1) / sqrt(or_one(size));
    std::array<T, 2> bracket{T(0), smaller(turn, T(duration / r0_))};
    while (at(bracket[1], duration, eta).excess <= T(0)) bracket = {bracket[1], T(2) * bracket[1]};
    return bracket;
  }

  struct Equation {
    T excess, r;  ///< t(s) − t and dt/ds
  };
  Equation at(T const& s, T const& duration, T const& eta) const {
    StumpffFunctions<T> const g(beta_, s);
    return {((r0_ * g.g1 - duration) + eta * g.g2) + g.g3, r0_ + eta * g.g1 + zeta_ * g.g2};
  }

  static constexpr int most_turns = 2000;  ///< more than bisection needs in the widest arithmetic

  PhaseState<T, 2> start_;
  T r0_, eta_, beta_, zeta_;
};

template <Real T>
struct ExactFlow<Kepler<T>> {
  using type = KeplerFlow<T>;
};

}  // namespace brouwer
