#include "analysis/increments/autocorrelation.hpp"

namespace brouwer {

void LagSums::add(Eigen::ArrayXd const& w, double squares) {
  auto const pairs = w.size() - lag_;
  Eigen::ArrayXd const products = w.head(pairs) * w.tail(pairs);
  ratio_.add(products.sum(), squares);
  signs_.add_sum(products);
}

LagSums& LagSums::operator+=(LagSums const& other) {
  ratio_ += other.ratio_;
  signs_ += other.signs_;
  return *this;
}

Autocorrelation LagSums::result(double confidence) const {
  double const share = static_cast<double>(length_) / static_cast<double>(length_ - lag_);
  auto const [low, high] = ratio_.interval(members_, confidence);
  return {lag_, share * ratio_.value(), {share * low, share * high}, signs_.two_sided(ratio_.a)};
}

}  // namespace brouwer
