#pragma once

namespace isostretch::assembly {

/// Returns the smallest positive root of c0 + c1 t + c2 t^2 with c0 > 0; +infinity when there is none. Errs
/// on the small side: the polynomial is positive on [0, result) up to the rounding of its evaluation, and
/// nothing cancels.
double smallest_positive_root_quadratic(double c0, double c1, double c2);
/// Returns the smallest positive root of c0 + c1 t + c2 t^2 + c3 t^3 with c0 > 0; +infinity when there is
/// none. Errs on the small side: the polynomial is positive on [0, result) up to the rounding of its
/// evaluation. The root is bracketed between critical points, so that nearly double roots, as slivers have
/// them, are not missed by a closed formula.
double smallest_positive_root_cubic(double c0, double c1, double c2, double c3);

}  // namespace isostretch::assembly
