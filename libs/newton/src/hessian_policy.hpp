#pragma once

#include <isostretch/newton/options.hpp>
#include <isostretch/projection/filter.hpp>

namespace isostretch::newton {

// Decides how much of the filter the next Hessian gets.
class HessianPolicy {
 public:
  explicit HessianPolicy(const Options& options) : options_(options) {}

  // The filter to try first in this iteration.
  projection::FilterOptions first();
  // What to try after a factorization failed; false when nothing stronger is left.
  bool stronger(projection::FilterOptions& filter);
  // Learns from an accepted step: its length, and the gain in energy over what the quadratic model promised.
  void step_taken(double step, double gain_ratio);

 private:
  const Options& options_;
  double strength_ = 1.0;
  double last_used_ = 1.0;
  bool failed_ = false;
  int wait_ = 0;
};

}  // namespace isostretch::newton
