// The matrix sign function's projection, and the inverse that it is made of.
#include <brouwer/special/matrix_sign.hpp>

#include <gtest/gtest.h>

#include "tests/numbers.hpp"

namespace brouwer {
namespace {

using testing_support::Judge;
using testing_support::Uniform;

template <class T>
using Matrix = Eigen::Matrix<T, 6, 6>;

template <class T>
Matrix<T> random_matrix(Uniform& uniform) {
  Matrix<T> A;
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i) A(i, j) = static_cast<T>(uniform(-1, 1));
  return A;
}

/// V diag(λ) V⁻¹
Matrix<Judge> with_eigenvalues(std::array<Judge, 6> const& lambda, Matrix<Judge> const& V) {
  Matrix<Judge> D = Matrix<Judge>::Zero();
  for (int i = 0; i < 6; ++i) D(i, i) = lambda[static_cast<std::size_t>(i)];
  return V * D * inverse_by_elimination(V);
}

template <class T>
double norm(Matrix<T> const& A) {
  return std::sqrt(static_cast<double>(squared_frobenius_norm(A)));
}

TEST(InverseByElimination, TimesTheMatrixIsOne) {
  Uniform uniform(1);
  for (int i = 0; i < 20; ++i) {
    auto const A = random_matrix<Judge>(uniform);
    auto const B = inverse_by_elimination(A);
    EXPECT_LT(norm<Judge>(A * B - Matrix<Judge>::Identity()), 1e-74 * norm(A) * norm(B)) << i;
  }
  Matrix<double> exchange = Matrix<double>::Zero();  // every pivot is 0 where it stands
  for (int i = 0; i < 6; ++i) exchange(i, (i + 1) % 6) = 2;
  EXPECT_EQ(inverse_by_elimination(exchange), exchange.transpose() / 4);
  EXPECT_FALSE(inverse_by_elimination(Matrix<double>(Matrix<double>::Ones())).allFinite());
}

TEST(ProjectionOnPositiveEigenvalues, KeepsTheirVectorsAndTakesTheOthersToZero) {
  Uniform uniform(2);
  for (int i = 0; i < 10; ++i) {
    auto const V = random_matrix<Judge>(uniform);
    Judge const small = std::pow(10.0, uniform(-6, 0));
    auto const A = with_eigenvalues({3, small, Judge("0.7"), -small, -2, -9}, V);
    auto const P = projection_on_positive_eigenvalues(A);
    auto const expected = with_eigenvalues({1, 1, 1, 0, 0, 0}, V);
    EXPECT_LT(norm<Judge>(P - expected), 1e-60) << i;
    EXPECT_LT(std::abs(static_cast<double>(Judge(P.trace() - 3))), 1e-60) << i;
  }
}

TEST(ProjectionOnPositiveEigenvalues, CountsComplexPairsByTheirRealParts) {
  Matrix<double> A = Matrix<double>::Zero();  // 1 ± 2i, −1 ± 5i, 4, 0.5
  A.topLeftCorner<2, 2>() << 1, 2, -2, 1;
  A.block<2, 2>(2, 2) << -1, 5, -5, -1;
  A(4, 4) = 4;
  A(5, 5) = 0.5;
  A(0, 3) = A(2, 5) = 0.25;
  auto const P = projection_on_positive_eigenvalues(A);
  EXPECT_NEAR(P.trace(), 4, 1e-14);
  EXPECT_LT(norm<double>(P * P - P), 1e-14);
  EXPECT_LT(norm<double>(P * A - A * P), 1e-14);
}

TEST(ProjectionOnPositiveEigenvalues, HasNoNumbersWhereThereIsNone) {
  Matrix<double> A = Matrix<double>::Identity();
  A.topLeftCorner<2, 2>() << 0, 1, -1, 0;  // ±i
  EXPECT_TRUE(projection_on_positive_eigenvalues(A).hasNaN());
  A.setZero();
  EXPECT_TRUE(projection_on_positive_eigenvalues(A).hasNaN());
  A.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(projection_on_positive_eigenvalues(A).hasNaN());
}

}  // namespace
}  // namespace brouwer
