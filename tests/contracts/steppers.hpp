#pragma once
#include <brouwer/integrators/dmv_exact.hpp>
#include <brouwer/integrators/dmv_matrix.hpp>
#include <brouwer/integrators/elliptic_branch_free.hpp>
#include <brouwer/integrators/elliptic_naive.hpp>
#include <brouwer/integrators/elliptic_three_constants.hpp>
#include <brouwer/integrators/rigid_body_splitting.hpp>
#include <gtest/gtest.h>

// Every stepper of the rigid body, one line each: what is listed here keeps the promises of the contract tests.
namespace brouwer::testing_support {

/// A stepper's template as a type, so that a test can put any scalar in.
template <template <class> class S>
struct Family {
  template <class T>
  using In = S<T>;
};

template <int order, class Coefficients>
struct DmvFamily {
  template <class T>
  using In = Dmv<T, order, Coefficients>;
};

template <Composition const& composition>
struct SplittingFamily {
  template <class T>
  using In = RigidBodySplittingBy<T, composition>;
  static constexpr bool conserves_energy = false;  ///< to its order only
};

template <class F>
inline constexpr bool conserves_energy = true;
template <class F>
requires requires { F::conserves_energy; }
inline constexpr bool conserves_energy<F> = F::conserves_energy;

template <class T>
using Naive = EllipticNaive<T, OwnElliptic>;
template <class T>
using ThreeConstants = EllipticThreeConstants<T, OwnElliptic>;
template <class T>
using Addition = EllipticAddition<T, OwnElliptic>;

using ExactRigidBodySteppers = testing::Types<Family<Naive>, Family<ThreeConstants>, Family<Addition>,
                                              Family<EllipticBranchFree>, Family<EllipticIncrement>>;
using RigidBodySteppers = testing::Types<  //
    Family<Naive>,                         //
    Family<ThreeConstants>,                //
    Family<Addition>,                      //
    Family<EllipticBranchFree>,            //
    Family<EllipticIncrement>,             //
    Family<Dmv2>,                          //
    DmvFamily<4, PerStep>,                 //
    DmvFamily<4, PerTrajectory>,           //
    DmvFamily<6, PerStep>,                 //
    DmvFamily<6, PerTrajectory>,           //
    DmvFamily<8, PerStep>,                 //
    DmvFamily<8, PerTrajectory>,           //
    DmvFamily<10, PerStep>,                //
    DmvFamily<10, PerTrajectory>,          //
    Family<DmvExact>,                      //
    Family<DmvMatrix>,                     //
    SplittingFamily<base_method>,          //
    SplittingFamily<suzuki_4>,             //
    SplittingFamily<kahan_li_6>,           //
    SplittingFamily<suzuki_umeno_8>>;

// --- those of a list that run in lanes: they say so by `static constexpr bool runs_in_lanes = true` --------------------

template <class F>
concept RunsInLanes = requires {
  requires F::template In<double>::runs_in_lanes;
};

template <class Kept, class... Families>
struct OnlyInLanes;
template <class... Kept>
struct OnlyInLanes<testing::Types<Kept...>> {
  using type = testing::Types<Kept...>;
};
template <class... Kept, class F, class... Rest>
struct OnlyInLanes<testing::Types<Kept...>, F, Rest...>
    : OnlyInLanes<std::conditional_t<RunsInLanes<F>, testing::Types<Kept..., F>, testing::Types<Kept...>>, Rest...> {};

template <class List>
struct InLanesOf;
template <class... Families>
struct InLanesOf<testing::Types<Families...>> : OnlyInLanes<testing::Types<>, Families...> {};

using RigidBodySteppersInLanes = InLanesOf<RigidBodySteppers>::type;

}  // namespace brouwer::testing_support
