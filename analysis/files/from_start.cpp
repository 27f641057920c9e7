#include "analysis/files/from_start.hpp"

#include <fmt/format.h>

#include <brouwer/error.hpp>

namespace brouwer {
namespace {

void require_nonzero(Eigen::VectorXd const& start, std::string const& where) {
  for (Eigen::Index member = 0; member < start.size(); ++member)
    if (start[member] == 0)
      throw InputError(
          fmt::format("{}: the {}. member begins with the value 0, and nothing can be relative to that; "
                      "--subtract-start takes the difference alone",
                      where, member + 1));
}

}  // namespace

void count_from_start(Ensemble& ensemble, FileValues values, std::string const& where) {
  if (values == FileValues::errors) return;
  auto const later = ensemble.errors.cols() - 1;
  if (later < 2)
    throw InputError(
        fmt::format("{}: a law of growth needs values at the start and at 2 or more times after it", where));
  Eigen::VectorXd const start = ensemble.errors.col(0);
  ErrorMatrix errors = ensemble.errors.rightCols(later).colwise() - start;
  if (values == FileValues::relative_to_start) {
    require_nonzero(start, where);
    errors.array().colwise() /= start.array().abs();
  }
  ensemble.errors = std::move(errors);
  double const first = ensemble.times.front();
  ensemble.times.erase(ensemble.times.begin());
  for (double& time : ensemble.times) time -= first;
}

}  // namespace brouwer
