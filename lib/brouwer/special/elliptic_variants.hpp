#pragma once
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <concepts>

#include <brouwer/scalar/double_double.hpp>
#include <brouwer/special/elliptic.hpp>

namespace brouwer {

// Whose F(φ, k) and sn, cn, dn(u, k) an integrator calls. The variant is a factor of a study: it changes the bits.
// advanced(s, c, v, k): sn, cn, dn of F(arctan(s/c), k) + v, the arc tangent in the quadrant of the point (c, s).
// Each has `exists_in<T>`. k lies in [0, 1]; beyond it the value is unspecified, but a variant neither throws nor aborts.

/// This library's functions; any Real.
struct OwnElliptic {
  template <class T>
  static constexpr bool exists_in = true;

  template <Real T>
  static T f(T const& phi, T const& k) {
    return elliptic_f(phi, k);
  }
  template <Real T>
  static Jacobi<T> jacobi(T const& u, T const& k) {
    return jacobi_elliptic(u, k);
  }
  template <Real T>
  static Jacobi<T> advanced(T const& s, T const& c, T const& v, T const& k) {
    return jacobi_advanced(s, c, v, k);
  }
};

/// GSL's (Carlson's R_F; Bulirsch's sncndn); double only.
struct GslElliptic {
  template <class T>
  static constexpr bool exists_in = std::same_as<T, double>;

  static double f(double phi, double k) {
    keep_calm();
    gsl_sf_result result;
    bool const good = gsl_sf_ellint_F_e(phi, k, GSL_PREC_DOUBLE, &result) == GSL_SUCCESS;
    return good ? result.val : std::numeric_limits<double>::quiet_NaN();
  }
  static Jacobi<double> jacobi(double u, double k) {
    keep_calm();
    Jacobi<double> j{};
    if (gsl_sf_elljac_e(u, k * k, &j.sn, &j.cn, &j.dn) == GSL_SUCCESS) return j;
    double const nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan};
  }
  static Jacobi<double> advanced(double s, double c, double v, double k) {
    return jacobi(f(arctangent(s, c), k) + v, k);
  }

 private:
  /// GSL's default is to abort the program; once for the process.
  static void keep_calm() { [[maybe_unused]] static auto const former = gsl_set_error_handler_off(); }
};

/// Boost.Math's; every scalar but packs, double-double and Float128 (whose numeric_limits in Boost 1.81, which Boost.Math asks, do not
/// compile in strict C++).
struct BoostElliptic {
  template <class T>
  static constexpr bool exists_in = detail::Floating<T> && !std::same_as<T, Float128>;

  using Policy =
      boost::math::policies::policy<boost::math::policies::domain_error<boost::math::policies::ignore_error>,
                                    boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
                                    boost::math::policies::evaluation_error<boost::math::policies::ignore_error>,
                                    boost::math::policies::promote_float<false>,
                                    boost::math::policies::promote_double<false>>;

  template <Real T>
  static T f(T const& phi, T const& k) {
    return inside(phi, k) ? boost::math::ellint_1(k, phi, Policy()) : std::numeric_limits<T>::quiet_NaN();
  }
  template <Real T>
  static Jacobi<T> jacobi(T const& u, T const& k) {
    T const nan = std::numeric_limits<T>::quiet_NaN();
    if (!inside(u, k)) return {nan, nan, nan};
    Jacobi<T> j{};
    j.sn = boost::math::jacobi_elliptic(k, u, &j.cn, &j.dn, Policy());
    return j;
  }
  template <Real T>
  static Jacobi<T> advanced(T const& s, T const& c, T const& v, T const& k) {
    return jacobi(T(f(arctangent(s, c), k) + v), k);
  }

 private:
  /// Boost.Math 1.81 recurses without end for a modulus that is not a number.
  template <Real T>
  static bool inside(T const& u, T const& k) {
    using math::abs;
    return k >= T(0) && k <= T(1) && abs(u) <= T(1) / (epsilon<T>() * epsilon<T>());
  }
};

}  // namespace brouwer
