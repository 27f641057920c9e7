// A program of one's own: the inference on one's own numbers, and the command line on one's own catalogue.
#include <analysis/inference.hpp>
#include <studies/program.hpp>

int main() {
  brouwer::Ensemble ensemble;
  ensemble.times = {1, 2};
  ensemble.errors.resize(3, 2);
  ensemble.errors << 1, 2, 1.1, 1.9, 0.9, 2.1;
  double const drift = brouwer::estimate(ensemble, {}).drift.per_step;
  char const* const words[] = {"user", "list", "systems"};
  return std::abs(drift - 1) < 1e-12 ? brouwer::program(3, words, brouwer::builtin_catalogue()) : 1;
}
