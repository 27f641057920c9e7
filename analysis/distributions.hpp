#pragma once

namespace brouwer {

/// The distributions of the tests and intervals, from GSL, made safe: NaN in gives NaN out, infinite statistics and
/// tails below 1e-308 give 0, and GSL's error handler (which would end the program) is off.
/// Measured against Boost.Math in 113 bits: relative error below 1e-11 wherever the p-value exceeds 1e-290 and
/// there are at most 10⁵ degrees of freedom; 2·10⁻¹⁰ beyond, up to 2·10⁷.

/// P(|T| ≥ |t|) for Student's t with `dof` ≥ 1 degrees of freedom.
double student_two_sided(double t, double dof);

/// The t that is exceeded with probability `tail`, 0 < tail < 1.
double student_upper_quantile(double tail, double dof);

/// The same of the normal law N(0, 1).
double normal_upper_quantile(double tail);

/// P(F' ≥ F) and P(F' ≤ F) for Fisher's F(m, n), each accurate in its own tail.
double fisher_upper(double F, double m, double n);
double fisher_lower(double F, double m, double n);

/// The x with P(χ²(dof) ≤ x) = p, 0 < p < 1.
double chi_squared_quantile(double p, double dof);

/// P(χ²(dof) ≥ x) and P(χ²(dof) ≤ x), dof > 0 of any size; 1 and 0 for x ≤ 0.
double chi_squared_upper(double x, double dof);
double chi_squared_lower(double x, double dof);

}  // namespace brouwer
