#pragma once
#include "analysis/units.hpp"

namespace brouwer {

/// What the closed-form inference (inference.hpp) needs of an ensemble, in units in which no square over- or underflows.
struct ClosedForm {
  double members = 0, samples = 0;
  double rests = 0;  ///< members whose ways to their ends tell of σ: M, or M − 1 about a free course of their mean
  double duration = 0;  ///< t_J
  double slope = 0;     ///< mean of sᵢ
  double variance = 0;  ///< of sᵢ, about their mean; NaN for one member
  double sigma2 = 0;    ///< σ̂²; NaN for one sample time

  double degrees() const { return rests * (samples - 1); }
  double standard_error() const { return std::sqrt(variance / members); }

  Drift drift(Units const& units, double confidence) const;
  Persistence persistence(Units const& units) const;
  Diffusion diffusion(Units const& units, double confidence) const;
};

/// @param rests  M − 1 where the mean of all members was taken away at every time
ClosedForm closed_form(Ensemble const& ensemble, Units const& units, double rests);

}  // namespace brouwer
