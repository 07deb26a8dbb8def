#pragma once

#include <isostretch/deformation/handle_set.hpp>
#include <isostretch/deformation/sequence_options.hpp>
#include <isostretch/deformation/soft_handles.hpp>
#include <isostretch/deformation/strain.hpp>
#include <isostretch/newton/objective.hpp>

#include <string>
#include <vector>

namespace isostretch::deformation {

/// Elements of one energy.
struct Region {
  std::string name;
  std::vector<int> elements;  ///< ascending
  energies::AnyEnergy energy;
};

/// The regions of a scene, each with the elements that no earlier one has, and last what is left over, if
/// anything is. Throws Error naming the path of a region that has no element or one that does not exist.
std::vector<Region> regions_of(const SequenceOptions& options, const SolidModel& body);

/// What is minimised: a term for each region, and one for the soft handles.
class ElasticProblem {
 public:
  ElasticProblem(const SequenceOptions& options, const SolidModel& body, const HandleSet& handle_set);

  newton::Objective& objective() { return objective_; }
  const std::vector<Region>& regions() const { return regions_; }

  /// Soft handles pull to where they are at that time.
  void set_time(double time);
  /// Whether the energy is finite.
  bool admissible(const Vector& positions);
  /// Energy of the soft handles alone.
  double soft_energy(const Vector& positions);

  /// For every element: norm of the stress (first Piola-Kirchhoff), averaged over its quadrature points, and
  /// the number of its region.
  std::vector<double> stress_norms(const StrainField& strain) const;
  std::vector<double> region_numbers() const;

 private:
  std::vector<newton::SoftPin> soft_pins(double time) const;
  double stiffness_at_rest() const;

  const SolidModel& body_;
  const HandleSet& handle_set_;
  std::vector<Region> regions_;
  double soft_unit_ = 0;  ///< stiffness times volume over squared diagonal
  newton::Objective objective_;
  SoftHandles* soft_ = nullptr;
};

}  // namespace isostretch::deformation
