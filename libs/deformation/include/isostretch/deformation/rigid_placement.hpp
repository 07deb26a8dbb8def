#pragma once

#include <isostretch/deformation/key_shapes.hpp>
#include <isostretch/deformation/rigid_motion.hpp>

#include <vector>

namespace isostretch::deformation {

/// Where shapes lie. The energy knows nothing of rigid motions, so they are treated apart, for every
/// component of the mesh. Each frame is laid onto the one before, beginning with the first pose, so that
/// nothing turns that need not. What turn is left at the end to reach the second pose is spread evenly over
/// the way, and so is the motion of the centroid. Exchanging the poses changes nothing, and a body twisted by
/// several turns has no jump, as it would have when every frame was fitted to the poses.
class RigidPlacement {
 public:
  explicit RigidPlacement(const KeyShapes& poses);

  const Vector& first() const { return first_; }
  /// Lays a shape rigidly onto another, with centroids where the first pose has them; nodes of no element go
  /// where they are there.
  Vector settled(Vector shape, const Vector& onto) const;
  /// The second pose, as near as it can be moved to a shape.
  Vector second_near(const Vector& shape) const { return settled(second_, shape); }

  /// How each component must turn from the last frame that is settled to the second pose.
  std::vector<Rotation> turns(const Vector& last) const;
  /// A settled frame in its place between the poses; at 0 and 1, the poses themselves.
  Vector placed(double t, const Vector& settled, const std::vector<Rotation>& turns) const;

  /// Weighted root mean square of the distances of the nodes.
  double distance(const Vector& a, const Vector& b) const;
  const std::vector<int>& loose_nodes() const { return loose_; }

 private:
  struct Component {
    WeightedNodes nodes;
    double share = 0;  ///< of all weight
    Place from, to;    ///< centroids of the poses
  };
  void find_components(const KeyShapes& poses);

  int dim_;
  Vector first_, second_;
  std::vector<Component> components_;
  std::vector<int> loose_;  ///< of no element
};

}  // namespace isostretch::deformation
