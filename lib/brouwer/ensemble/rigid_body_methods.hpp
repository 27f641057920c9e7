#pragma once
#include <brouwer/ensemble/method.hpp>
#include <brouwer/integrators/dmv.hpp>
#include <brouwer/integrators/elliptic_branch_free.hpp>
#include <brouwer/integrators/elliptic_naive.hpp>
#include <brouwer/integrators/elliptic_three_constants.hpp>

namespace brouwer {

// The methods of the rigid body: the tables from which the catalogue is made and, for each instruction set, its packs.
// Two, because each is compiled by itself. visit(Family{}, text) is called for every line.

template <class Visit>
void for_each_elliptic_method(Visit visit) {
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

template <class Visit>
void for_each_dmv_method(Visit visit) {
  char const* const hairer_vilmart = "E. Hairer, G. Vilmart, J. Phys. A 39 (2006) 13225";
  visit(Plain<Dmv2>{},
        MethodText{"dmv-2", "rigid_body", "discrete Moser-Veselov algorithm in quaternions", hairer_vilmart});
  visit(OverCoefficients<Dmv4>{}, MethodText{"dmv-4", "rigid_body", "the same, preprocessed", hairer_vilmart});
  visit(OverCoefficients<Dmv6>{}, MethodText{"dmv-6", "rigid_body", "the same, preprocessed", hairer_vilmart});
  visit(OverCoefficients<Dmv8>{}, MethodText{"dmv-8", "rigid_body", "the same, preprocessed", hairer_vilmart});
  visit(OverCoefficients<Dmv10>{}, MethodText{"dmv-10", "rigid_body", "the same, preprocessed", hairer_vilmart});
}

}  // namespace brouwer
