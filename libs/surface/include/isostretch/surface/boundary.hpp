#pragma once

#include <isostretch/mesh/types.hpp>

#include <vector>

namespace isostretch::mesh {

/// Vertices of every boundary loop in the direction of the triangles' edges: the surface is on the left. A
/// loop starts at its smallest vertex; loops are ordered by it. Empty for a closed surface. Throws Error
/// naming a vertex or edge where the boundary branches (not manifold or not consistently oriented), or an
/// index out of range.
std::vector<std::vector<int>> boundary_loops(const SurfaceMesh& mesh);
std::vector<std::vector<int>> boundary_loops(const Triangles& triangles, int vertex_count);

/// Sum of the lengths of a loop's edges, the one back to its first vertex included.
double loop_length(const SurfaceMesh& mesh, const std::vector<int>& loop);

/// Of every vertex, the length of the shortest path along edges to the boundary of its component; infinite
/// where there is none. The mesh must be manifold and consistently oriented.
std::vector<double> distance_to_boundary(const SurfaceMesh& mesh);

/// Which of the loops is the longest; there must be one.
std::size_t longest_loop(const SurfaceMesh& mesh, const std::vector<std::vector<int>>& loops);

}  // namespace isostretch::mesh
