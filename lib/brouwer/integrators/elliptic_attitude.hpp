#pragma once
#include <brouwer/integrators/symmetric_step.hpp>

namespace brouwer {

/// The attitude over one step of an elliptic integrator, from the momentum before the step and its change d, in closed
/// form. The rotation (1, c)/√(1 + |c|²) takes y' = y + d back to y: with M = y + y'
///     c = bM + 2 d×y/|M|²
/// for some b, the only unknown. The discrete Moser–Veselov step with constants η, of which c = αη(M/2), is exact in
/// momentum and attitude where 2η/h = σ/I + δ with the right σ and δ (dmv_exact.hpp, docs/dmv-exact.md). Comparing it with
/// the addition theorem over the step gives, with g, q, E, λ of half the step (addition_step.hpp),
///     b = (h/4) (gE/q) (2H(M)/|M|² + ρ) / (1 + λ₁λ₃g²y₂y₂')
/// where ρ = δ/σ, of size h², depends on the first integrals and h alone. It is found once, at the start, from a
/// quadrature (symmetric_step.hpp).
/// That Q y is conserved does not depend on it.
///
/// A step that turns the body by more than a radian is made in pieces.
template <Real T>
class EllipticAttitude {
 public:
  EllipticAttitude(RigidBody<T> const& body, EllipticConstants<T> const& c, T const& h, Vector3<T> const& start)
      : EllipticAttitude(body, c, h, start, from_lanes<T>([&](int i) { return pieces_needed(body, h, start, i); })) {}

  /// q(t+h) − q(t) for the attitude q before the step.
  Quaternion<T> increment(Quaternion<T> const& q, Vector3<T> const& y, Vector3<T> const& dy) const {
    return hamilton_product(q, turn_less_one(step_.half(y), y, dy));
  }

  /// q(t)⁻¹ ⊗ q(t+h) − 1, with half of an addition step over the same h from y.
  Quaternion<T> turn_less_one(HalfStep<T> const& half, Vector3<T> const& y, Vector3<T> const& dy) const {
    return most_pieces_ == 1 ? turn_of_piece(half, y, dy) : turn_in_pieces(y, dy);
  }

 private:
  using E = Element<T>;

  /// A step of thousands of revolutions has no attitude: it is NaN, and the member has failed.
  static constexpr int most_pieces = 4000;

  EllipticAttitude(RigidBody<T> const& body, EllipticConstants<T> const& c, T const& h, Vector3<T> const& start,
                   T const& pieces)
      : pieces_(pieces), step_(c, Wider<T>(Wider<T>(h) / Wider<T>(pieces)), start) {
    using W = Wider<T>;
    W const time = W(h) / W(pieces);
    W const rho = from_lanes<W>([&](int i) {
      return lane(pieces, i) > E(most_pieces) ? std::numeric_limits<Element<W>>::quiet_NaN()
                                              : constant_of_lane(body, time, start, i);
    });
    for (int j = 0; j < 3; ++j)
      kappa_[static_cast<std::size_t>(j)] = rounded<T>(W(W(W(1) / W(body.inertia()[j])) + rho));
    unit_ = from_lanes<T>(
        [&](int i) { return power_of_two_near(lane(start[0], i), lane(start[1], i), lane(start[2], i)); });
    per_unit_ = step_.shortest() / (T(2) * unit_);
    for (int i = 0; i < lanes<T>; ++i)
      most_pieces_ = std::clamp(static_cast<int>(lane(pieces, i)), most_pieces_, most_pieces);
  }

  /// About 1/|y|, a power of 2: exact, and fourth powers neither overflow nor vanish.
  static E power_of_two_near(E const& y1, E const& y2, E const& y3) {
    using std::ldexp;
    double const size = std::max(
        {std::abs(static_cast<double>(y1)), std::abs(static_cast<double>(y2)), std::abs(static_cast<double>(y3))});
    return size > 0 && std::isfinite(size) ? E(ldexp(E(1), -std::ilogb(size))) : E(1);
  }

  /// |ω| ≤ |y|/I₁
  static E pieces_needed(RigidBody<T> const& body, T const& h, Vector3<T> const& y, int i) {
    auto const number = [&](T const& x) { return static_cast<double>(lane(x, i)); };
    double const length = std::hypot(number(y[0]), number(y[1]), number(y[2]));
    double const pieces = std::ceil(std::abs(1.01 * number(h) * length / number(body.inertia()[0])));
    return E(pieces >= 1 ? static_cast<int>(std::min(pieces, most_pieces + 1.0)) : 1);
  }

  static Element<Wider<T>> constant_of_lane(RigidBody<T> const& body, Wider<T> const& time, Vector3<T> const& y,
                                            int i) {
    using W = Element<Wider<T>>;
    auto const of_lane = [&](Vector3<T> const& v) {
      return Vector3<W>{W(lane(v[0], i)), W(lane(v[1], i)), W(lane(v[2], i))};
    };
    double const length = std::abs(static_cast<double>(lane(time, i))) *
                          static_cast<double>(sqrt(squared_norm(of_lane(y)))) /
                          static_cast<double>(lane(body.inertia()[0], i));
    int const nodes = GaussLegendre<E>::nodes_needed(std::clamp(length, 1e-12, 1.0), singularity_distance);
    return symmetric_step(RigidBody<W>(of_lane(body.inertia())), of_lane(y), W(lane(time, i)), nodes).rho;
  }

  /// (1, c)/√(1 + |c|²) − 1 over a common denominator N = q(1 + λ₁λ₃g²y₂y₂')|M|²
  Quaternion<T> turn_of_piece(HalfStep<T> const& half, Vector3<T> const& y, Vector3<T> const& d) const {
    using math::sqrt;
    T const y2_after = y[1] + d[1];
    Vector3<T> const M{unit_ * (y[0] + (y[0] + d[0])), unit_ * (y[1] + y2_after), unit_ * (y[2] + (y[2] + d[2]))};
    auto const& lambda = step_.lambda();
    T const q = T(1) + half.slope_less_one;
    T const below = q + q * ((lambda[0] * half.g * y[1]) * (lambda[2] * half.g * y2_after));
    T const weighted = kappa_[0] * squared(M[0]) + kappa_[1] * squared(M[1]) + kappa_[2] * squared(M[2]);
    T const along = per_unit_ * half.g * half.E() * weighted, across = (below + below) * squared(unit_);
    auto const side = cross(d, y);
    Vector3<T> const c{along * M[0] + across * side[0], along * M[1] + across * side[1],
                       along * M[2] + across * side[2]};
    T const n = squared_norm(M), N = select(n > T(0), below * n, T(1));
    T const c2 = squared_norm(c), root = sqrt(squared(N) + c2), sum = root + N;
    T const per = T(1) / (root * sum), scale = sum * per;
    return {-(c2 * per), scale * c[0], scale * c[1], scale * c[2]};
  }

  /// Rare. A lane that needs fewer pieces than another stands still at its end.
  [[gnu::noinline]] Quaternion<T> turn_in_pieces(Vector3<T> y, Vector3<T> rest) const {
    Quaternion<T> turned(T(0), T(0), T(0), T(0));
    for (int i = 0; i < most_pieces_; ++i) {
      auto const half = step_.half(y);
      auto const d = select_vector<T>(T(i + 1) < pieces_, step_.increment(half, y), rest);
      auto const turn = turn_of_piece(half, y, d), more = hamilton_product(turned, turn);
      for (int j = 0; j < 4; ++j) {
        T& sum = turned.coeffs()[j];
        T const next = i == 0 ? turn.coeffs()[j] : sum + (turn.coeffs()[j] + more.coeffs()[j]);
        sum = select(T(i) < pieces_, next, sum);
      }
      y = {y[0] + d[0], y[1] + d[1], y[2] + d[2]};
      rest = {rest[0] - d[0], rest[1] - d[1], rest[2] - d[2]};
    }
    return turned;
  }

  T pieces_;
  T unit_;      ///< about 1/|y|
  T per_unit_;  ///< h/4 of a piece over unit_, or less where g is larger
  int most_pieces_ = 1;
  std::array<T, 3> kappa_;  ///< 1/Iⱼ + ρ
  AdditionStep<T> step_;
};

}  // namespace brouwer
