#pragma once

#include <isostretch/newton/options.hpp>
#include <isostretch/projection/filter.hpp>

namespace isostretch::newton {

// Decides how much of the filter the next Hessian gets.
//
// Clamping every negative eigenvalue costs the quadratic end phase wherever element Hessians are indefinite
// at the optimum although their sum is not, while a Hessian that fails to factorise costs up to a
// factorization. Hence: after a full step the exact Hessian is tried; if it fails, the strength that worked
// last is used, and the exact one is left alone for retry_interval steps; if it factorises but its model fits
// badly, which a short step shows, half the filter is used for as long. docs/benchmarks/flattening.md has
// what this costs and saves.
class HessianPolicy {
 public:
  explicit HessianPolicy(const Options& options) : options_(options) {}

  // The filter to try first at new positions.
  projection::FilterOptions first();
  // What to try after its factorization failed; false when nothing stronger is left.
  bool stronger(projection::FilterOptions& filter);
  // Learns from the length of an accepted step.
  void step_taken(double step);

 private:
  const Options& options_;
  double strength_ = 1.0;  // the last that worked
  double tried_ = 1.0;
  int wait_ = 0;  // steps until the exact Hessian is tried again
  bool full_step_ = false;
};

}  // namespace isostretch::newton
