#pragma once

// Generated meshes as elements, and positions of their vertices away from rest.
#include <isostretch/assembly/elements.hpp>
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>

#include <Eigen/Core>

#include <random>

namespace isostretch::tests {

inline assembly::Elements triangles(int n) {
  const mesh::SurfaceMesh grid = mesh::grid(n, n, 1.0, 1.0);
  return assembly::elements_from(mesh::flat_elements(grid));
}

inline assembly::Elements tets() {
  return assembly::elements_from(mesh::elements(mesh::tet_bar(3, 2, 2, 1.5, 1.0, 1.0)));
}

// Rest positions, recovered by solving for nodes is not needed: a random smooth map of generated meshes will
// do.
inline Eigen::VectorXd planar_positions(int n, double noise, unsigned seed) {
  const mesh::SurfaceMesh grid = mesh::grid(n, n, 1.0, 1.0);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-noise, noise);
  Eigen::VectorXd x(2 * grid.vertices.rows());
  for (Eigen::Index i = 0; i < grid.vertices.rows(); ++i)
    for (int d = 0; d < 2; ++d) x[2 * i + d] = 1.3 * grid.vertices(i, d) + uniform(generator);
  return x;
}

inline Eigen::VectorXd solid_positions(double noise, unsigned seed) {
  const mesh::TetMesh bar = mesh::tet_bar(3, 2, 2, 1.5, 1.0, 1.0);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-noise, noise);
  Eigen::VectorXd x(3 * bar.vertices.rows());
  for (Eigen::Index i = 0; i < bar.vertices.rows(); ++i)
    for (int d = 0; d < 3; ++d) x[3 * i + d] = 1.1 * bar.vertices(i, d) + uniform(generator);
  return x;
}

}  // namespace isostretch::tests
