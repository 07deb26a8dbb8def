#pragma once

#include <isostretch/mesh/types.hpp>

namespace isostretch::figures {

/// The orientation of a model: orthogonal vectors of length 1.
struct Pose {
  /// The direction up.
  Eigen::Vector3d up, front;  ///< The direction towards the viewer.
  /// Returns the direction to the right.
  Eigen::Vector3d right() const {
    return {up.y() * front.z() - up.z() * front.y(), up.z() * front.x() - up.x() * front.z(),
            up.x() * front.y() - up.y() * front.x()};
  }
};

/// Returns the orientation of a model, guessed from it alone. y is up and z towards the viewer, as most
/// models have it, except where the model rests on a flat base of constant z; an open surface that faces
/// somewhere, as a mask does, is seen from there.
Pose guess_pose(const mesh::Points3& vertices, const mesh::Triangles& triangles);

}  // namespace isostretch::figures
