#pragma once
#include <Eigen/Core>
#include <limits>
#include <utility>

#include <brouwer/scalar/real.hpp>

namespace brouwer {

// Loops of our own over small square matrices: Eigen's change their order of operations with the instruction set.

/// Σ aᵢⱼ², column by column.
template <class T, int n>
T squared_frobenius_norm(Eigen::Matrix<T, n, n> const& A) {
  T sum = T(0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) sum = sum + squared(T(A(i, j)));
  return sum;
}

/// A⁻¹ by the elimination of Gauss and Jordan, rows exchanged for the largest pivot; no numbers for a singular A. Single
/// numbers, no packs.
template <class T, int n>
Eigen::Matrix<T, n, n> inverse_by_elimination(Eigen::Matrix<T, n, n> A) {
  using math::abs;
  Eigen::Matrix<T, n, n> B = Eigen::Matrix<T, n, n>::Identity();
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i) pivot = abs(T(A(i, k))) > abs(T(A(pivot, k))) ? i : pivot;
    for (int j = 0; j < n; ++j) {
      std::swap(A(k, j), A(pivot, j));
      std::swap(B(k, j), B(pivot, j));
    }
    T const p = A(k, k);
    for (int j = 0; j < n; ++j) {
      A(k, j) = A(k, j) / p;
      B(k, j) = B(k, j) / p;
    }
    for (int i = 0; i < n; ++i) {
      T const factor = i == k ? T(0) : T(A(i, k));
      for (int j = 0; j < n; ++j) {
        A(i, j) = A(i, j) - factor * A(k, j);
        B(i, j) = B(i, j) - factor * B(k, j);
      }
    }
  }
  return B;
}

/// The projection on the invariant subspace of the eigenvalues with Re λ > 0, along that of the others: (1 + sign A)/2. Its
/// trace is the number of these. Single numbers, no packs.
/// Method:   Newton's iteration Z ← (cZ + Z⁻¹/c)/2 for sign A, c² = |Z⁻¹|/|Z|: J. D. Roberts, Int. J. Control 32 (1980)
///           677; R. Byers, Linear Algebra Appl. 85 (1987) 267.
/// @return   no numbers where an eigenvalue lies on the imaginary axis, or the iteration does not come to rest
template <class T, int n>
Eigen::Matrix<T, n, n> projection_on_positive_eigenvalues(Eigen::Matrix<T, n, n> Z) {
  using math::sqrt;
  using Matrix = Eigen::Matrix<T, n, n>;
  constexpr int limit = 64;
  bool close = false;
  for (int i = 0; i < limit; ++i) {
    Matrix const inverse = inverse_by_elimination(Z);
    T const size2 = squared_frobenius_norm(Z), ratio2 = squared_frobenius_norm(inverse) / size2;
    if (!(ratio2 < std::numeric_limits<T>::infinity())) break;
    T const c = close ? T(1) : T(sqrt(T(sqrt(ratio2))));
    Matrix const next = (c * Z + inverse / c) / T(2);
    T const change2 = squared_frobenius_norm(Matrix(next - Z));
    Z = next;
    if (close) return (Matrix::Identity() + Z) / T(2);
    close = change2 <= epsilon<T>() * size2;  // half the digits: the next iterate has all
  }
  return Matrix::Constant(std::numeric_limits<T>::quiet_NaN());
}

}  // namespace brouwer
