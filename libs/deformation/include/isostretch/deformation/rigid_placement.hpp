#pragma once

#include <isostretch/deformation/key_shapes.hpp>
#include <isostretch/deformation/rigid_motion.hpp>

#include <vector>

namespace isostretch::deformation {

/// The rigid motions of the frames between two key shapes. The energy knows nothing of them, so they are
/// treated apart, for every component of the mesh. Each frame is laid onto the one before, beginning with the
/// first key shape, so that nothing turns that need not. The rotation that is left at the end to reach the
/// second key shape is spread evenly over the way, and so is the motion of the centroid. Exchanging the key
/// shapes changes nothing, and a body twisted by several turns has no jump, as it would have when every frame
/// was fitted to the key shapes.
class RigidPlacement {
 public:
  /// Finds the components of the mesh and the centroids of both shapes.
  explicit RigidPlacement(const KeyShapes& key_shapes);

  /// Returns the positions of the first key shape.
  const Vector& first() const { return first_; }
  /// Returns a shape laid rigidly onto another, with centroids where the first key shape has them; nodes of
  /// no element go where they are there.
  Vector settled(Vector shape, const Vector& onto) const;
  /// Returns the second key shape, as near as it can be moved to a shape.
  Vector second_near(const Vector& shape) const { return settled(second_, shape); }

  /// Returns how each component must turn from the last frame that is settled to the second key shape.
  std::vector<Rotation> rotations_to_second(const Vector& last) const;
  /// Returns a settled frame in its place between the key shapes; at t = 0 and 1, the key shapes themselves.
  Vector placed(double t, const Vector& settled, const std::vector<Rotation>& rotations) const;

  /// Returns the weighted root mean square of the distances of the nodes.
  double distance(const Vector& a, const Vector& b) const;
  /// Returns the nodes of no element.
  const std::vector<int>& loose_nodes() const { return loose_; }

 private:
  struct Component {
    WeightedNodes nodes;
    double share = 0;  ///< Share of all weight.
    Place from, to;    ///< Centroids in the key shapes.
  };
  void find_components(const KeyShapes& key_shapes);

  int dim_;
  Vector first_, second_;
  std::vector<Component> components_;
  std::vector<int> loose_;  ///< Nodes of no element.
};

}  // namespace isostretch::deformation
