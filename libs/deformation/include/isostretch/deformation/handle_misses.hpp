#pragma once

#include <isostretch/deformation/handle_set.hpp>
#include <isostretch/deformation/strain.hpp>

#include <string>
#include <vector>

namespace isostretch::deformation {

/// The distances of the nodes of one handle from their targets, in units of the mesh.
struct HandleMiss {
  std::string name;       ///< Name of the handle.
  bool soft = false;      ///< Whether the handle is soft.
  std::size_t nodes = 0;  ///< Number of its nodes.
  /// Size of the handle at its targets: twice the largest distance from the mean; 0 for one node.
  double size = 0;
  double size_reached = 0;  ///< Size of the handle where its nodes are.
  double mean = 0;          ///< Mean distance of a node from its target.
  double largest = 0;       ///< Largest distance of a node from its target.
  int farthest_node = -1;   ///< Node of the largest distance.

  /// Returns the largest miss as a share of the size; NaN for a handle of one node.
  double share() const;
};

/// Returns the misses of every handle at a time; `positions` has dim entries per node.
std::vector<HandleMiss> handle_misses(const HandleSet& handle_set, double time, int dim,
                                      const Vector& positions);

/// Returns a sentence such as "handles miss their targets by 0.05 at most (50 % of the size of 'disc')";
/// empty where no handle has a node, or none misses by more than rounding. `diagonal` is that of the body.
std::string largest_miss_text(const std::vector<HandleMiss>& misses, double diagonal);

/// Returns for each handle that misses by more than a tenth of its size, or by more than a fiftieth of the
/// body's diagonal, how far it is off, and whether it has collapsed; none where no handle does.
std::vector<std::string> miss_warnings(const std::vector<HandleMiss>& misses, double diagonal);

/// Returns the elements whose volume has shrunk below a thousandth without being inverted, flattest first.
std::vector<int> nearly_flat_elements(const StrainField& strain);

/// Returns a text that names the flattest of the elements and counts them; empty where there are none.
std::string nearly_flat_text(const std::vector<int>& elements, const StrainField& strain,
                             const SolidModel& body);

}  // namespace isostretch::deformation
