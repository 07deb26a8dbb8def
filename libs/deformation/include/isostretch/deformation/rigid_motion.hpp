#pragma once

#include <isostretch/core/vector.hpp>

#include <Eigen/Core>

#include <vector>

namespace isostretch::deformation {

/// A point in 2D or 3D.
using Place = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
/// A rotation in 2D or 3D.
using Rotation = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

/// Some of the nodes of a vector of positions, with weights that add up to 1.
struct WeightedNodes {
  std::vector<int> nodes;       ///< Indices of nodes.
  std::vector<double> weights;  ///< A weight per node.
};

/// Returns the weighted mean of the nodes' positions.
Place centroid(const WeightedNodes& nodes, const Vector& positions, int dim);

/// Returns the rotation that, after both are moved to their centroids, takes `from` nearest to `to` in the
/// sense of weighted least squares; a true rotation, also where a reflection would fit better.
Rotation best_rotation(const WeightedNodes& nodes, const Vector& from, const Vector& to, int dim);

/// Returns the share t of a rotation, about its own axis the short way.
Rotation share_of(const Rotation& rotation, double t);

/// Moves the nodes by p -> rotation (p - from) + to.
void move(const WeightedNodes& nodes, const Rotation& rotation, const Place& from, const Place& to,
          Vector& positions);

}  // namespace isostretch::deformation
