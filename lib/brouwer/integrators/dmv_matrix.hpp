#pragma once
#include <Eigen/LU>

#include <brouwer/integrators/stepper.hpp>
#include <brouwer/special/matrix_sign.hpp>
#include <brouwer/systems/rigid_body.hpp>

namespace brouwer {

/// The discrete Moser–Veselov algorithm in its original form: with D = diag(d), d₁ + d₂ = I₃ (and cyclic), ω ∈ SO(3) solves
///     ωᵀD − Dω = h ŷ        ŷ' = ω ŷ ωᵀ    q' = q ⊗ q(ωᵀ)
/// J. Moser, A. P. Veselov, Comm. Math. Phys. 139 (1991) 217. It is the step of Dmv2 found in another way, for single
/// numbers alone: the other's oracle.
///
/// For X = ωᵀ the equation, times X from the right, is XDX = hŷX + D. Hence with DXv = λv and u = Xv
///     λu = hŷu + Dv    λv = Du
/// and X takes v to u on the invariant subspace of this 6×6 matrix that belongs to λ = d₁, d₂, d₃ of h = 0, by a projection
/// on Re λ > 0. J. R. Cardoso, F. S. Leite, Linear Algebra Appl. 360 (2003) 237, has it as the Hamiltonian matrix of a
/// Riccati equation, for which D must not be singular; see also R. I. McLachlan, A. Zanna, Found. Comput. Math. 5 (2005) 87.
///
/// A rotation is known from what it makes of two vectors. Of a body that is nearly flat, d₃ < d₂/2, only those of d₁ and d₂
/// are well determined: those with Re λ > I₁/2 = (d₂ + d₃)/2, or half of it …, because λ become smaller as the step grows.
///
/// Where there is no solution (the step turns by more than a right angle) the state becomes NaN. The errors are some ε of
/// the momentum and the attitude themselves, not of their change.
template <Real T>
requires(lanes<T> == 1) class DmvMatrix {
 public:
  using Scalar = T;
  using System = RigidBody<T>;
  using State = RigidBodyState<T>;
  static constexpr int order = 2;

  /// There is no solution where a step turns the body by more than a right angle.
  static Failure failure(State const&, int) { return Failure::step_too_large; }

  explicit DmvMatrix(Setup<System> const& setup) : h_(setup.step), attitude_(setup.whole_state) {
    using W = Wider<T>;
    auto const I = setup.system.template in<W>().inertia();
    for (int j = 0; j < 3; ++j) d_[j] = rounded<T>(W((I[(j + 1) % 3] + I[(j + 2) % 3] - I[j]) / W(2)));
    shift_ = T(2) * d_[2] < d_[1] ? setup.system.inertia()[0] / T(2) : T(0);
  }

  State operator()(State const& s) const {
    Matrix const X = omega_transposed(s.momentum);
    Matrix const after = X.transpose() * hat(s.momentum) * X;
    Vector3<T> const y{(after(2, 1) - after(1, 2)) / T(2), (after(0, 2) - after(2, 0)) / T(2),
                       (after(1, 0) - after(0, 1)) / T(2)};
    return {y, attitude_ ? hamilton_product(s.attitude, rotation_quaternion(X)) : s.attitude};
  }

 private:
  using Matrix = Eigen::Matrix<T, 3, 3>;
  static constexpr int shifts = 8;
  using Matrix6 = Eigen::Matrix<T, 6, 6>;

  static Matrix hat(Vector3<T> const& a) {
    Matrix m;
    m << T(0), T(-a[2]), a[1], a[2], T(0), T(-a[0]), T(-a[1]), a[0], T(0);
    return m;
  }

  Matrix omega_transposed(Vector3<T> const& y) const {
    Matrix const D = d_.asDiagonal(), M = h_ * hat(y);
    T shift = shift_;
    for (int i = 0; i < shifts && shift > T(0); ++i, shift = shift / T(2)) {
      Matrix const X = beyond(shift, D, M);
      if (is_solution(X, D, M)) return X;
    }
    Matrix const X = beyond(T(0), D, M);
    return is_solution(X, D, M) ? X : Matrix(Matrix::Constant(std::numeric_limits<T>::quiet_NaN()));
  }

  /// X from the two or three λ with Re λ > shift; of fewer something else.
  static Matrix beyond(T const& shift, Matrix const& D, Matrix const& M) {
    Matrix const shifted = shift * Matrix::Identity();
    Matrix6 A;
    A << Matrix(M - shifted), D, D, Matrix(-shifted);
    Matrix6 const P = projection_on_positive_eigenvalues(A);
    Matrix U = P.template topRightCorner<3, 3>(), V = P.template bottomRightCorner<3, 3>();
    if (T(2) * P.trace() < T(5)) {
      U.col(2) = cross<T>(U.col(0), U.col(1));
      V.col(2) = cross<T>(V.col(0), V.col(1));
    }
    return U * V.inverse();
  }

  /// To half the digits: whether it is one, not how good it is. What is no number is none.
  static bool is_solution(Matrix const& X, Matrix const& D, Matrix const& M) {
    Matrix const defect = X * D - D * X.transpose() - M, length = X.transpose() * X - Matrix::Identity();
    T const tolerance = epsilon<T>();
    return squared_frobenius_norm(defect) <= tolerance * squared_frobenius_norm(D) &&
           squared_frobenius_norm(length) <= tolerance && X.determinant() > T(0);
  }

  /// S. W. Shepperd, J. Guidance Control 1 (1978) 223: from the largest of w², x², y², z², by the quotient of the others'
  /// products.
  static Quaternion<T> rotation_quaternion(Matrix const& X) {
    Quaternion<T> q(X);
    if (q.w() < T(0)) q.coeffs() = -q.coeffs();
    return q;
  }

  T h_, shift_;
  bool attitude_;
  Vector3<T> d_;
};

}  // namespace brouwer
