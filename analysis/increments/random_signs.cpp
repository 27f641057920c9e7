#include "analysis/increments/random_signs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/increments/pearson.hpp"

namespace brouwer {
namespace {

using Values = std::vector<double>;

constexpr std::size_t most_values = 256;  ///< of the largest terms together
constexpr double rounding = 1e-9;         ///< of a sum, in standard deviations: nearer ones are equal

/// All sums of one of these and one of those.
Values sums(Values const& these, Values const& those) {
  Values all;
  for (double const a : these)
    for (double const b : those) all.push_back(a + b);
  return all;
}

}  // namespace

RandomSigns::Cumulants& RandomSigns::Cumulants::operator+=(Cumulants const& other) {
  second += other.second;
  third += other.third;
  fourth += other.fourth;
  return *this;
}

RandomSigns::Cumulants& RandomSigns::Cumulants::operator-=(Cumulants const& other) {
  return *this += {-other.second, -other.third, -other.fourth};
}

RandomSigns::Cumulants RandomSigns::of_square(Eigen::Ref<Eigen::ArrayXd const> const& a) {
  double s2 = 0, s4 = 0, s6 = 0, s8 = 0;
  for (double const term : a) {
    double const squared = term * term, fourth = squared * squared;
    s2 += squared;
    s4 += fourth;
    s6 += squared * fourth;
    s8 += fourth * fourth;
  }
  double const q = s2 * s2;
  return {2 * (q - s4), 8 * q * s2 - 24 * s2 * s4 + 16 * s6,
          48 * q * q - 288 * q * s4 + 128 * s4 * s4 + 384 * s2 * s6 - 272 * s8};
}

Values RandomSigns::Term::values() const {
  Values found = square ? Values{a[0]} : Values{-a[0], a[0]};  // the sign of a square's first does not matter
  for (Eigen::Index k = 1; k < a.size(); ++k) found = sums(found, {-a[k], a[k]});
  if (square)
    for (auto& value : found) value = value * value - a.square().sum();
  return found;
}

void RandomSigns::add_sum(Eigen::ArrayXd const& a) {
  Eigen::ArrayXd const squared = a.square();
  cumulants_ += {squared.sum(), 0, -2 * squared.square().sum()};
  if (!few_) return;
  for (double const term : a)
    terms_.push_back({{term * term, 0, -2 * term * term * term * term}, Eigen::ArrayXd::Constant(1, term), false});
}

void RandomSigns::add_square(Eigen::Ref<Eigen::ArrayXd const> const& a) {
  auto const cumulants = of_square(a);
  cumulants_ += cumulants;
  if (few_) terms_.push_back({cumulants, a, true});
}

RandomSigns& RandomSigns::operator+=(RandomSigns const& other) {
  cumulants_ += other.cumulants_;
  terms_.insert(terms_.end(), other.terms_.begin(), other.terms_.end());
  return *this;
}

/// All values of the largest terms together, and the cumulants of the others.
struct RandomSigns::Split {
  Values counted = {0};
  Cumulants rest;
  double scale = 1;

  /// P(sum ≤ x) and P(sum ≥ x).
  BothTails tails(double x) const {
    BothTails mean{0, 0};
    double const share = 1 / static_cast<double>(counted.size());
    for (double const value : counted) {
      auto const [lower, upper] = of_rest(x - value);
      mean.lower += share * lower;
      mean.upper += share * upper;
    }
    return mean;
  }

 private:
  BothTails of_rest(double x) const {
    double const near = rounding * scale, deviation = std::sqrt(std::max(rest.second, 0.0));
    if (rest.second <= near * scale) return {x >= -near ? 1.0 : 0.0, x <= near ? 1.0 : 0.0};  // what rounding has left
    return pearson_tails(x / deviation, rest.third / (rest.second * deviation),
                         rest.fourth / (rest.second * rest.second));
  }
};

RandomSigns::Split RandomSigns::split() const {
  Split made;
  made.rest = cumulants_;
  made.scale = std::sqrt(cumulants_.second);
  auto terms = terms_;
  std::sort(terms.begin(), terms.end(),
            [](Term const& a, Term const& b) { return a.cumulants.second > b.cumulants.second; });
  for (auto const& term : terms) {
    auto const choices = std::exp2(static_cast<double>(term.a.size()) - (term.square ? 1 : 0));
    if (static_cast<double>(made.counted.size()) * choices > most_values) break;
    made.counted = sums(made.counted, term.values());
    made.rest -= term.cumulants;
  }
  return made;
}

double RandomSigns::two_sided(double x) const {
  if (!(cumulants_.second > 0)) return std::numeric_limits<double>::quiet_NaN();
  auto const [lower, upper] = split().tails(x);
  return std::clamp(2 * std::min(lower, upper), std::exp2(1 - signs_), 1.0);
}

}  // namespace brouwer
