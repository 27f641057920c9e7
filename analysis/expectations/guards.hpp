#pragma once
#include <string>
#include <vector>

#include "analysis/expectations/expectation.hpp"
#include <brouwer/store/results.hpp>

namespace brouwer {

/// A cell on which expectations rest: its finished units with starts and final states (Results::ends), and the rows that
/// are spoken of.
struct GuardedCell {
  CellLabels cell;
  std::vector<UnitRecord> units;
  std::vector<Estimates> rows;
};

/// What an expectation rests on without saying so. An integrator that does nothing conserves everything; members that
/// are all alike have no spread, and any mean of theirs is infinitely many standard errors from 0; in a moving frame the
/// rounding grows with the distance and not with the steps. Such results pass for good ones, so a guard that fails is a
/// failure of its own.
///
///     the state has moved        some component of most members changed by more than 4 ε of the largest one
///     the frame rests            where bodies have masses, their barycentre moved by less than a thousandth of the
///                                system's radius
///     the members differ         at least half of them, in start or final state
///     the statistics are finite  t and F of the rows spoken of: infinite where all slopes, or all increments, are equal
///     most members came through  of the rows spoken of, at least half
///
/// @return for each guard one outcome: failed ones a cell, or that it holds in all
std::vector<Outcome> check_guards(std::vector<GuardedCell> const& cells);

/// What makes the statistics of another program's ensemble doubtful, a sentence each: members that are copies of one
/// another; numbers without sign, as absolute values are: their mean is no drift.
std::vector<std::string> doubts(Ensemble const& ensemble);

}  // namespace brouwer
