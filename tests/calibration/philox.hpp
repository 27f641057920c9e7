#pragma once
#include <gsl/gsl_rng.h>

namespace brouwer::calibration {

/// Philox 4×64-10 (J. K. Salmon et al., SC11 (2011); Random123) as a generator of GSL, whose distributions then draw from
/// it: streams of different seeds are independent, so that a trial's numbers depend on its seed alone.
gsl_rng_type const* philox();

}  // namespace brouwer::calibration
