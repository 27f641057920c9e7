#pragma once
#include <brouwer/integrators/addition_step.hpp>
#include <brouwer/special/gauss_legendre.hpp>
#include <brouwer/systems/attitude_frame.hpp>

namespace brouwer {

/// The exact step over h whose middle lies at y₂ = 0, from (a₁, −b, a₃) to (a₁, b, a₃), on the curve of constant H and C
/// through a start. What distinguishes one trajectory from another is read off here, in momentum and attitude: with S
/// for `stride`, the step's rotation is (1, c)/√(1 + |c|²) with
///     c = S (M₁(1/I₁ + ρ), 0, M₃(1/I₃ + ρ))/2
template <Real W>
struct SymmetricStep {
  Vector3<W> M;          ///< sum of the momenta, (2a₁, 0, 2a₃)
  W stride = W(0);       ///< b/(c₃a₁a₃): hg/(2 cn dn) of half the step, h/2 where h is small
  W rho = W(0);          ///< of size h²
  W psi = W(0);          ///< Δψ of AttitudeFrame, radians
  W half_cosine = W(1);  ///< of the angle of the rotation, which goes on beyond π

  /// |c|²
  W half_tangent2(Vector3<W> const& inertia) const {
    W const c1 = M[0] * (W(1) / inertia[0] + rho), c3 = M[2] * (W(1) / inertia[2] + rho);
    return squared(stride) * (squared(c1) + squared(c3)) / W(4);
  }
};

/// Single numbers, no packs.
/// @param nodes  of the Gauss–Legendre quadrature of dψ/dt over half a step; the integrand is even about the middle
template <Real W>
SymmetricStep<W> symmetric_step(RigidBody<W> const& body, Vector3<W> const& start, W const& h, int nodes) {
  SymmetricStep<W> result;
  EllipticConstants<W> const c(body);
  EllipticBranch<W> const branch(c, start);
  Vector3<W> const middle = branch.momentum({W(0), W(1), W(1)});
  auto const after_middle = [&](W const& time) {
    AdditionStep<W> const step(c, Wider<W>(time), middle);
    return step.next(step.half(middle), middle);
  };
  Vector3<W> const after = after_middle(h / W(2)), before{after[0], -after[1], after[2]};
  Vector3<W> const M{after[0] + before[0], W(0), after[2] + before[2]};
  W const n = squared_norm(M);
  AdditionStep<W> const step(c, Wider<W>(h), middle);
  auto const half = step.half(middle);
  result.M = M;
  result.stride = step.shortest() * half.g / (W(1) + half.slope_less_one);
  if (!(n > W(0))) return result;

  EllipticBranch<W> const here(c, before);
  AttitudeFrame<W> const frame(here, before);
  int const dn_axis = here.exchanged ? 0 : 2;
  GaussLegendre<W> const rule(nodes);
  for (auto const& node : rule.nodes()) {
    W const along = here.side() * after_middle(h * node.x / W(2))[dn_axis];
    result.psi +=
        h * node.weight * attitude_rate(W(W(2) * body.energy(before)), frame.r, along, body.inertia()[dn_axis]);
  }
  auto const turn = frame.turn_less_one({W(0), after[1] - before[1], W(0)}, result.psi);
  result.half_cosine = W(1) + turn.w();
  W const b = (turn.x() * M[0] + turn.z() * M[2]) / (result.half_cosine * n);
  result.rho = W(2) * b * (W(1) + half.slope_less_one) / (step.shortest() * half.g) - W(2) * body.energy(M) / n;
  return result;
}

}  // namespace brouwer
