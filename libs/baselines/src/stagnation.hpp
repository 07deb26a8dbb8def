#pragma once

#include <limits>

namespace isostretch::baselines {

// Notices that a method goes round in rounding: for 100 iterations neither the lowest energy seen fell by more
// than its rounding nor the lowest gradient by 1 %. Methods that are not monotone go up for a while, and
// those that converge linearly leave energies equal long before the gradient has reached its own rounding.
class Stagnation {
 public:
  bool found(double energy, double gradient, double noise) {
    const bool improved = energy < energy_ - noise || gradient < 0.99 * gradient_;
    if (energy < energy_ - noise) energy_ = energy;
    if (gradient < 0.99 * gradient_) gradient_ = gradient;
    since_ = improved ? 0 : since_ + 1;
    return since_ >= patience;
  }

 private:
  static constexpr int patience = 100;

  double energy_ = std::numeric_limits<double>::infinity();
  double gradient_ = std::numeric_limits<double>::infinity();
  int since_ = 0;
};

}  // namespace isostretch::baselines
