// What a user of the header library writes: a rigid body turned for a while; its momentum keeps its length.
#include <brouwer/integrators/elliptic_three_constants.hpp>

int main() {
  brouwer::RigidBody<double> const body(brouwer::Vector3<double>(0.6, 0.8, 1.0));
  brouwer::RigidBodyState<double> y{{1.8, 0.4, -0.9}, {1, 0, 0, 0}};
  brouwer::EllipticThreeConstants<double> const step({body, 0.01, y});
  double const length = y.momentum.norm();
  for (int i = 0; i < 1000; ++i) y = step(y);
  return std::abs(y.momentum.norm() - length) < 1e-13 ? 0 : 1;
}
