#pragma once

#include <isostretch/deformation/interpolation_options.hpp>
#include <isostretch/deformation/key_shapes.hpp>
#include <isostretch/energies/any_energy.hpp>
#include <isostretch/newton/objective.hpp>

#include <array>
#include <vector>

namespace isostretch::deformation {

/// Throws Error when the minimum of the energy is not at rest: then the first and the last shape would not be
/// the two given.
void require_least_at_rest(const energies::AnyEnergy& energy, int dim);

/// The energy (1 - t) psi_1 + t psi_2 of an interpolation, where each key shape is the rest shape of one.
class ShapeEnergy {
 public:
  /// Makes the terms of both energies. Nodes in `held` belong to no element and stay.
  ShapeEnergy(const KeyShapes& key_shapes, const energies::AnyEnergy& energy, const std::vector<int>& held);

  /// Returns the objective, over dim entries per node.
  newton::Objective& objective() { return objective_; }
  /// Sets the time t, 0 to 1.
  void set_time(double t);
  /// Returns the energy at the time that is set; +infinity outside the domain.
  double value(const Vector& positions) { return objective_.value(positions).value; }
  /// Returns psi_1 and psi_2, each above its value at rest.
  std::array<double, 2> parts(const Vector& positions);

 private:
  newton::Objective objective_;
  std::array<newton::EnergyTerm*, 2> terms_;
  std::array<double, 2> at_rest_;
  double time_ = 0;
};

}  // namespace isostretch::deformation
