#pragma once

#include <isostretch/mesh/types.hpp>

namespace isostretch::figures {

/// How a model stands: orthogonal, of length 1.
struct Pose {
  Eigen::Vector3d up, front;
  Eigen::Vector3d right() const {
    return {up.y() * front.z() - up.z() * front.y(), up.z() * front.x() - up.x() * front.z(),
            up.x() * front.y() - up.y() * front.x()};
  }
};

/// Guessed from the model alone. y is up and z towards the viewer, as most models have it, except where the
/// model rests on a flat base of constant z; an open surface that faces somewhere, as a mask does, is seen
/// from there.
Pose guess_pose(const mesh::Points3& vertices, const mesh::Triangles& triangles);

}  // namespace isostretch::figures
