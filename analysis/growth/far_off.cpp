#include "analysis/growth/far_off.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/distributions.hpp"
#include "analysis/growth/member_blocks.hpp"

namespace brouwer {
namespace {

constexpr Eigen::Index fewest_members = 8;
constexpr double few = 0.1;
constexpr double level = 0.005;
constexpr double heavy = 5;                      // degrees of freedom of the tails that are still nothing special
constexpr double heavy_quartile = 0.7266868438;  // of t(5), at 3/4: its median distance from 0

double median(std::vector<double> values) {
  auto const middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_distance(std::vector<double> values, double centre) {
  for (double& value : values) value = std::abs(value - centre);
  return median(std::move(values));
}

/// How many median distances from the median the largest of so many t(5) numbers may lie.
double bound(double numbers) { return student_upper_quantile(level / (2 * numbers), heavy) / heavy_quartile; }

struct Places {
  std::vector<double> ends, own;  ///< eᵢ(t_J)/t_J and σᵢ²
};

Places places_of(MemberBlocks const& blocks) {
  Places places;
  auto const n = static_cast<double>(blocks.times().size() - 1);
  blocks.for_each([&](MemberBlock const& block) {
    Eigen::VectorXd const own = block.rest.rowwise().squaredNorm() / n;
    places.ends.insert(places.ends.end(), block.slopes.begin(), block.slopes.end());
    places.own.insert(places.own.end(), own.begin(), own.end());
  });
  return places;
}

}  // namespace

std::vector<Eigen::Index> far_off_members(Ensemble const& ensemble, Units const& units) {
  auto const members = ensemble.errors.rows(), times = ensemble.errors.cols();
  if (members < fewest_members) return {};
  auto const [ends, own] = places_of(MemberBlocks(ensemble, units, times));
  auto const M = static_cast<double>(members), n = static_cast<double>(times - 1);
  double const centre = median(ends), furthest = bound(M) * median_distance(ends, centre);
  if (!(furthest > 0)) return {};
  // t(5) increments of standard deviation 1 have the quartile 0.7267·√(3/5)
  double const increment = n > 0 ? bound(M * n) * heavy_quartile * std::sqrt(3.0 / 5) : 0;
  double const typical =
      n > 0 ? median(own) / (1 - 2 / (3 * n)) : 0;  // the median of a sum of squares is below its mean
  double const largest = typical * (1 + increment * increment / n);
  std::vector<Eigen::Index> found;
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (std::abs(ends[i] - centre) > furthest || (largest > 0 && own[i] > largest))
      found.push_back(static_cast<Eigen::Index>(i));
  return found;
}

bool are_few(std::size_t far_off, Eigen::Index members) {
  return far_off == 1 || static_cast<double>(far_off) <= few * static_cast<double>(members);
}

std::vector<std::string> names_of(Ensemble const& ensemble, std::vector<Eigen::Index> const& rows) {
  std::vector<std::string> names;
  for (auto const row : rows)
    names.push_back(ensemble.names.empty() ? std::to_string(row) : ensemble.names[static_cast<std::size_t>(row)]);
  return names;
}

Ensemble without(Ensemble const& ensemble, std::vector<Eigen::Index> const& rows) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < ensemble.errors.rows(); ++i)
    if (!std::binary_search(rows.begin(), rows.end(), i)) kept.push_back(i);
  Ensemble rest = ensemble;
  rest.errors = ErrorMatrix(ensemble.errors(kept, Eigen::all));
  rest.names = names_of(ensemble, kept);
  return rest;
}

}  // namespace brouwer
