#pragma once
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <brouwer/store/results.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace brouwer {

/// Standardised increments with a law of their own, one after another in time; a fixed seed.
class Increments {
 public:
  explicit Increments(unsigned long seed) : rng_(gsl_rng_alloc(gsl_rng_mt19937), gsl_rng_free) {
    gsl_rng_set(rng_.get(), seed);
  }
  double normal() { return gsl_ran_gaussian_ziggurat(rng_.get(), 1); }
  /// x = ρ x' + √(1 − ρ²) z.
  double autoregressive(double rho, double before) { return rho * before + std::sqrt(1 - rho * rho) * normal(); }
  /// Student's t of 5 degrees of freedom over its standard deviation.
  double heavy_tailed() { return gsl_ran_tdist(rng_.get(), 5) / std::sqrt(5. / 3); }
  /// Exponential, less its mean: skewness 2.
  double skewed() { return gsl_ran_exponential(rng_.get(), 1) - 1; }

 private:
  std::unique_ptr<gsl_rng, void (*)(gsl_rng*)> rng_;
};

inline std::vector<double> linearly_spaced(int count, double last) {
  std::vector<double> times;
  for (int j = 1; j <= count; ++j) times.push_back(last * j / count);
  return times;
}

/// e(t) = drift·t + σ Σ √δⱼ xⱼ with x = next(x before), of variance 1.
inline Ensemble ensemble_of(std::function<double(double)> const& next, int members, std::vector<double> times,
                            double sigma = 2e-16, double drift = 0) {
  Ensemble ensemble;
  ensemble.quantity = ensemble.family = "energy";
  ensemble.errors.resize(members, std::ssize(times));
  for (auto row : ensemble.errors.rowwise()) {
    double x = 0, error = 0, before = 0;
    for (std::size_t j = 0; j < times.size(); ++j) {
      x = next(x);
      error += sigma * std::sqrt(times[j] - before) * x + drift * (times[j] - before);
      before = times[j];
      row[static_cast<Eigen::Index>(j)] = error;
    }
  }
  ensemble.times = std::move(times);
  return ensemble;
}

}  // namespace brouwer
