#pragma once
#include <optional>
#include <string>

#include "analysis/probe/local_errors.hpp"

namespace brouwer {

/// What a probe found of one quantity of one cell, what it predicts, and what a run has shown.
struct ProbedRow {
  LocalEstimates local;
  std::optional<Prediction> prediction;  ///< not of the state
  std::optional<Estimates> observed;     ///< where there are results
};

/// How far a prediction is from what was observed.
struct Agreement {
  double z = 0;        ///< predicted − observed, in standard errors of both together
  double ratio = 1;    ///< predicted / observed
  bool agrees = true;  ///< |z| is below what chance exceeds at levels.test; true where one of them is not known
};
Agreement drift_agreement(ProbedRow const& row);
Agreement diffusion_agreement(ProbedRow const& row);

/// "(−2.2 ± 0.3)e-17"
std::string bias_in_words(LocalLaw const& law);

/// What the local errors say of the drift: whether rounding or the method itself is biased, in one sentence.
std::string cause_in_words(LocalEstimates const& local);

/// "agrees within sampling error", or by how much it does not and why, as far as the probe knows; "" where nothing was
/// observed. In words, of β and σ.
std::string comparison_in_words(ProbedRow const& row);

}  // namespace brouwer
