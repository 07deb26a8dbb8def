#pragma once

#include <cmath>
#include <limits>

namespace isostretch::baselines {

// Notices that a method goes round in rounding: for 100 iterations the energy stayed within rounding of the
// lowest seen and the lowest gradient seen did not fall by 1 %. Neither alone would do: accelerated methods
// go up in energy for hundreds of iterations, and those that converge linearly leave energies equal long
// before the gradient has come down to its own rounding.
class Stagnation {
 public:
  // Differences of energies below noise mean nothing.
  bool found(double energy, double gradient, double noise) {
    const bool moving = !(std::abs(energy - lowest_energy_) <= 100 * noise);
    const bool flatter = gradient < 0.99 * lowest_gradient_;
    if (energy < lowest_energy_ - noise) lowest_energy_ = energy;
    if (flatter) lowest_gradient_ = gradient;
    since_ = moving || flatter ? 0 : since_ + 1;
    return since_ >= patience;
  }

 private:
  static constexpr int patience = 100;

  double lowest_energy_ = std::numeric_limits<double>::infinity();
  double lowest_gradient_ = std::numeric_limits<double>::infinity();
  int since_ = 0;
};

}  // namespace isostretch::baselines
