#include "analysis/increments/histogram.hpp"

#include <algorithm>
#include <cmath>

namespace brouwer {
namespace {

std::size_t bins_for(std::size_t size) {
  auto const rice = static_cast<std::size_t>(2 * std::cbrt(static_cast<double>(size)) * 8 / 5);
  return std::clamp<std::size_t>(rice | 1u, 9, 81);
}

}  // namespace

Histogram::Histogram(std::size_t size) : counts_(bins_for(size)) {}

void Histogram::add(double z) {
  if (std::isnan(z)) return;
  double const position = (std::clamp(z, -3.999, 3.999) + 4) / width();
  counts_[static_cast<std::size_t>(position)] += 1;
  total_ += 1;
}

void Histogram::add(Histogram const& other) {
  for (std::size_t b = 0; b < bins(); ++b) counts_[b] += other.counts_[b];
  total_ += other.total_;
}

std::vector<double> Histogram::density() const {
  std::vector<double> heights = counts_;
  for (auto& height : heights) height /= width() * std::max(total_, 1.0);
  return heights;
}

}  // namespace brouwer
