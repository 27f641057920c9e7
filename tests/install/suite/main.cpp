// A program of one's own: an integrator added to the catalogue, and the brouwer command line with it.
#include <brouwer/ensemble/method.hpp>
#include <brouwer/systems/rigid_body.hpp>
#include <studies/program.hpp>

template <brouwer::Real T>
class ExplicitEuler {
 public:
  using Scalar = T;
  using System = brouwer::RigidBody<T>;
  using State = brouwer::RigidBodyState<T>;
  static constexpr int order = 1;

  explicit ExplicitEuler(brouwer::Setup<System> const& setup) : body_(setup.system), h_(setup.step) {}

  State increment(State const& s) const {
    brouwer::Vector3<T> const rate = body_.momentum_rate(s.momentum);
    return {{h_ * rate[0], h_ * rate[1], h_ * rate[2]}, {T(0), T(0), T(0), T(0)}};
  }

 private:
  System body_;
  T h_;
};

int main(int argc, char** argv) {
  auto catalogue = brouwer::builtin_catalogue();
  catalogue.methods.push_back(
      brouwer::method<ExplicitEuler>({"explicit-euler", "rigid_body", "the simplest", "L. Euler, 1768"}));
  return brouwer::program(argc, argv, catalogue);
}
