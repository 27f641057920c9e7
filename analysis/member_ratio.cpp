#include "analysis/member_ratio.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/distributions.hpp"

namespace brouwer {

void MemberRatio::add(double member_a, double member_b) {
  a += member_a;
  b += member_b;
  aa += member_a * member_a;
  ab += member_a * member_b;
  bb += member_b * member_b;
}

MemberRatio& MemberRatio::operator+=(MemberRatio const& other) {
  a += other.a;
  b += other.b;
  aa += other.aa;
  ab += other.ab;
  bb += other.bb;
  return *this;
}

double MemberRatio::half_width(std::int64_t members, double confidence) const {
  auto const m = static_cast<double>(members);
  double const r = value(), squares = std::max(0.0, aa - 2 * r * ab + r * r * bb);
  return student_upper_quantile((1 - confidence) / 2, m - 1) * std::sqrt(m / (m - 1) * squares) / std::abs(b);
}

Interval MemberRatio::interval(std::int64_t members, double confidence) const {
  double const half = half_width(members, confidence);
  return {value() - half, value() + half};
}

Interval MemberRatio::log_interval(std::int64_t members, double confidence) const {
  double const factor = std::exp(half_width(members, confidence) / value());
  return {value() / factor, value() * factor};
}

}  // namespace brouwer
