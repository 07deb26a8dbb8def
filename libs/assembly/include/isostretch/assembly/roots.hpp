#pragma once

namespace isostretch::assembly {

/// Smallest positive root of a polynomial that is positive at zero, coefficients in ascending order;
/// +infinity when there is none. Errs on the small side: the polynomial is positive on [0, result) up to the
/// rounding of its evaluation. No cancellation in the quadratic; the cubic is bracketed between its critical
/// points, so that nearly double roots, as slivers have them, are not missed by a closed formula.
double smallest_positive_root_quadratic(double c0, double c1, double c2);
double smallest_positive_root_cubic(double c0, double c1, double c2, double c3);

}  // namespace isostretch::assembly
