#include "analysis/increments/free_increments.hpp"

namespace brouwer {

FreeIncrements::FreeIncrements(Eigen::ArrayXd const& times) {
  auto const before = times.head(times.size() - 1), now = times.tail(times.size() - 1);
  relative_ = (now - before) / before;
  weight_ = (relative_ * now).rsqrt();
}

}  // namespace brouwer
