#pragma once
#include <Eigen/Core>

namespace brouwer {

/// What Eigen asks of a scalar of ours, a real number whose operations cost so much: the base of its Eigen::NumTraits.
template <class T, int read, int add, int multiply>
struct EigenTraits : Eigen::GenericNumTraits<T> {
  using Real = T;
  using NonInteger = T;
  using Nested = T;
  using Literal = T;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = read,
    AddCost = add,
    MulCost = multiply
  };
};

}  // namespace brouwer
