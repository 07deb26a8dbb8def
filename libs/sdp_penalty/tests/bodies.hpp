#pragma once

// A small bar of tetrahedra at rest, held at one end.
#include <isostretch/fem/element_arrays.hpp>
#include <isostretch/mesh/generators.hpp>
#include <isostretch/sdp_penalty/problem.hpp>

namespace isostretch::tests {

inline mesh::TetMesh small_bar() {
  return mesh::tet_bar(4, 2, 2, 2, 1, 1);
}

inline std::vector<double> position_of(const mesh::TetMesh& mesh, int v) {
  return {mesh.vertices(v, 0), mesh.vertices(v, 1), mesh.vertices(v, 2)};
}

inline sdp_penalty::Problem bar_at_rest() {
  const mesh::TetMesh bar = small_bar();
  sdp_penalty::Problem problem;
  problem.elements = assembly::elements_from(mesh::elements(bar));
  problem.weights = sdp_penalty::unit_weights(problem.elements);
  for (int e = 0; e < problem.element_count(); ++e)
    problem.rotations.insert(problem.rotations.end(), {1, 0, 0, 0, 1, 0, 0, 0, 1});
  for (int v = 0; v < bar.vertices.rows(); ++v)
    if (bar.vertices(v, 0) < 0.1) problem.targets.push_back({v, position_of(bar, v)});
  return problem;
}

// Held at one end, its other end pushed through to the other side.
inline sdp_penalty::Problem bar_pushed_through() {
  sdp_penalty::Problem problem = bar_at_rest();
  const mesh::TetMesh bar = small_bar();
  for (int v = 0; v < bar.vertices.rows(); ++v)
    if (bar.vertices(v, 0) > 1.9)
      problem.targets.push_back({v, {-1, bar.vertices(v, 1), bar.vertices(v, 2)}});
  return problem;
}

}  // namespace isostretch::tests
