#pragma once
#include <string>

#include "analysis/estimates.hpp"

namespace brouwer {

/// Estimates as the inference would make them of a drifting, or of a driftless, ensemble of 64 members.
inline Estimates presented_estimates(std::string const& method, std::string const& quantity, double beta) {
  Estimates e;
  e.cell = {"rigid_body", method, "double", "own", "-", false, 0.01, 20000};
  e.quantity = quantity;
  e.family = quantity.substr(0, quantity.find("-1"));
  e.unit = "J";
  e.members = 64;
  e.samples = 3;
  e.times = {100, 2000, 20000};
  e.rms = {2e-15, 4e-14, 4.6e-13};
  e.mean = {100 * beta, 2000 * beta, 20000 * beta};
  e.mean_error = {2e-16, 1e-15, 3.2e-15};
  e.rms_final = 4.6e-13;
  bool const drifts = beta != 0;
  e.drift = {beta, {beta - 3e-19, beta + 3e-19}, beta / 1.6e-19, drifts ? 1e-80 : 0.6, drifts ? 0.998 : 0.0};
  e.persistence = {0, 1.05, 0.35, 0.65};
  e.diffusion = {1.96e-16, {1.9e-16, 2.02e-16}};
  e.growth = {drifts ? 0.81 : 0.51, {drifts ? 0.78 : 0.48, drifts ? 0.84 : 0.54}};
  e.smallest_visible_drift = 7.3e-19;
  e.verdict = drifts ? Verdict::drift : Verdict::random_walk;
  e.sentence = "The error of " + quantity + " is as told.";
  return e;
}

}  // namespace brouwer
