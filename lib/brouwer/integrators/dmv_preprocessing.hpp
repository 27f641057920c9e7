#pragma once
#include <array>
#include <cstdlib>

#include <brouwer/systems/rigid_body.hpp>

namespace brouwer {

/// The modified inertia that raises the order of the discrete Moser–Veselov algorithm, as data:
///     1/Jⱼ = σ/Iⱼ + δ    σ = 1 + Σₖ h²ᵏ s₂ₖ₊₁(C, H)    δ = Σₖ h²ᵏ d₂ₖ₊₁(C, H)
/// with s and d homogeneous of degree k in the first integrals C = ½|y|² and H = ½ Σ yⱼ²/Iⱼ. E. Hairer, G. Vilmart,
/// J. Phys. A 39 (2006) 13225. Terms up to k give order 2k + 2.
template <Real W>
struct DmvPreprocessing {
  static constexpr int most = 4;  ///< k of order 10
  /// [k−1][j]: the coefficient of C^{k−j} Hʲ
  using Terms = std::array<std::array<W, most + 1>, most>;
  Terms s{}, d{};

  explicit DmvPreprocessing(Vector3<W> const& I) {
    W const N = I[0] * I[1] * I[2];
    auto const power = [](W const& a, int n) {
      W result = W(1);
      for (int i = 0; i < std::abs(n); ++i) result = result * a;
      return n < 0 ? W(W(1) / result) : result;
    };
    // Pₙ = Σ Iⱼⁿ, X₋ₙ = Pₙ, and A(p, q) = Σ over the axes l of (Iᵢᵖ + Iⱼᵖ)/I_l^q, {i, j, l} = {1, 2, 3}
    auto const P = [&](int n) { return W(power(I[0], n) + power(I[1], n) + power(I[2], n)); };
    auto const X = [&](int n) { return P(-n); };
    auto const A = [&](int p, int q) {
      W sum = W(0);
      for (int l = 0; l < 3; ++l) sum = sum + (power(I[(l + 1) % 3], p) + power(I[(l + 2) % 3], p)) * power(I[l], -q);
      return sum;
    };
    W const N2 = N * N, N3 = N2 * N, N4 = N3 * N;

    s[0] = {P(1) / (6 * N), -X(1) / 3};
    d[0] = {W(-1) / (3 * N), P(1) / (6 * N)};

    s[1] = {(P(2) / N - X(1)) / (30 * N), (1 - A(1, 1)) / (30 * N), (3 * P(1) / N + 2 * X(2)) / 60};
    d[1] = {-P(1) / (60 * N2), X(1) / (10 * N) - P(2) / (60 * N2), -(9 + A(1, 1)) / (60 * N)};

    s[2] = {(4 * N + 17 * P(3) - 15 * N * A(1, 1)) / (2520 * N3), (9 * P(1) + 10 * N * X(2) - 6 * A(2, 1)) / (420 * N2),
            (6 * N * A(1, 2) - 100 * N * X(1) + 53 * P(2)) / (2520 * N2), (15 - N * X(3) - 2 * A(1, 1)) / (630 * N)};
    d[2] = {(34 * N * X(1) - 19 * P(2)) / (2520 * N3), (P(3) + 2 * N * A(1, 1) - 85 * N) / (1260 * N3),
            (47 * P(1) + 13 * A(2, 1) - 38 * N * X(2)) / (2520 * N2),
            (9 * N * X(1) + N * A(1, 2) - 11 * P(2)) / (1260 * N2)};

    s[3] = {(62 * P(4) - 94 * N * A(2, 1) + 66 * N2 * X(2) + 81 * N * P(1)) / (45360 * N4),
            (-77 * A(3, 1) + 75 * N * A(1, 2) + 214 * P(2) - 240 * N * X(1)) / (22680 * N3),
            (26 * N * A(2, 2) + 55 * P(3) + 204 * N - 50 * N2 * X(3) - 59 * N * A(1, 1)) / (7560 * N3),
            (137 * N * X(2) - N * A(1, 3) + 3 * P(1) - 69 * A(2, 1)) / (11340 * N2),
            (2 * N2 * X(4) + 5 * N * A(1, 2) - 171 * N * X(1) + 159 * P(2)) / (45360 * N2)};
    d[3] = {(60 * N * A(1, 1) - 61 * P(3) - 247 * N) / (45360 * N4),
            (54 * N * P(1) - P(4) + 218 * N * A(2, 1) - 426 * N2 * X(2)) / (45360 * N4),
            (125 * N * X(1) - 5 * A(3, 1) - 130 * P(2) + 4 * N * A(1, 2)) / (7560 * N3),
            (67 * P(3) - 735 * N - 15 * N * A(2, 2) + 87 * N * A(1, 1) + 34 * N2 * X(3)) / (22680 * N3),
            (165 * P(1) - N * A(1, 3) - 9 * A(2, 1) - 145 * N * X(2)) / (45360 * N2)};
  }
};

/// The three numbers η₁ = h/(2J₁) (and cyclic) from which a step of the discrete Moser–Veselov algorithm is made, and
/// what follows from them: η² for the length of the rotation, and λ₁ = η₃ − η₂. Between neighbours up to a factor two
/// apart the difference is exact (P. H. Sterbenz, Floating-Point Computation, 1974), so that Σ λⱼ = 0 and Σ ηⱼλⱼ = 0,
/// on which the conservation of C and H rests, hold for the rounded numbers.
template <Real T>
struct DmvConstants {
  Vector3<T> eta, eta_squared, lambda;

  DmvConstants() = default;
  explicit DmvConstants(Vector3<T> const& e)
      : eta(e),
        eta_squared(squared(e[0]), squared(e[1]), squared(e[2])),
        lambda(e[2] - e[1], e[0] - e[2], e[1] - e[0]) {}

  /// Σ (ηⱼmⱼ)²
  T length2(Vector3<T> const& m) const {
    return eta_squared[0] * squared(m[0]) + eta_squared[1] * squared(m[1]) + eta_squared[2] * squared(m[2]);
  }
};

/// η from the inertia and, for orders above 2, from the first integrals of the current momentum:
///     ηⱼ = (h/2)/Iⱼ + ((σ−1) (h/2)/Iⱼ + (h/2) δ),
/// so that the correction, small as h², is rounded before it is added. σ and δ by Horner's rule in H inside, in 2C
/// outside; the powers of h are in the coefficients, which are rounded once.
template <Real T, int order>
class DmvModifiedInertia {
 public:
  DmvModifiedInertia(RigidBody<T> const& body, T const& step) {
    using W = Wider<T>;
    auto const I = body.template in<W>().inertia();
    W const half_step = W(step) / W(2), h2 = squared(W(step));
    for (int j = 0; j < 3; ++j) {
      eta_[j] = rounded<T>(W(half_step / I[j]));
      half_over_inertia_[j] = rounded<T>(W(W(1) / (W(2) * I[j])));
    }
    if constexpr (degree > 0) {
      DmvPreprocessing<W> const terms(I);
      W power = W(1);
      for (int k = 1; k <= degree; ++k) {
        power = power * h2;
        for (int j = 0; j <= k; ++j) {
          W const scale = power / W(1 << (k - j));
          sigma_[at(k - j)][at(j)] = rounded<T>(W(scale * terms.s[at(k - 1)][at(j)]));
          delta_[at(k - j)][at(j)] = rounded<T>(W(scale * half_step * terms.d[at(k - 1)][at(j)]));
        }
      }
    }
  }

  Vector3<T> operator()(Vector3<T> const& y) const {
    if constexpr (degree == 0) {
      return eta_;
    } else {
      Vector3<T> const y2{squared(y[0]), squared(y[1]), squared(y[2])};
      T const twice_C = y2[0] + y2[1] + y2[2];
      T const H = half_over_inertia_[0] * y2[0] + half_over_inertia_[1] * y2[1] + half_over_inertia_[2] * y2[2];
      T const s = polynomial(sigma_, twice_C, H), d = polynomial(delta_, twice_C, H);
      return {eta_[0] + (s * eta_[0] + d), eta_[1] + (s * eta_[1] + d), eta_[2] + (s * eta_[2] + d)};
    }
  }

 private:
  static constexpr int degree = order / 2 - 1;
  static_assert(order % 2 == 0 && 0 <= degree && degree <= DmvPreprocessing<double>::most);
  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }
  using Coefficients = std::array<std::array<T, degree + 1>, degree + 1>;  ///< [i][j]: of (2C)ⁱHʲ; [0][0] is not used

  static T polynomial(Coefficients const& a, T const& twice_C, T const& H) {
    T sum = a[at(degree)][0];
    for (int i = degree - 1; i >= 0; --i) {
      T inner = a[at(i)][at(degree - i)];
      for (int j = degree - i - 1; j >= (i == 0 ? 1 : 0); --j) inner = inner * H + a[at(i)][at(j)];
      sum = sum * twice_C + (i == 0 ? T(inner * H) : inner);
    }
    return sum;
  }

  Vector3<T> eta_, half_over_inertia_;
  Coefficients sigma_{}, delta_{};
};

}  // namespace brouwer
