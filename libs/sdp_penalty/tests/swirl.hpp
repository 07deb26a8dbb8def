#pragma once

// Procedural scenes of the inversion-free problem, for tests and benchmarks.
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

#include <algorithm>
#include <cmath>

namespace isostretch::tests {

// A square whose boundary is held while a patch in the middle turns: ex-rotations fall off with the distance.
inline sdp_penalty::Problem swirl(int n, double degrees) {
  const mesh::SurfaceMesh grid = mesh::grid(n, n);
  sdp_penalty::Problem problem;
  const mesh::Points2 flat = grid.vertices.leftCols<2>();
  problem.elements = assembly::elements_from(mesh::elements(flat, grid.triangles));
  problem.weights = sdp_penalty::volume_weights(problem.elements);
  const auto angle_at = [&](double x, double y) {
    const double r = std::hypot(x - 0.5, y - 0.5);
    return degrees * std::acos(-1.0) / 180 * std::clamp((0.5 - r) / 0.35, 0.0, 1.0);
  };
  for (int f = 0; f < grid.triangles.rows(); ++f) {
    double x = 0, y = 0;
    for (int k = 0; k < 3; ++k)
      x += flat(grid.triangles(f, k), 0) / 3, y += flat(grid.triangles(f, k), 1) / 3;
    const double c = std::cos(angle_at(x, y)), s = std::sin(angle_at(x, y));
    problem.rotations.insert(problem.rotations.end(), {c, s, -s, c});
  }
  for (int v = 0; v < flat.rows(); ++v) {
    const double x = flat(v, 0), y = flat(v, 1), r = std::hypot(x - 0.5, y - 0.5);
    const bool boundary = std::min({x, y, 1 - x, 1 - y}) < 1e-9;
    if (!boundary && r > 0.15) continue;
    const double a = boundary ? 0.0 : degrees * std::acos(-1.0) / 180, c = std::cos(a), s = std::sin(a);
    problem.targets.push_back(
        {v, {0.5 + c * (x - 0.5) - s * (y - 0.5), 0.5 + s * (x - 0.5) + c * (y - 0.5)}});
  }
  return problem;
}

// A cube of 6 n^3 tets whose outside is held while a ball in the middle turns about the vertical.
inline sdp_penalty::Problem swirl_in_space(int n, double degrees) {
  const mesh::TetMesh cube = mesh::tet_bar(n, n, n);
  sdp_penalty::Problem problem;
  problem.elements = assembly::elements_from(mesh::elements(cube));
  problem.weights = sdp_penalty::volume_weights(problem.elements);
  const double most = degrees * std::acos(-1.0) / 180;
  const auto radius = [](double x, double y, double z) { return std::hypot(x - 0.5, y - 0.5, z - 0.5); };
  for (int e = 0; e < cube.tets.rows(); ++e) {
    double middle[3] = {0, 0, 0};
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 3; ++i) middle[i] += cube.vertices(cube.tets(e, k), i) / 4;
    const double a = most * std::clamp((0.5 - radius(middle[0], middle[1], middle[2])) / 0.35, 0.0, 1.0);
    const double c = std::cos(a), s = std::sin(a);
    problem.rotations.insert(problem.rotations.end(), {c, s, 0, -s, c, 0, 0, 0, 1});
  }
  for (int v = 0; v < cube.vertices.rows(); ++v) {
    const double x = cube.vertices(v, 0), y = cube.vertices(v, 1), z = cube.vertices(v, 2);
    const bool boundary = std::min({x, y, z, 1 - x, 1 - y, 1 - z}) < 1e-9;
    if (!boundary && radius(x, y, z) > 0.15) continue;
    const double a = boundary ? 0.0 : most, c = std::cos(a), s = std::sin(a);
    problem.targets.push_back(
        {v, {0.5 + c * (x - 0.5) - s * (y - 0.5), 0.5 + s * (x - 0.5) + c * (y - 0.5), z}});
  }
  return problem;
}

}  // namespace isostretch::tests
