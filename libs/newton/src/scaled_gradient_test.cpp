#include "scaled_gradient_test.hpp"

#include <isostretch/newton/positions.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::newton {

double ScaledGradientTest::energy_noise(const Vector& x) const {
  constexpr double relative = 2e-14;
  Objective& objective = system_.objective();
  const double subtracted =
      objective.has_exact_changes() ? objective.value_without_exact(x).value : summary_.energy;
  return std::max(relative * std::abs(subtracted), rounding_of_positions(x));
}

// Energy of moving every node to and fro in its last digits.
double ScaledGradientTest::rounding_of_positions(const Vector& x) const {
  const double length = rounding_length(x, system_.objective().dim());
  return system_.size() * system_.typical_stiffness() * length * length;
}

bool ScaledGradientTest::passes(const Vector& x) {
  const double scale = system_.typical_stiffness() * bounding_box_diagonal(x, system_.objective().dim());
  awaits_decrement_ = options_.scaled_gradient_tolerance > 0 &&
                      summary_.gradient_inf_norm <= options_.scaled_gradient_tolerance * scale;
  return passes_with(last_decrement_, x);
}

bool ScaledGradientTest::promises_little(double decrement, const Vector& x) const {
  constexpr double share = 1e-8, share_if_filtered = 1e-12, negligible = 1e-12;
  return decrement <=
         (exact_model_ ? share : share_if_filtered) *
                 std::max(std::abs(summary_.energy), negligible * std::abs(summary_.initial_energy)) +
             rounding_of_positions(x);
}

}  // namespace isostretch::newton
