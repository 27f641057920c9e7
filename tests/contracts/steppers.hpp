#pragma once
#include <brouwer/integrators/dmv.hpp>
#include <brouwer/integrators/elliptic_branch_free.hpp>
#include <brouwer/integrators/elliptic_naive.hpp>
#include <brouwer/integrators/elliptic_three_constants.hpp>
#include <gtest/gtest.h>

// Every stepper of the rigid body, one line each: what is listed here keeps the promises of the contract tests.
namespace brouwer::testing_support {

/// A stepper's template as a type, so that a test can put any scalar in.
template <template <class> class S>
struct Family {
  template <class T>
  using In = S<T>;
};

template <class T>
using Naive = EllipticNaive<T, OwnElliptic>;
template <class T>
using ThreeConstants = EllipticThreeConstants<T, OwnElliptic>;
template <class T>
using Addition = EllipticAddition<T, OwnElliptic>;

using ExactRigidBodySteppers = testing::Types<Family<Naive>, Family<ThreeConstants>, Family<Addition>,
                                              Family<EllipticBranchFree>, Family<EllipticIncrement>>;
using RigidBodySteppers = testing::Types<Family<Naive>, Family<ThreeConstants>, Family<Addition>,
                                         Family<EllipticBranchFree>, Family<EllipticIncrement>, Family<Dmv2>>;

}  // namespace brouwer::testing_support
