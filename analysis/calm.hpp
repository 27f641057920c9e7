#pragma once
#include <boost/math/policies/policy.hpp>

namespace brouwer {

/// Boost.Math's functions with this policy throw nothing where they run out of iterations or of range, and compute in
/// double.
using Calm = boost::math::policies::policy<boost::math::policies::evaluation_error<boost::math::policies::ignore_error>,
                                           boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
                                           boost::math::policies::promote_double<false>>;

}  // namespace brouwer
