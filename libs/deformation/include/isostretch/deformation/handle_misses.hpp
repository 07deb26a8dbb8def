#pragma once

#include <isostretch/deformation/handle_set.hpp>
#include <isostretch/deformation/strain.hpp>

#include <string>
#include <vector>

namespace isostretch::deformation {

/// How far the nodes of one handle are from where they are to be, in units of the mesh.
struct HandleMiss {
  std::string name;
  bool soft = false;
  std::size_t nodes = 0;
  double size =
      0;  ///< of the handle where it is to be: twice the largest distance from the mean; 0: one node
  double size_reached = 0;  ///< the same of where it is
  double mean = 0;          ///< distance of a node from its target
  double largest = 0;
  int farthest_node = -1;

  /// The largest miss as a share of the size; NaN for a handle of one node.
  double share() const;
};

/// Measures every handle of the handle_set at that time.
std::vector<HandleMiss> handle_misses(const HandleSet& handle_set, double time, int dim,
                                      const Vector& positions);

/// "handles miss their targets by 0.05 at most (50 % of the size of 'disc')"; empty where no handle has a
/// node, or none misses by more than rounding.
std::string largest_miss_text(const std::vector<HandleMiss>& misses, double diagonal);

/// Says of each handle that misses by more than a tenth of its size, or by more than a fiftieth of the body's
/// diagonal, how far it is off, and whether it has collapsed; empty where none does.
std::vector<std::string> miss_warnings(const std::vector<HandleMiss>& misses, double diagonal);

/// The elements whose volume has shrunk below a thousandth without being inverted, flattest first.
std::vector<int> nearly_flat_elements(const StrainField& strain);

/// Names the flattest of them and counts them; empty where there are none.
std::string nearly_flat_text(const std::vector<int>& elements, const StrainField& strain,
                             const SolidModel& body);

}  // namespace isostretch::deformation
