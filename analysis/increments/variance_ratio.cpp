#include "analysis/increments/variance_ratio.hpp"

#include <algorithm>
#include <cmath>

namespace brouwer {
namespace {

using Blocks = std::vector<Aggregation::Block>;

/// From the first sample on, as short as they can be: a block ends at the first sample at least d after its beginning.
Blocks blocks_of(Eigen::ArrayXd const& times, double d) {
  Blocks blocks;
  auto const* const begin = times.data();
  for (Eigen::Index a = 0; a < times.size();) {
    auto const b = std::lower_bound(begin + a, begin + times.size(), times[a] + d) - begin;
    if (b == times.size()) break;
    bool const fits = b - a >= 2 && times[b] - times[a] < 2 * d && times[b] <= longest_reach * times[a];
    if (fits) blocks.push_back({a, b - a});
    a = fits ? b : a + 1;
  }
  return blocks;
}

Aggregation aggregation_of(Eigen::ArrayXd const& times, Blocks blocks) {
  Aggregation made{0, std::move(blocks), Eigen::ArrayXd::Zero(times.size() - 1)};
  Eigen::ArrayXd const inverse = times.inverse();
  for (auto const& [first, length] : made.blocks) {
    auto const before = inverse.segment(first, length), now = inverse.segment(first + 1, length);
    made.coefficients.segment(first, length) = ((before - now) / (inverse[first] - inverse[first + length])).sqrt();
    made.scale += (times[first + length] - times[first]) / static_cast<double>(made.blocks.size());
  }
  return made;
}

}  // namespace

std::vector<Aggregation> aggregations(Eigen::ArrayXd const& times, std::int64_t members) {
  auto const last = times.size() - 1;
  double const shortest = (times.tail(last) - times.head(last)).minCoeff();
  std::vector<Aggregation> scales;
  for (double d = 2 * shortest; d <= times[last]; d *= 2)
    if (auto blocks = blocks_of(times, d); std::ssize(blocks) * members >= fewest_blocks)
      scales.push_back(aggregation_of(times, std::move(blocks)));
  return scales;
}

double Aggregation::free_signs() const {
  double signs = 0;
  for (auto const& block : blocks) signs += static_cast<double>(block.length - 1);
  return signs;
}

void AggregateSums::add(Eigen::ArrayXd const& w) {
  Eigen::ArrayXd const weighted = aggregation_->coefficients * w;
  double squares = 0, singles = 0;
  for (auto const& [first, length] : aggregation_->blocks) {
    auto const terms = weighted.segment(first, length);
    double const sum = terms.sum();
    squares += sum * sum;
    singles += terms.square().sum();
    signs_.add_square(terms);
  }
  ratio_.add(squares, singles);
  size_.add(squares, static_cast<double>(aggregation_->blocks.size()));
}

AggregateSums& AggregateSums::operator+=(AggregateSums const& other) {
  ratio_ += other.ratio_;
  size_ += other.size_;
  signs_ += other.signs_;
  return *this;
}

VarianceRatio AggregateSums::result(double confidence) const {
  auto const squares = size_.log_interval(members_, confidence);
  return {aggregation_->scale,
          ratio_.value(),
          ratio_.log_interval(members_, confidence),
          signs_.two_sided(ratio_.a - ratio_.b),
          std::sqrt(size_.value()),
          {std::sqrt(squares.low), std::sqrt(squares.high)}};
}

}  // namespace brouwer
