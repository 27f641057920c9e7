#pragma once
#include <string>
#include <type_traits>
#include <vector>

#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/error.hpp>
#include <brouwer/scalar/double_double.hpp>
#include <brouwer/scalar/float128.hpp>
#include <brouwer/scalar/modelled.hpp>
#include <brouwer/scalar/mpfr.hpp>

namespace brouwer {

/// A name for a scalar type.
template <class T>
struct NamedArithmetic {
  using type = T;
  char const* name;
  char const* summary;
};

// Calls visit(NamedArithmetic<T>) for every arithmetic of the catalogue: the table of scalars, written once. In two
// parts, because each is compiled by itself: those that the processor computes, and those that a library does.

struct HardwareArithmetics {
  template <class Visit>
  static void for_each(Visit visit) {
    visit(NamedArithmetic<float>{"float", "IEEE binary32"});
    visit(NamedArithmetic<double>{"double", "IEEE binary64"});
    visit(NamedArithmetic<long double>{"long-double", "x87 extended: 80 bits with a significand of 64"});
    visit(NamedArithmetic<DoubleDouble<double>>{"double-double", "unevaluated sum of two doubles"});
  }
};

struct SoftwareArithmetics {
  template <class Visit>
  static void for_each(Visit visit) {
    visit(NamedArithmetic<Float128>{"float128", "IEEE binary128 in software (libquadmath)"});
    visit(NamedArithmetic<Mpfr<128>>{"mpfr-128", "MPFR, every operation correctly rounded"});
    visit(NamedArithmetic<Mpfr<256>>{"mpfr-256", "MPFR, every operation correctly rounded"});
    visit(NamedArithmetic<Mpfr<512>>{"mpfr-512", "MPFR, every operation correctly rounded"});
  }
};

struct AllArithmetics {
  template <class Visit>
  static void for_each(Visit visit) {
    HardwareArithmetics::for_each(visit);
    SoftwareArithmetics::for_each(visit);
  }
};

/// The arithmetics in which operations follow other rules than the processor's.
struct ModelledArithmetics {
  template <class Visit>
  static void for_each(Visit visit) {
    visit(NamedArithmetic<Modelled<float>>{"float", "IEEE binary32, operations by rule"});
    visit(NamedArithmetic<Modelled<double>>{"double", "IEEE binary64, operations by rule"});
  }
};

/// Calls visit(NamedArithmetic<T>) for the arithmetic of that name; nothing happens where there is none.
template <class Arithmetics = AllArithmetics, class Visit>
void for_arithmetic(std::string const& name, Visit visit) {
  Arithmetics::for_each([&](auto arithmetic) {
    if (name == arithmetic.name) visit(arithmetic);
  });
}

/// The packs of an arithmetic in two registers of so many bytes, each of which fills the time in which the other waits for
/// results; or T where it has none.
template <class T, int bytes>
struct PackOf {
  using type = T;
};
template <int bytes>
struct PackOf<float, bytes> {
  using type = Pack<float, 2 * bytes / 4>;
};
template <int bytes>
struct PackOf<double, bytes> {
  using type = Pack<double, 2 * bytes / 8>;
};
template <int bytes>
struct PackOf<DoubleDouble<double>, bytes> {
  using type = DoubleDouble<Pack<double, 2 * bytes / 8>>;
};

}  // namespace brouwer
