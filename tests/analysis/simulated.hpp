#pragma once
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <brouwer/store/results.hpp>
#include <cmath>
#include <memory>
#include <vector>

namespace brouwer {

/// A random number of mean 0 and variance 1.
using Shape = double (*)(gsl_rng*);
inline double normal_shape(gsl_rng* rng) { return gsl_ran_gaussian_ziggurat(rng, 1); }
inline double student_5(gsl_rng* rng) { return gsl_ran_tdist(rng, 5) * std::sqrt(3.0 / 5); }

/// e(t) = (drift + persistence·N) t + diffusion·W(t) + noise·N: the model of the inference, with bounded noise beside
/// it. What follows `phase` leaves the model.
struct Law {
  double drift = 0, persistence = 0, diffusion = 0, noise = 0;
  bool phase = false;          ///< the time integral of all this, as an angle has it
  Shape shape = normal_shape;  ///< of the increments of W from sample to sample, over √δ
  double correlation = 0;      ///< of one such increment with the next: AR(1)
  double inequality = 0;  ///< log σᵢ is normal with this standard deviation over the members; the mean of σᵢ² is σ²
};

/// Random numbers with a fixed seed, the same on every machine.
class Normal {
 public:
  explicit Normal(unsigned long seed, gsl_rng_type const* generator = gsl_rng_mt19937)
      : rng_(gsl_rng_alloc(generator), gsl_rng_free) {
    gsl_rng_set(rng_.get(), seed);
  }
  double operator()() { return normal_shape(rng_.get()); }
  double operator()(Shape shape) { return shape(rng_.get()); }

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

/// One member's σᵢ.
inline double diffusion_of_member(Law const& law, Normal& normal) {
  double const s = law.inequality;
  return s > 0 ? law.diffusion * std::exp(s * normal() - s * s) : law.diffusion;
}

inline Ensemble simulated(Law const& law, int members, std::vector<double> times, Normal& normal) {
  Ensemble ensemble;
  ensemble.quantity = ensemble.family = "energy";
  ensemble.errors.resize(members, std::ssize(times));
  for (auto row : ensemble.errors.rowwise()) {
    double const slope = law.drift + law.persistence * normal();
    double const diffusion = diffusion_of_member(law, normal);
    double const rho = law.correlation;
    double step = rho == 0 ? 0 : normal(law.shape);
    double walk = 0, angle = 0, last = 0;
    for (Eigen::Index j = 0; j < row.size(); ++j) {
      double const time = times[static_cast<std::size_t>(j)];
      step = rho * step + std::sqrt(1 - rho * rho) * normal(law.shape);
      walk += diffusion * std::sqrt(time - last) * step;
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

/// Cells of a sweep over h whose errors have that law in steps, times h^exponent; members share part of their path, as
/// members of one start do.
inline std::vector<Ensemble> swept(Law const& law, double exponent, std::vector<double> const& steps, int members,
                                   std::vector<double> const& times, Normal& normal) {
  std::vector<Ensemble> cells;
  auto const shared = simulated(law, members, times, normal);
  for (double const h : steps) {
    auto cell = simulated(law, members, times, normal);
    cell.errors = std::pow(h, exponent) * (0.6 * shared.errors + 0.8 * cell.errors);
    cell.cell.method = "dmv-2";
    cell.cell.step = h;
    cell.cell.steps = static_cast<std::int64_t>(times.back());
    cells.push_back(std::move(cell));
  }
  return cells;
}

}  // namespace brouwer
