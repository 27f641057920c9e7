#pragma once
#include <functional>
#include <string>
#include <vector>

#include "analysis/expectations/expectation.hpp"

namespace brouwer {

struct SweepLaw;  // analysis/growth/sweep.hpp

/// Fits RMS = a·hᵖ·t^q over the ensembles that these estimates speak of (indices into the estimates).
using FitSweep = std::function<SweepLaw(std::vector<std::size_t> const& rows)>;

/// Is this row's component or quantity named, and its cell selected?
bool speaks_of(Expectation const& expectation, Estimates const& row);

/// Confronts what a study expects with what was estimated: an outcome for each part of an expectation (drift, growth,
/// persistence, mean, RMS, failed members, verdict) and each row that it speaks of, and for step_exponent one for each set of rows that differ in
/// nothing but the step. An expectation that speaks of no row has failed, and its outcome says what there is.
/// Of a count (iterations per step) no drift, growth or persistence can be expected: that has failed, and says so.
/// A test without a number (one member, one time) has failed. Members that were left out are mentioned.
/// @param sweep       called for step_exponent only, with the rows of at least three different steps
/// @param correction  of all tests of all outcomes at once: no drift, a drift seen, a drift proven small, persistence
/// @throws InputError for a verdict that does not exist, with the nearest one and its line in the study
std::vector<Outcome> check(std::vector<Expectation> const& expectations, std::vector<Estimates> const& estimates,
                           FitSweep const& sweep, Correction correction = Correction::none);

/// The words that an expectation may use for a verdict: "random walk", "drift", …
std::vector<std::string> verdict_words();

}  // namespace brouwer
