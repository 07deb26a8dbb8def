#include <isostretch/figures/pose.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace isostretch::figures {
namespace {

using Eigen::Vector3d;

Vector3d area_vector(const mesh::Points3& vertices, const mesh::Triangles& triangles, Eigen::Index t) {
  const Vector3d p = vertices.row(triangles(t, 0));
  return 0.5 *
         (vertices.row(triangles(t, 1)).transpose() - p).cross(vertices.row(triangles(t, 2)).transpose() - p);
}

// Mean normal (of length 1 for a flat surface, 0 for a closed one), and the areas that lie flat on the
// model's lowest coordinate, axis by axis, as shares of the whole.
struct Habit {
  Vector3d facing = Vector3d::Zero(), base = Vector3d::Zero();
};

bool lies_on(const mesh::Points3& vertices, const mesh::Triangles& triangles, Eigen::Index t, int axis,
             double height) {
  for (int c = 0; c < 3; ++c)
    if (!(vertices(triangles(t, c), axis) <= height)) return false;
  return true;
}

Habit habit_of(const mesh::Points3& vertices, const mesh::Triangles& triangles) {
  const Eigen::RowVector3d low = vertices.colwise().minCoeff();
  const Eigen::RowVector3d height = low + 0.02 * (vertices.colwise().maxCoeff() - low);
  Habit habit;
  double total = 0;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const Vector3d normal = area_vector(vertices, triangles, t);
    const double area = normal.norm();
    habit.facing += normal;
    total += area;
    for (int axis = 0; axis < 3; ++axis)
      if (-normal[axis] > 0.95 * area && lies_on(vertices, triangles, t, axis, height[axis]))
        habit.base[axis] += area;
  }
  if (total > 0) habit.facing /= total, habit.base /= total;
  return habit;
}

// A sheet that lies on the ground is looked at from above.
Pose facing_viewer(const Vector3d& facing) {
  const Vector3d toward = facing.normalized();
  const Vector3d up = std::abs(toward.y()) < 0.8 ? Vector3d::UnitY()
                      : toward.y() > 0           ? Vector3d(-Vector3d::UnitZ())
                                                 : Vector3d::UnitZ();
  return {up, (toward - toward.dot(up) * up).normalized()};
}

}  // namespace

Pose guess_pose(const mesh::Points3& vertices, const mesh::Triangles& triangles) {
  const Habit habit = habit_of(vertices, triangles);
  if (habit.facing.norm() > 0.35) return facing_viewer(habit.facing);
  if (habit.base.z() > 0.02 && habit.base.z() > 3 * habit.base.y())
    return {Vector3d::UnitZ(), -Vector3d::UnitY()};
  return {Vector3d::UnitY(), Vector3d::UnitZ()};
}

}  // namespace isostretch::figures
