#pragma once
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <brouwer/store/results.hpp>
#include <cmath>
#include <memory>
#include <vector>

namespace brouwer {

/// e(t) = (drift + persistence·N) t + diffusion·W(t) + noise·N: the model of the inference, with bounded noise beside
/// it.
struct Law {
  double drift = 0, persistence = 0, diffusion = 0, noise = 0;
  bool phase = false;  ///< the time integral of all this, as an angle has it
  bool heavy = false;  ///< increments of the walk have Student's t(5) law, of the same variance
};

/// Random numbers with a fixed seed, the same on every machine.
class Normal {
 public:
  explicit Normal(unsigned long seed) : rng_(gsl_rng_alloc(gsl_rng_mt19937), gsl_rng_free) {
    gsl_rng_set(rng_.get(), seed);
  }
  double operator()() { return gsl_ran_gaussian_ziggurat(rng_.get(), 1); }
  double heavy() { return gsl_ran_tdist(rng_.get(), 5) * std::sqrt(3.0 / 5); }

 private:
  std::unique_ptr<gsl_rng, void (*)(gsl_rng*)> rng_;
};

/// `count` different whole times, as log-spaced as whole numbers allow, the last is `last`.
inline std::vector<double> log_spaced(int count, double last) {
  std::vector<double> times;
  for (int j = 1; j <= count; ++j) {
    double const ideal = std::round(std::pow(last, static_cast<double>(j) / count));
    times.push_back(std::max(ideal, times.empty() ? 1 : times.back() + 1));
  }
  return times;
}

inline Ensemble simulated(Law const& law, int members, std::vector<double> times, Normal& normal) {
  Ensemble ensemble;
  ensemble.quantity = ensemble.family = "energy";
  ensemble.errors.resize(members, std::ssize(times));
  for (auto row : ensemble.errors.rowwise()) {
    double const slope = law.drift + law.persistence * normal();
    double walk = 0, angle = 0, last = 0;
    for (Eigen::Index j = 0; j < row.size(); ++j) {
      double const time = times[static_cast<std::size_t>(j)];
      walk += law.diffusion * std::sqrt(time - last) * (law.heavy ? normal.heavy() : normal());
      double const error = slope * time + walk + law.noise * normal();
      angle += error * (time - last);
      last = time;
      row[j] = law.phase ? angle : error;
    }
  }
  ensemble.times = std::move(times);
  return ensemble;
}

inline Ensemble simulated(Law const& law, int members, std::vector<double> times, unsigned long seed) {
  Normal normal(seed);
  return simulated(law, members, std::move(times), normal);
}

}  // namespace brouwer
