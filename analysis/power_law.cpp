#include "analysis/power_law.hpp"

#include <Random123/philox.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/distributions.hpp"

namespace brouwer {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint32_t resamples = 1000;
constexpr std::uint32_t seed = 1937;  // Brouwer's law

/// Least squares with a fixed design, so that each resample costs one product with the pseudo-inverse.
class LeastSquares {
 public:
  explicit LeastSquares(Eigen::MatrixXd design) : design_(std::move(design)) {
    auto const qr = design_.colPivHouseholderQr();
    determined_ = design_.rows() >= design_.cols() && qr.rank() == design_.cols();
    if (determined_) inverse_ = qr.solve(Eigen::MatrixXd::Identity(design_.rows(), design_.rows()));
  }

  Eigen::VectorXd operator()(Eigen::VectorXd const& values) const {
    if (determined_) return inverse_ * values;
    return Eigen::VectorXd::Constant(design_.cols(), undefined);
  }

  Eigen::MatrixXd const& design() const { return design_; }

 private:
  Eigen::MatrixXd design_, inverse_;
  bool determined_ = false;
};

std::vector<Eigen::Index> nonzero_places(Eigen::RowVectorXd const& squares) {
  std::vector<Eigen::Index> places;
  for (Eigen::Index j = 0; j < squares.size(); ++j)
    if (squares[j] > 0) places.push_back(j);
  return places;
}

Eigen::VectorXd log_rms(Eigen::RowVectorXd const& squares, std::int64_t members) {
  return (squares / static_cast<double>(members)).array().log().transpose() / 2;
}

Eigen::VectorXd fit(LeastSquares const& all, Eigen::RowVectorXd const& squares, std::int64_t members) {
  auto const places = nonzero_places(squares);
  if (std::ssize(places) == squares.size()) return all(log_rms(squares, members));
  return LeastSquares(all.design()(places, Eigen::all))(log_rms(squares(places), members));
}

/// Sum of as many groups as there are, drawn with replacement.
Eigen::RowVectorXd resampled(ErrorMatrix const& squares, std::uint32_t replicate) {
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(squares.cols());
  auto const groups = static_cast<std::uint64_t>(squares.rows());
  for (std::uint32_t draw = 0; draw < groups; draw += 4) {
    auto const random = r123::Philox4x32{}({{draw, replicate, 0, 0}}, {{seed, 0}});
    for (std::uint32_t i = 0; i < 4 && draw + i < groups; ++i)
      sum += squares.row(static_cast<Eigen::Index>(random[i] * groups >> 32));
  }
  return sum;
}

/// Standard deviation of each coefficient over the resamples in which it is determined.
Eigen::ArrayXd bootstrap_sd(ErrorMatrix const& squares, std::int64_t members, LeastSquares const& law,
                            Eigen::VectorXd const& centre) {
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(centre.size()), sum_of_squares = sum;
  double used = 0;
  for (std::uint32_t replicate = 0; replicate < resamples; ++replicate) {
    Eigen::ArrayXd const off = fit(law, resampled(squares, replicate), members) - centre;
    if (!off.allFinite()) continue;
    sum += off;
    sum_of_squares += off.square();
    ++used;
  }
  if (used < 2) return Eigen::ArrayXd::Constant(centre.size(), undefined);
  return ((sum_of_squares - sum.square() / used).max(0.0) / (used - 1)).sqrt();
}

std::vector<Interval> student_intervals(Eigen::VectorXd const& centre, Eigen::ArrayXd const& sd, double dof,
                                        double confidence) {
  double const quantile = student_upper_quantile((1 - confidence) / 2, dof) * std::sqrt((dof + 1) / dof);
  std::vector<Interval> intervals;
  for (Eigen::Index k = 0; k < centre.size(); ++k)
    intervals.push_back({centre[k] - quantile * sd[k], centre[k] + quantile * sd[k]});
  return intervals;
}

}  // namespace

PowerLaw fit_power_law(ErrorMatrix const& squares, std::int64_t members, Eigen::MatrixXd const& design,
                       double confidence) {
  Eigen::RowVectorXd const total = squares.colwise().sum();
  auto const places = nonzero_places(total);
  ErrorMatrix const kept = squares(Eigen::all, places);
  LeastSquares const law(design(places, Eigen::all));
  Eigen::VectorXd const centre = law(log_rms(total(places), members));
  auto const dof = static_cast<double>(squares.rows() - 1);
  bool const resampable = dof >= 1 && centre.allFinite();
  Eigen::ArrayXd const sd =
      resampable ? bootstrap_sd(kept, members, law, centre) : Eigen::ArrayXd::Constant(centre.size(), undefined);
  return {centre, student_intervals(centre, sd, dof, confidence)};
}

double largest_magnitude(ErrorMatrix const& errors) { return errors.size() ? errors.cwiseAbs().maxCoeff() : 0; }

double exact_scale(double largest) {
  if (!(largest > 0)) return 1;
  return std::ldexp(1, std::clamp(-std::ilogb(largest), -1023, 1022));  // 2^1023 would leave no room for the inverse
}

ErrorMatrix grouped_squares(ErrorMatrix const& errors, std::int64_t members, double scale) {
  std::int64_t const groups = std::min(members, most_groups);
  ErrorMatrix sums = ErrorMatrix::Zero(groups, errors.cols());
  for (std::int64_t i = 0; i < members; ++i)
    sums.row(i * groups / members).array() += (scale * errors.row(i)).array().square();
  return sums;
}

}  // namespace brouwer
