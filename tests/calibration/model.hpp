#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/growth/inference.hpp"
#include "analysis/growth/sweep.hpp"
#include "tests/analysis/simulated.hpp"
#include "tests/calibration/design.hpp"

namespace brouwer::calibration {

/// What an interval has to hold. Where the model gives a parameter no meaning it has no truth, and nothing is asked.
struct Truth {
  double drift = 0;
  std::optional<double> persistence, diffusion, noise;
  std::optional<double> time_exponent;  ///< q
  std::optional<double> step_exponent;  ///< p
};

/// A law by which ensembles are simulated, in units of the run: time in its duration, errors in the final spread of a
/// walk of σ = 1.
struct Model {
  char const* name;
  char const* words;  ///< how it differs from the walk
  Law law;
  std::optional<double> time_exponent = std::nullopt;
  bool visible_drift = false;  ///< the drift is the smallest that such an ensemble sees with the chance levels.power
  bool hostile = false;        ///< does not belong to the model of the inference
  std::vector<double> steps = {};  ///< h of a sweep of such cells
  /// What becomes of an ensemble of the law; t is its time in units of the run.
  void (*spoil)(Ensemble& ensemble, Normal& normal) = nullptr;
};

std::span<Model const> models();
Model const& model(std::string const& name);

/// One ensemble and what was said of it.
struct Trial {
  Truth truth;
  Estimates estimates;
  std::optional<SweepLaw> sweep;
};

/// The trial of this number: a function of its arguments alone, on whatever thread.
Trial trial(Model const& model, Design const& design, std::uint32_t number);

/// The ensemble of that trial (the first cell's, of a sweep), in steps and absolute errors.
Ensemble ensemble_of(Model const& model, Design const& design, std::uint32_t number);

}  // namespace brouwer::calibration
