#pragma once
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <vector>

#include <brouwer/scalar/wider.hpp>

namespace brouwer {

/// Gauss–Legendre quadrature on (0, 1) with n nodes; exact for polynomials of degree 2n − 1.
/// Nodes ascend; they and the weights are computed in wider arithmetic and rounded once [DLMF 3.5(v)].
template <Real T>
class GaussLegendre {
 public:
  struct Node {
    T x, weight;
  };

  explicit GaussLegendre(int n) : nodes_(static_cast<std::size_t>(n)) {
    // not Float128: Boost 1.81's numeric_limits of it, which its root finder asks, does not compile in strict C++
    using W = std::conditional_t<(significand_bits<T> <= 64), Mpfr<128>, Wider<T>>;
    auto const zeros = boost::math::legendre_p_zeros<W>(n);  // the zeros ≥ 0, ascending
    for (std::size_t i = 0; i < zeros.size(); ++i) {
      W const slope = boost::math::legendre_p_prime(n, zeros[i]);
      W const weight = 1 / ((1 - zeros[i] * zeros[i]) * slope * slope);
      std::size_t const right = nodes_.size() - zeros.size() + i, left = nodes_.size() - 1 - right;
      nodes_[left] = {rounded<T>(W((1 - zeros[i]) / 2)), rounded<T>(weight)};
      nodes_[right] = {rounded<T>(W((1 + zeros[i]) / 2)), rounded<T>(weight)};
    }
  }

  std::vector<Node> const& nodes() const { return nodes_; }

  /// How many nodes give full precision of T over an interval of length `length` for a function whose nearest
  /// singularity is `distance` away from the real axis: the error is below ρ^{−2n}, ρ = b + √(b² + 1) with
  /// b = 2·distance/length (L. N. Trefethen, Approximation Theory and Approximation Practice, theorem 19.3).
  static int nodes_needed(double length, double distance) {
    double const b = 2 * distance / length;
    double const log_rho = std::asinh(b);
    double const nodes = 1 + std::ceil((significand_bits<T> + 2) * std::log(2.0) / (2 * log_rho));
    return nodes < 1e9 ? static_cast<int>(nodes) : 1'000'000'000;  // also where the length is not finite
  }

 private:
  std::vector<Node> nodes_;
};

}  // namespace brouwer
