#pragma once
#include <brouwer/special/sn_series.hpp>
#include <brouwer/systems/elliptic_constants.hpp>

namespace brouwer {

/// The factors of the addition theorem for one step from y: what sn, cn, dn of the step are, free of branches.
template <Real T>
struct AdditionFactors {
  T w;            ///< τ g: sn of the step over its frequency
  T P, R;         ///< its cn and dn (or dn and cn, in the other branch)
  T p1, r1;       ///< P − 1 and R − 1 without cancellation
  T e;            ///< c₁² c₂² w² y₂²
  T denominator;  ///< D = 1 − e
};

/// The elliptic solution over a fixed time by the addition theorem in a form with no modulus, no sign, no branch
/// and no inverse function. With τ = c₃h:
///     A = c₁²τ²(c₂²y₂² + y₃²)    B = c₂²τ²(y₁² + c₁²y₂²)    g = g(A+B, AB)    w = τg
///     P = √(1 − Ag²)    R = √(1 − Bg²)    D = 1 − c₁²c₂²w²y₂²
/// Where the series of g would be too long the step is halved and put together again by doubling, in which nothing
/// cancels: with s² = Ag², t² = Bg², E = 1 − s²t²
///     w(2τ) = 2wPR/E    P(2τ) − 1 = −2s²R²/E    R(2τ) − 1 = −2t²P²/E.
template <Real T>
class AdditionStep {
 public:
  /// @param time         h, in the body's unit of time; exact
  /// @param halvings     how often it is halved
  /// @param series       long enough for the halved step
  AdditionStep(EllipticConstants<T> const& c, Wider<T> const& time, int halvings, SnSeries<T> const& series)
      : halvings_(halvings), series_(series) {
    using W = Wider<T>;
    using std::ldexp;
    tau_ = rounded<T>(W(ldexp(W(W(c.c3) * time), -halvings)));
    c1_squared_ = rounded<T>(W(squared(W(c.c1))));
    c2_squared_ = rounded<T>(W(squared(W(c.c2))));
  }

  T const& c1_squared() const { return c1_squared_; }
  T const& c2_squared() const { return c2_squared_; }

  AdditionFactors<T> operator()(Vector3<T> const& y) const {
    using math::sqrt;
    T const y2_squared = squared(y[1]);
    T const a = c1_squared_ * (c2_squared_ * y2_squared + squared(y[2]));
    T const b = c2_squared_ * (squared(y[0]) + c1_squared_ * y2_squared);
    T const tau_squared = squared(tau_);
    T const A = a * tau_squared, B = b * tau_squared;

    AdditionFactors<T> f{};
    f.w = tau_ * series_(A + B, A * B);
    T s2 = a * squared(f.w), t2 = b * squared(f.w);
    f.P = sqrt(T(1) - s2);
    f.R = sqrt(T(1) - t2);
    f.p1 = -s2 / (T(1) + f.P);
    f.r1 = -t2 / (T(1) + f.R);
    for (int i = 0; i < halvings_; ++i) double_step(f, s2, t2, a, b);
    f.e = c1_squared_ * c2_squared_ * squared(f.w) * y2_squared;
    f.denominator = T(1) - f.e;
    return f;
  }

 private:
  static void double_step(AdditionFactors<T>& f, T& s2, T& t2, T const& a, T const& b) {
    T const E = T(1) - s2 * t2, P2 = squared(f.P), R2 = squared(f.R);
    f.w = T(2) * f.w * f.P * f.R / E;
    f.p1 = -(T(2) * s2 * R2 / E);
    f.r1 = -(T(2) * t2 * P2 / E);
    f.P = T(1) + f.p1;
    f.R = T(1) + f.r1;
    s2 = a * squared(f.w);
    t2 = b * squared(f.w);
  }

  T tau_, c1_squared_, c2_squared_;
  int halvings_;
  SnSeries<T> series_;
};

/// How long the series of g must be, and how often a step is halved, for full precision from a start: σ = A + B is a
/// first integral, so that the start decides.
struct SeriesPlan {
  int halvings = 0, terms = 1;
};

template <Real T>
SeriesPlan plan_series(EllipticConstants<T> const& c, Vector3<T> const& y, T const& h) {
  double const c1 = static_cast<double>(c.c1), c2 = static_cast<double>(c.c2);
  double const tau = static_cast<double>(c.c3) * static_cast<double>(h);
  double const y1 = static_cast<double>(y[0]), y2 = static_cast<double>(y[1]), y3 = static_cast<double>(y[2]);
  double const a = c1 * c1 * (c2 * c2 * y2 * y2 + y3 * y3), b = c2 * c2 * (y1 * y1 + c1 * c1 * y2 * y2);
  double sigma = 1.01 * tau * tau * (a + b);  // 1 %: round-off over a long run stays far below
  SeriesPlan plan;
  constexpr int most_halvings = 1024;  // a step beyond 2^1024 is not finite anyway
  while (SnSeries<T>::terms_needed(sigma) > SnSeries<T>::most_terms && plan.halvings < most_halvings) {
    sigma /= 4;
    ++plan.halvings;
  }
  plan.terms = std::min(SnSeries<T>::terms_needed(sigma), SnSeries<T>::most_terms);
  return plan;
}

}  // namespace brouwer
