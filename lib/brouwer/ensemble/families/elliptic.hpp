#pragma once
#include <brouwer/ensemble/method.hpp>
#include <brouwer/integrators/elliptic_branch_free.hpp>
#include <brouwer/integrators/elliptic_naive.hpp>
#include <brouwer/integrators/elliptic_three_constants.hpp>

/// The rigid body by Jacobi's elliptic functions.
namespace brouwer::families::elliptic {

template <class Visit>
void for_each_method(Visit visit) {
  char const* const vilmart = "G. Vilmart, J. Comput. Phys. 227 (2008) 7083";
  char const* const own = "brouwer, lib/brouwer/integrators/addition_step.hpp";
  bool const libm = true;

  visit(OverFunctions<EllipticNaive>{},
        MethodText{"elliptic-naive", "rigid_body", "Jacobi's elliptic functions with the textbook's constants",
                   "L. D. Landau, E. M. Lifshitz, Mechanics, section 37", libm});
  visit(OverFunctions<EllipticThreeConstants>{},
        MethodText{"elliptic-three-constants", "rigid_body",
                   "the same with three consistent constants, step in the argument", vilmart, libm});
  visit(OverFunctions<EllipticAddition>{},
        MethodText{"elliptic-addition", "rigid_body", "three constants, step by the addition theorem", vilmart, libm});
  visit(Plain<EllipticBranchFree>{},
        MethodText{"elliptic-branch-free", "rigid_body", "addition theorem without modulus, sign or branch, new values",
                   own, libm});
  visit(Plain<EllipticIncrement>{},
        MethodText{"elliptic-increment", "rigid_body", "the same as increments, free of cancellation", own});
}

}  // namespace brouwer::families::elliptic
