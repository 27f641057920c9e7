#include <brouwer/ensemble/builtin.hpp>
#include <brouwer/ensemble/method.hpp>
#include <brouwer/integrators/dmv.hpp>
#include <brouwer/integrators/elliptic_branch_free.hpp>
#include <brouwer/integrators/elliptic_naive.hpp>
#include <brouwer/integrators/elliptic_three_constants.hpp>
#include <brouwer/systems/rigid_body_flow.hpp>

namespace brouwer {

void add_rigid_body(Catalogue& catalogue) {
  catalogue.systems.push_back(describe_rigid_body());
  auto const add = [&](MethodEntry const& entry) { catalogue.methods.push_back(entry); };
  bool const libm = true;

  add(method_with_functions<EllipticNaive>({"elliptic-naive", "rigid_body",
                                            "Jacobi's elliptic functions with the textbook's constants",
                                            "L. D. Landau, E. M. Lifshitz, Mechanics, section 37", libm}));
  add(method_with_functions<EllipticThreeConstants>({"elliptic-three-constants", "rigid_body",
                                                     "the same with three consistent constants, step in the argument",
                                                     "G. Vilmart, J. Comput. Phys. 227 (2008) 7083", libm}));
  add(method_with_functions<EllipticAddition>({"elliptic-addition", "rigid_body",
                                               "three constants, step by the addition theorem",
                                               "G. Vilmart, J. Comput. Phys. 227 (2008) 7083", libm}));
  add(method<EllipticBranchFree>({"elliptic-branch-free", "rigid_body",
                                  "addition theorem without modulus, sign or branch, new values",
                                  "brouwer, lib/brouwer/integrators/addition_step.hpp", libm}));
  add(method<EllipticIncrement>({"elliptic-increment", "rigid_body", "the same as increments, free of cancellation",
                                 "brouwer, lib/brouwer/integrators/addition_step.hpp", libm}));
  add(method<Dmv2>({"dmv-2", "rigid_body", "discrete Moser-Veselov algorithm in quaternions",
                    "E. Hairer, G. Vilmart, J. Phys. A 39 (2006) 13225"}));
}

}  // namespace brouwer
