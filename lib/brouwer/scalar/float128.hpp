#pragma once
#include <boost/multiprecision/float128.hpp>

#include <brouwer/scalar/real.hpp>

namespace brouwer {

/// IEEE binary128: 113 bits, in software (libquadmath).
using Float128 = boost::multiprecision::float128;

}  // namespace brouwer
