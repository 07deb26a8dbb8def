#pragma once

#include "process.hpp"
#include "scratch.hpp"

#include <isostretch/mesh/generators.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace isostretch::test {

// isostretch-interpolate with these arguments.
inline Outcome interpolate(std::vector<std::string> arguments,
                           const std::function<void(int)>& meanwhile = {}) {
  arguments.insert(arguments.begin(), program("interpolate"));
  return run(arguments, meanwhile);
}

inline mesh::TetMesh straight_bar(int cells = 12) {
  return mesh::tet_bar(cells, 3, 3, 4, 1, 1);
}

// Turned about its long axis by so many radians at the far end, and then rolled up to an arc of so many.
inline mesh::TetMesh twisted_and_bent(mesh::TetMesh bar, double twist, double bend) {
  constexpr double length = 4;
  for (Eigen::Index v = 0; v < bar.vertices.rows(); ++v) {
    const double x = bar.vertices(v, 0), y = bar.vertices(v, 1) - 0.5, z = bar.vertices(v, 2) - 0.5;
    const double c = std::cos(twist * x / length), s = std::sin(twist * x / length);
    const double up = c * y - s * z, aside = s * y + c * z;
    if (bend == 0) {
      bar.vertices.row(v) << x, up, aside;
      continue;
    }
    const double radius = length / bend, angle = x / radius;
    bar.vertices.row(v) << (radius - up) * std::sin(angle), radius - (radius - up) * std::cos(angle), aside;
  }
  return bar;
}

// By an angle about (1, 2, 2), and away.
inline mesh::TetMesh moved(mesh::TetMesh mesh, double angle) {
  const double a = 1.0 / 3, b = 2.0 / 3, s = std::sin(angle), c = std::cos(angle);
  const Eigen::Matrix3d cross{{0, -b, b}, {b, 0, -a}, {-b, a, 0}};
  const Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity() + s * cross + (1 - c) * cross * cross;
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    const Eigen::Vector3d p = mesh.vertices.row(v).transpose();
    mesh.vertices.row(v) = (rotation * p + Eigen::Vector3d(3, -2, 5)).transpose();
  }
  return mesh;
}

}  // namespace isostretch::test
