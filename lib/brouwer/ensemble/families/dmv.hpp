#pragma once
#include <brouwer/ensemble/method.hpp>
#include <brouwer/integrators/dmv.hpp>
#include <brouwer/integrators/dmv_exact.hpp>
#include <brouwer/integrators/dmv_matrix.hpp>

/// The discrete Moser–Veselov algorithm.
namespace brouwer::families::dmv {

template <class Visit>
void for_each_method(Visit visit) {
  char const* const hairer_vilmart = "E. Hairer, G. Vilmart, J. Phys. A 39 (2006) 13225";
  visit(Plain<Dmv2>{},
        MethodText{"dmv-2", "rigid_body", "discrete Moser-Veselov algorithm in quaternions", hairer_vilmart});
  visit(Plain<DmvMatrix>{},
        MethodText{"dmv-matrix", "rigid_body", "the same solved as an equation of matrices: an oracle, slow",
                   "J. Moser, A. P. Veselov, Comm. Math. Phys. 139 (1991) 217"});
  visit(OverCoefficients<Dmv4>{}, MethodText{"dmv-4", "rigid_body", "preprocessed", hairer_vilmart});
  visit(OverCoefficients<Dmv6>{}, MethodText{"dmv-6", "rigid_body", "preprocessed", hairer_vilmart});
  visit(OverCoefficients<Dmv8>{}, MethodText{"dmv-8", "rigid_body", "preprocessed", hairer_vilmart});
  visit(OverCoefficients<Dmv10>{}, MethodText{"dmv-10", "rigid_body", "preprocessed", hairer_vilmart});
  visit(Plain<DmvExact>{}, MethodText{"dmv-exact", "rigid_body", "preprocessed to order infinity: the flow itself",
                                      "brouwer, docs/dmv-exact.md"});
}

}  // namespace brouwer::families::dmv
