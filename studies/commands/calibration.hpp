#pragma once
#include <brouwer/ensemble/run.hpp>

namespace brouwer {

/// What a member costs on one thread, in seconds.
struct Costs {
  double begin = 0;   ///< its start: constants, series
  double step = 0;    ///< one step
  double sample = 0;  ///< one look at it
};

/// What a cell costs: its members, and the references of those that are compared.
struct CellCosts {
  Costs member, reference;
  /// Of the whole cell on one thread, samples included.
  double seconds(Study const& study, CellLabels const& cell) const;
};

/// Measures a block of members for some hundredths of a second while every thread of `options` does the same, because
/// cores that share units slow one another.
CellCosts calibrate(Study const& study, Catalogue const& catalogue, CellLabels const& cell, RunOptions const& options);

}  // namespace brouwer
