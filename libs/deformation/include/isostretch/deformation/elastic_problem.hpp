#pragma once

#include <isostretch/deformation/handle_set.hpp>
#include <isostretch/deformation/sequence_options.hpp>
#include <isostretch/deformation/soft_handles.hpp>
#include <isostretch/deformation/strain.hpp>
#include <isostretch/newton/objective.hpp>

#include <string>
#include <vector>

namespace isostretch::deformation {

/// A set of elements with one energy.
struct Region {
  std::string name;            ///< Name in the scene.
  std::vector<int> elements;   ///< Indices of elements, ascending.
  energies::AnyEnergy energy;  ///< Energy of the elements.
};

/// Returns the regions of a scene, each with the elements that no earlier one has, and last what is left
/// over, if anything is. Throws Error naming the path of a region that has no element or one that does not
/// exist.
std::vector<Region> regions_of(const SequenceOptions& options, const SolidModel& body);

/// The minimisation problem of a sequence: a term for each region, and one for the soft handles.
class ElasticProblem {
 public:
  /// Makes the terms. The body and the handle set must outlive this object. Throws Error naming the region at
  /// fault.
  ElasticProblem(const SequenceOptions& options, const SolidModel& body, const HandleSet& handle_set);

  /// Returns the objective, over dim entries per node.
  newton::Objective& objective() { return objective_; }
  /// Returns the regions of the body.
  const std::vector<Region>& regions() const { return regions_; }

  /// Moves the targets of soft handles to where they are at that time.
  void set_time(double time);
  /// Returns whether the energy is finite.
  bool feasible(const Vector& positions);
  /// Returns the energy of the soft handles alone.
  double soft_energy(const Vector& positions);

  /// Returns for every element the norm of the first Piola-Kirchhoff stress, averaged over its quadrature
  /// points.
  std::vector<double> stress_norms(const StrainField& strain) const;
  /// Returns for every element the number of its region.
  std::vector<double> region_numbers() const;

 private:
  std::vector<newton::SoftPin> soft_pins(double time) const;
  double stiffness_at_rest() const;

  const SolidModel& body_;
  const HandleSet& handle_set_;
  std::vector<Region> regions_;
  double soft_unit_ = 0;  ///< Stiffness times volume over squared diagonal.
  newton::Objective objective_;
  SoftHandles* soft_ = nullptr;
};

}  // namespace isostretch::deformation
