#pragma once
#include <brouwer/scalar/double_double.hpp>
#include <brouwer/scalar/wider.hpp>

namespace brouwer {

/// The arithmetic in which the first integrals of a state of T are formed before their error is rounded to double: wide
/// enough for the error of a sum of products of T to be right to its last digits, and, where T runs in packs, one that
/// runs in packs too, so that observing costs little beside a step. Double-double for double; Wider<T> elsewhere.
template <class T>
struct ObservingOf {
  using type = Wider<T>;
};
template <>
struct ObservingOf<double> {
  using type = DoubleDouble<double>;
};
template <int N>
struct ObservingOf<Pack<double, N>> {
  using type = DoubleDouble<Pack<double, N>>;
};

template <class T>
using Observing = typename ObservingOf<T>::type;

}  // namespace brouwer
